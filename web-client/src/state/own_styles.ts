// The user's own styles: named looks, as the server's styles are (how things look, never which
// volume, from where, or where it is cut).
import type { Scene, Style } from '../protocol/messages.ts';
import { isObject, pick, type Json, type JsonObject } from './merge_patch.ts';

export interface OwnStyle {
  /** Unique among the user's own. */
  readonly title: string;
  /** A scene document with nothing in it but the look. */
  readonly scene: Scene;
}

export const LONGEST_TITLE = 80;
const SCENE_VERSION = 1;

const BRANCH_FIELDS = ['shading', 'filters'];
/** The ends of a band belong to a volume, its opacity to the look. */
const SURFACE_FIELDS = ['opacity'];
const LENS_FIELDS = ['mode', 'cap', 'strength', 'softness', 'strict'];
const PARTS_TAKEN_WHOLE = ['light', 'background'];

function branchLook(branch: Json | undefined): JsonObject {
  const surface = pick(isObject(branch) ? branch['surface'] : undefined, SURFACE_FIELDS);
  return { ...pick(branch, BRANCH_FIELDS), ...(Object.keys(surface).length > 0 && { surface }) };
}

/** What of a scene is its look; an empty object where it says nothing of one. */
export function lookOf(scene: JsonObject): JsonObject {
  const parts: [string, JsonObject][] = [
    ['focus', branchLook(scene['focus'])],
    ['context', branchLook(scene['context'])],
    ['lens', pick(scene['lens'], LENS_FIELDS)],
  ];
  const said = parts.filter(([, part]) => Object.keys(part).length > 0);
  return { ...Object.fromEntries(said), ...pick(scene, PARTS_TAKEN_WHOLE) };
}

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
