// The part of a scene that says how things look, as against what is shown, from where, and where
// the lens lies.
import type { Scene } from '../protocol/messages.ts';
import { omit, pick, type Json, type JsonObject } from './merge_patch.ts';
import { sameScene } from './scene_diff.ts';

const LOOK_FIELDS = ['focus', 'context', 'light', 'background'] as const;

/** The lens' fields that stay with the view. */
const LENS_PLACE = ['centre_mm', 'radius_mm'] as const;

function lookOf(scene: Scene): JsonObject {
  const fields = scene as JsonObject;
  return { ...pick(fields, LOOK_FIELDS), lens: omit(fields['lens'], LENS_PLACE) };
}

export const sameLook = (a: Scene, b: Scene): boolean => sameScene(lookOf(a), lookOf(b));

/** `scene` as it would look in the other's style. */
export function withLook(scene: Scene, other: Scene): Scene {
  const fields = scene as JsonObject;
  const { lens, ...look } = lookOf(other) as { lens: JsonObject } & Record<string, Json>;
  return {
    ...omit(fields, LOOK_FIELDS),
    ...look,
    lens: { ...lens, ...pick(fields['lens'], LENS_PLACE) },
  };
}
