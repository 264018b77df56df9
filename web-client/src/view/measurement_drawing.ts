// A measurement as lines of a view's picture, device pixels.
import type { MeasurementKind } from './measurement.ts';
import type { Point } from './camera.ts';
import {
  add,
  cross,
  length,
  normalize,
  rotateAbout,
  scale,
  subtract,
  type Vector3,
} from './vector.ts';
import type { ViewProjection } from './view_projection.ts';

export type Polyline = readonly Point[];

export type LabelSide = 'above' | 'beside' | 'on';

export interface MeasurementDrawing {
  readonly lines: readonly Polyline[];
  /** By point; nothing where the view cannot show it. */
  readonly points_px: readonly (Point | undefined)[];
  readonly label_px: Point | undefined;
  /** Where the label lies from there, so that it hides no line. */
  readonly label_side: LabelSide;
}

const ARC_SHARE = 0.35;
const ARC_PIECES = 24;
/** The label lies beyond the arc. */
const LABEL_REACH = 1.7;

const middle = ([a, b]: readonly [Point, Point]): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];

/** In the plane of both legs, from one to the other; nothing for legs on one line. */
function arcMm(from: Vector3, vertex: Vector3, to: Vector3): readonly Vector3[] {
  const [a, b] = [subtract(from, vertex), subtract(to, vertex)];
  const normal = cross(a, b);
  const doubled_area = length(normal);
  if (doubled_area <= 1e-6 * length(a) * length(b)) return [];
  const angle = Math.atan2(doubled_area, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  const start = scale(normalize(a), ARC_SHARE * Math.min(length(a), length(b)));
  return Array.from({ length: ARC_PIECES + 1 }, (_, piece) =>
    add(vertex, rotateAbout(start, normalize(normal), (angle * piece) / ARC_PIECES)),
  );
}

const isSteep = ([a, b]: readonly [Point, Point]): boolean =>
  Math.abs(b[1] - a[1]) > Math.abs(b[0] - a[0]);

function beyond(from: Point | undefined, to: Point | undefined): Point | undefined {
  if (!from || !to) return undefined;
  return [from[0] + (to[0] - from[0]) * LABEL_REACH, from[1] + (to[1] - from[1]) * LABEL_REACH];
}

const isPoint = (point: Point | undefined): point is Point => point !== undefined;

/** `points_mm` may be fewer than the kind has: what is there is drawn. */
export function drawMeasurement(
  kind: MeasurementKind,
  points_mm: readonly Vector3[],
  view: ViewProjection,
): MeasurementDrawing {
  const points_px = points_mm.map((point_mm) => view.toPicture(point_mm));
  const legs = points_mm.slice(1).flatMap((point_mm, index) => {
    const line = view.lineToPicture(points_mm[index] ?? point_mm, point_mm);
    return line ? [line] : [];
  });
  const [first, vertex, last] = points_mm;
  if (kind === 'angle' && first && vertex && last) {
    const arc = arcMm(first, vertex, last).map((point_mm) => view.toPicture(point_mm));
    const lines = arc.length > 0 && arc.every(isPoint) ? [...legs, arc] : legs;
    const [vertex_px, middle_px] = [points_px[1], arc[ARC_PIECES / 2]];
    const label_px = beyond(vertex_px, middle_px) ?? vertex_px;
    return { lines, points_px, label_px, label_side: 'on' };
  }
  const [leg] = legs;
  const label_px = leg ? middle(leg) : points_px[0];
  return { lines: legs, points_px, label_px, label_side: leg && isSteep(leg) ? 'beside' : 'above' };
}
