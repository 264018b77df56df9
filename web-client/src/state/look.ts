// The part of a scene that says how things look, as against what is shown, from where, and where
// the lens lies.
import type { Scene } from '../protocol/messages.ts';
import type { Json, JsonObject } from './merge_patch.ts';
import { sameScene } from './scene_diff.ts';

const LOOK_FIELDS = ['focus', 'context', 'light', 'background'] as const;

/** The lens' fields that stay with the view. */
const LENS_PLACE = ['centre_mm', 'radius_mm'] as const;

function picked(fields: JsonObject, wanted: (field: string) => boolean): JsonObject {
  return Object.fromEntries(Object.entries(fields).filter(([field]) => wanted(field)));
}

const isPlace = (field: string): boolean => (LENS_PLACE as readonly string[]).includes(field);

function lookOf(scene: Scene): JsonObject {
  const fields = scene as JsonObject;
  const lens = (scene.lens ?? {}) as JsonObject;
  return {
    ...picked(fields, (field) => (LOOK_FIELDS as readonly string[]).includes(field)),
    lens: picked(lens, (field) => !isPlace(field)),
  };
}

export const sameLook = (a: Scene, b: Scene): boolean => sameScene(lookOf(a), lookOf(b));

/** `scene` as it would look in the other's style. */
export function withLook(scene: Scene, other: Scene): Scene {
  const place = picked((scene.lens ?? {}) as JsonObject, isPlace);
  const { lens, ...look } = lookOf(other) as { lens: JsonObject } & Record<string, Json>;
  const rest = picked(
    scene as JsonObject,
    (field) => !(LOOK_FIELDS as readonly string[]).includes(field),
  );
  return { ...rest, ...look, lens: { ...lens, ...place } };
}
