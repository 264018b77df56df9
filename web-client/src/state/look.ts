// The part of a scene that says how the picture looks, as against what is shown, from where, and
// where the lens lies. While the volume stays, the material that a branch draws is part of it.
import type { Scene } from '../protocol/messages.ts';
import { layered, type JsonObject } from './merge_patch.ts';
import { sameScene } from './scene_diff.ts';
import { fieldsOf, fieldsUnder, onlyFields, withoutFields } from './scene_fields.ts';

const COMPARED = [...fieldsOf('look'), ...fieldsUnder('focus'), ...fieldsUnder('context')];

const lookOf = (scene: Scene): JsonObject => onlyFields(scene as JsonObject, COMPARED);

export const sameLook = (a: Scene, b: Scene): boolean => sameScene(lookOf(a), lookOf(b));

/** `scene` as it would look in the other's style. */
export const withLook = (scene: Scene, other: Scene): Scene =>
  layered(withoutFields(scene as JsonObject, COMPARED), lookOf(other));
