// The user's own styles: named looks, as the server's styles are (how things look, never which
// volume, from where, or where it is cut).
import { SCENE_VERSION, type Scene, type Style } from '../protocol/messages.ts';
import type { JsonObject } from './merge_patch.ts';
import { fieldsOf, onlyFields } from './scene_fields.ts';

export interface OwnStyle {
  /** Unique among the user's own. */
  readonly title: string;
  /** A scene document with nothing in it but the look. */
  readonly scene: Scene;
}

export const LONGEST_TITLE = 80;
const LOOK = fieldsOf('look');

/** What of a scene is its look; an empty object where it says nothing of one. */
export const lookOf = (scene: JsonObject): JsonObject => onlyFields(scene, LOOK);

export function ownStyle(title: string, scene: JsonObject): OwnStyle {
  return { title: cleanTitle(title), scene: { version: SCENE_VERSION, ...lookOf(scene) } };
}

export const cleanTitle = (title: string): string =>
  title.replaceAll(/\s+/g, ' ').trim().slice(0, LONGEST_TITLE);

/** As a style of the server's, for what draws and applies those. */
export const asStyle = ({ title, scene }: OwnStyle): Style => ({
  name: title,
  title,
  description: '',
  scene,
});

/** Where its picture is kept: one that is renamed keeps it, one that is replaced does not. */
export const pictureKey = ({ scene }: OwnStyle): string => `own ${JSON.stringify(scene)}`;

/** The title, or the first of 'title 2', 'title 3' that none of the styles has. */
export function freeTitle(title: string, styles: readonly OwnStyle[]): string {
  const taken = new Set(styles.map((style) => style.title));
  let free = title;
  for (let number = 2; taken.has(free); number++)
    free = `${title.slice(0, LONGEST_TITLE - 5)} ${number}`;
  return free;
}

/** In place of the one of the same title, or at the end. */
export function withStyle(styles: readonly OwnStyle[], style: OwnStyle): readonly OwnStyle[] {
  const index = styles.findIndex(({ title }) => title === style.title);
  return index < 0 ? [...styles, style] : styles.with(index, style);
}

export const withoutStyle = (styles: readonly OwnStyle[], title: string): readonly OwnStyle[] =>
  styles.filter((style) => style.title !== title);

/** An empty title leaves the old one; one that another has gets a number. */
export function retitled(
  styles: readonly OwnStyle[],
  title: string,
  wanted: string,
): readonly OwnStyle[] {
  const clean = cleanTitle(wanted);
  if (!clean || clean === title) return styles;
  const free = freeTitle(clean, withoutStyle(styles, title));
  return styles.map((style) => (style.title === title ? { ...style, title: free } : style));
}
