// The measurements of one volume as a list; every change is a new list.
import {
  isSamePoint,
  POINT_COUNTS,
  type MeasuredPoint,
  type Measurement,
  type MeasurementKind,
} from '../view/measurement.ts';

export type MeasurementList = readonly Measurement[];

export const LONGEST_NAME = 80;

/** `title` and the smallest number that no name of the list has: 'Distance 2'. */
export function freeName(title: string, list: MeasurementList): string {
  const taken = new Set(list.map(({ name }) => name));
  let number = 1;
  while (taken.has(`${title} ${number}`)) number += 1;
  return `${title} ${number}`;
}

/** An empty name leaves the old one. */
export function renamed(list: MeasurementList, id: number, name: string): MeasurementList {
  const clean = name.trim().slice(0, LONGEST_NAME);
  if (!clean) return list;
  return list.map((one) => (one.id === id ? { ...one, name: clean } : one));
}

export const without = (list: MeasurementList, id: number): MeasurementList =>
  list.filter((one) => one.id !== id);

/** With those again that were deleted from `before`, in the order of then. */
export function withReturned(list: MeasurementList, before: MeasurementList): MeasurementList {
  const now = new Map(list.map((one) => [one.id, one]));
  const of_then = new Set(before.map(({ id }) => id));
  const added = list.filter(({ id }) => !of_then.has(id));
  return [...before.map((one) => now.get(one.id) ?? one), ...added];
}

/** What two measurements of the same name, kind and points have in common. */
const contentOf = ({ kind, name, points }: Omit<Measurement, 'id'>): string =>
  JSON.stringify([kind, name, points.map(({ position_mm, value }) => [position_mm, value])]);

/** With the ids that the known ones have; the others get new ones. Where all are known, that list. */
export function identified(
  list: readonly Omit<Measurement, 'id'>[],
  known: MeasurementList,
  nextId: () => number,
): MeasurementList {
  const left = new Map(known.map((one) => [contentOf(one), one]));
  const all = list.map((one) => {
    const same = left.get(contentOf(one));
    left.delete(contentOf(one));
    return same ?? { ...one, id: nextId() };
  });
  const is_known = all.length === known.length && all.every((one, index) => one === known[index]);
  return is_known ? known : all;
}

/** A point that would fall on another of the same measurement stays where it is. */
export function withPoint(
  list: MeasurementList,
  id: number,
  index: number,
  point: MeasuredPoint,
): MeasurementList {
  return list.map((one) => {
    if (one.id !== id || !one.points[index]) return one;
    const others = one.points.toSpliced(index, 1);
    if (others.some((other) => isSamePoint(other, point))) return one;
    return { ...one, points: one.points.with(index, point) };
  });
}

/** Points of a measurement that is not whole yet. */
export interface Draft {
  readonly kind: MeasurementKind;
  readonly points: readonly MeasuredPoint[];
}

/** One point more; a point on another of the draft's changes nothing. */
export function extended(draft: Draft, point: MeasuredPoint): Draft {
  if (draft.points.some((other) => isSamePoint(other, point))) return draft;
  return { ...draft, points: [...draft.points, point] };
}

export const isWhole = ({ kind, points }: Draft): boolean => points.length >= POINT_COUNTS[kind];
