// A branch's filters as a list that can be added to, reordered and shortened.
import { SCENE_FIELDS, type ModuleDescription, type Scene } from '../protocol/messages.ts';
import { readable } from './controls.ts';
import { textOf, type Json, type JsonObject } from './merge_patch.ts';
import { controlLevels, NO_CONTROLS, type ControlLevels } from './module_model.ts';

export type BranchName = 'focus' | 'context';

export interface FilterModel {
  readonly name: string;
  readonly title: string;
  readonly description: string;
  readonly controls: ControlLevels;
  readonly removed: JsonObject;
  /** Nothing at the end of the list. */
  readonly earlier: JsonObject | undefined;
  readonly later: JsonObject | undefined;
}

export interface FilterListModel {
  readonly filters: readonly FilterModel[];
  /** What is not there yet, for a branch runs each filter once; empty where the list is full. */
  readonly additions: readonly {
    readonly title: string;
    readonly description: string;
    readonly patch: JsonObject;
  }[];
}

const moved = (list: readonly JsonObject[], from: number, to: number): JsonObject[] | undefined => {
  const item = list[from];
  if (item === undefined || to < 0 || to >= list.length) return undefined;
  return list.toSpliced(from, 1).toSpliced(to, 0, item);
};

/** A branch's filters; arrays are replaced whole, so every change is a new list. */
export function filterListModel(
  branch: BranchName,
  registry: readonly ModuleDescription[],
  scene: Scene,
): FilterListModel {
  const list = (scene[branch]?.filters ?? []) as readonly JsonObject[];
  const patch = (filters: readonly JsonObject[]): JsonObject => ({
    [branch]: { filters: [...filters] },
  });
  const optional = (filters: JsonObject[] | undefined): JsonObject | undefined =>
    filters && patch(filters);
  const filterModel = (filter: JsonObject, index: number): FilterModel => {
    const name = textOf(filter['name']);
    const entry = registry.find((candidate) => candidate.name === name);
    const toPatch = (parameter: string, value: Json): JsonObject =>
      patch(list.with(index, { ...filter, [parameter]: value }));
    return {
      name,
      title: entry?.title ?? readable(name),
      description: entry?.description ?? '',
      controls: entry
        ? controlLevels(entry, filter, toPatch, `${branch}-filter-${index}`)
        : NO_CONTROLS,
      removed: patch(list.toSpliced(index, 1)),
      earlier: optional(moved(list, index, index - 1)),
      later: optional(moved(list, index, index + 1)),
    };
  };
  const full = list.length >= SCENE_FIELDS.filters.maximum;
  const addition = ({ name, title, description }: ModuleDescription) => ({
    title,
    description,
    patch: patch([...list, { name }]),
  });
  const missing = registry.filter(({ name }) => list.every((filter) => filter['name'] !== name));
  return { filters: list.map(filterModel), additions: full ? [] : missing.map(addition) };
}
