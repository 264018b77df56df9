// What the schema says of the scene's fields: which belong to the look, to the volume, to the view.
import { SCENE_PATHS } from '../protocol/messages.ts';
import {
  isObject,
  layered,
  nestedPatch,
  valueAt,
  type Json,
  type JsonObject,
} from './merge_patch.ts';

type Path = readonly string[];
type BelongsTo = (typeof SCENE_PATHS)[number]['belongs_to'];

const ALL: readonly { path: Path; belongs_to: BelongsTo; optional: boolean }[] = SCENE_PATHS;

const pathsOf = (wanted: (field: (typeof ALL)[number]) => boolean): readonly Path[] =>
  ALL.filter(wanted).map(({ path }) => path);

export const fieldsOf = (...parts: readonly BelongsTo[]): readonly Path[] =>
  pathsOf(({ belongs_to }) => parts.includes(belongs_to));

/** Those of one part of the scene: 'lens', 'focus'. */
export const fieldsUnder = (part: string): readonly Path[] =>
  pathsOf(({ path }) => path[0] === part);

/** Left out they are not there at all, and nobody chooses them. */
export const OPTIONAL_FIELDS = pathsOf(({ optional }) => optional);

/** What a document says of those fields. */
export function onlyFields(document: JsonObject, paths: readonly Path[]): JsonObject {
  return paths.reduce((said: JsonObject, path) => {
    const value = valueAt(document, path);
    return value === undefined ? said : layered(said, nestedPatch(path, value));
  }, {});
}

/** A part of which nothing is left goes with it. */
export function withoutFields(document: JsonObject, paths: readonly Path[]): JsonObject {
  const kept = Object.entries(document).flatMap(([key, value]): [string, Json][] => {
    const inner = paths.filter(([first]) => first === key).map((path) => path.slice(1));
    if (inner.length === 0) return [[key, value]];
    if (!isObject(value) || inner.some(({ length }) => length === 0)) return [];
    const left = withoutFields(value, inner);
    return Object.keys(left).length > 0 ? [[key, left]] : [];
  });
  return Object.fromEntries(kept);
}

/** A patch that leaves all of them to the server. */
export const leftOpen = (paths: readonly Path[]): JsonObject =>
  paths.reduce((patch: JsonObject, path) => layered(patch, nestedPatch(path, null)), {});
