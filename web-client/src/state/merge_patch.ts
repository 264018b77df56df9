// How a partial scene changes a scene: RFC 7396, with the one addition of protocol/README.md that a
// module (an object with a name) of another name replaces the old one whole.

export type Json = null | boolean | number | string | readonly Json[] | JsonObject;
export interface JsonObject {
  readonly [key: string]: Json;
}

export function isObject(value: unknown): value is JsonObject {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isOtherModule(base: JsonObject, patch: JsonObject): boolean {
  return 'name' in patch && patch['name'] !== base['name'];
}

/** A patch laid over nothing: nulls within it stand for nothing. */
function withoutNulls(value: Json): Json {
  return isObject(value) ? mergePatch({}, value) : value;
}

export function mergePatch(base: JsonObject, patch: JsonObject): JsonObject {
  const merged: Record<string, Json> = { ...base };
  for (const [key, value] of Object.entries(patch)) {
    const old = merged[key];
    if (value === null) delete merged[key];
    else if (isObject(value) && isObject(old) && !isOtherModule(old, value))
      merged[key] = mergePatch(old, value);
    else merged[key] = withoutNulls(value);
  }
  return merged;
}

export function holdsNull(patch: JsonObject): boolean {
  return Object.values(patch).some(
    (value) => value === null || (isObject(value) && holdsNull(value)),
  );
}

export function textOf(value: Json | undefined, fallback = ''): string {
  return typeof value === 'string' ? value : fallback;
}

/** The patch that sets one place: nested(['lens', 'radius_mm'], 40) is {lens: {radius_mm: 40}}. */
export function nestedPatch(path: readonly string[], value: Json): JsonObject {
  const [first, ...rest] = path;
  if (first === undefined) throw new Error('a patch needs a path');
  return { [first]: rest.length === 0 ? value : nestedPatch(rest, value) };
}

export function valueAt(document: Json | undefined, path: readonly string[]): Json | undefined {
  let place: Json | undefined = document;
  for (const key of path) place = isObject(place) ? place[key] : undefined;
  return place;
}

/** Both patches, `above` where they disagree. */
export function layered(below: JsonObject, above: JsonObject): JsonObject {
  const both = Object.entries(above).map(([key, value]): [string, Json] => {
    const under = below[key];
    return [key, isObject(under) && isObject(value) ? layered(under, value) : value];
  });
  return { ...below, ...Object.fromEntries(both) };
}

/** Those fields of an object that are wanted; none where it is no object. */
export function pick(from: Json | undefined, fields: readonly string[]): JsonObject {
  const object = isObject(from) ? from : {};
  return Object.fromEntries(Object.entries(object).filter(([key]) => fields.includes(key)));
}

/** All of its fields but those. */
export function omit(from: Json | undefined, fields: readonly string[]): JsonObject {
  const object = isObject(from) ? from : {};
  return Object.fromEntries(Object.entries(object).filter(([key]) => !fields.includes(key)));
}
