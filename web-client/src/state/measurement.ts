// What a user has measured: named points of the patient, and what follows from them. Points are
// patient space (LPS, mm), so that every view of the patient can draw them.
import { dot, length, subtract, type Vector3 } from '../view/vector.ts';

export const MEASUREMENT_KINDS = ['distance', 'angle', 'probe'] as const;
export type MeasurementKind = (typeof MEASUREMENT_KINDS)[number];

/** How many points each kind has. The second of an angle is its vertex. */
export const POINT_COUNTS: Readonly<Record<MeasurementKind, number>> = {
  distance: 2,
  angle: 3,
  probe: 1,
};

export interface MeasuredPoint {
  readonly position_mm: Vector3;
  /** Of the volume there, in its own units. */
  readonly value: number;
}

export interface Measurement {
  /** Unique on the page. */
  readonly id: number;
  readonly kind: MeasurementKind;
  readonly name: string;
  readonly points: readonly MeasuredPoint[];
}

/** 'mm', 'degrees', or what the volume's values are measured in. */
export type MeasurementUnit = string;

export interface MeasurementResult {
  readonly value: number;
  readonly unit: MeasurementUnit;
}

/** Nearer ones are the same point: a double click is no distance. */
const SMALLEST_DISTANCE_MM = 0.01;

export const distanceMm = (a: Vector3, b: Vector3): number => length(subtract(a, b));

export const isSamePoint = (a: MeasuredPoint, b: MeasuredPoint): boolean =>
  distanceMm(a.position_mm, b.position_mm) < SMALLEST_DISTANCE_MM;

/** At `vertex`, 0..180; nothing where a leg has no length. */
export function angleDegrees(from: Vector3, vertex: Vector3, to: Vector3): number | undefined {
  const [a, b] = [subtract(from, vertex), subtract(to, vertex)];
  const lengths = length(a) * length(b);
  if (lengths === 0) return undefined;
  const cosine = Math.min(1, Math.max(-1, dot(a, b) / lengths));
  return (Math.acos(cosine) * 180) / Math.PI;
}

/** Nothing while points are missing. `units` are the volume's. */
export function resultOf(
  { kind, points }: Pick<Measurement, 'kind' | 'points'>,
  units: string,
): MeasurementResult | undefined {
  const [first, second, third] = points;
  if (kind === 'probe') return first && { value: first.value, unit: units };
  if (!first || !second) return undefined;
  if (kind === 'distance')
    return { value: distanceMm(first.position_mm, second.position_mm), unit: 'mm' };
  const angle = third && angleDegrees(first.position_mm, second.position_mm, third.position_mm);
  return angle === undefined ? undefined : { value: angle, unit: 'degrees' };
}
