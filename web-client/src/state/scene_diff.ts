// What must change for one scene to become another, as a partial scene.
import { isObject, type Json, type JsonObject } from './merge_patch.ts';

function same(a: Json | undefined, b: Json | undefined): boolean {
  if (isObject(a) && isObject(b)) return Object.keys(scenePatch(a, b)).length === 0;
  if (Array.isArray(a) && Array.isArray(b)) {
    const [left, right] = [a as readonly Json[], b as readonly Json[]];
    return left.length === right.length && left.every((item, index) => same(item, right[index]));
  }
  return a === b;
}

/** Values that become others whole: of a module, only one of the same name is changed in part. */
const replaced = (from: Json | undefined, to: Json): boolean =>
  !isObject(from) || !isObject(to) || from['name'] !== to['name'];

/**
 * mergePatch(from, scenePatch(from, to)) is `to`. Empty where they are the same; null where `to`
 * does not have a field.
 */
export function scenePatch(from: JsonObject, to: JsonObject): JsonObject {
  const patch: Record<string, Json> = {};
  for (const key of Object.keys(from)) if (!(key in to)) patch[key] = null;
  for (const [key, value] of Object.entries(to)) {
    const old = from[key];
    if (same(old, value)) continue;
    patch[key] = replaced(old, value) ? value : scenePatch(old as JsonObject, value as JsonObject);
  }
  return patch;
}

export const sameScene = (a: JsonObject, b: JsonObject): boolean => same(a, b);
