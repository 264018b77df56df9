// The lens' outline in the picture, and where a slice cuts it.
import { projectPx, type Camera, type Point, type Viewport } from './camera.ts';
import { convexHull } from './convex_hull.ts';
import type { LensBody } from './lens_body.ts';
import type { SliceProjection } from './slice_geometry.ts';
import { add, mix, scale, type Vector3 } from './vector.ts';

const SIDES_OF_ROUND = 72;

/** Corners about a body's axis at one height; unit radius. */
function ringOf(round: boolean): readonly Point[] {
  if (!round)
    return [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ];
  return Array.from({ length: SIDES_OF_ROUND }, (_, index): Point => {
    const angle = (2 * Math.PI * index) / SIDES_OF_ROUND;
    return [Math.cos(angle), Math.sin(angle)];
  });
}

/** Rings of points on the surface, from one end of its axis to the other; patient space, mm. */
function ringsMm({ centre_mm, half_edges_mm: [x, y, z], outline }: LensBody): Vector3[][] {
  const ring = ringOf(outline.round);
  return outline.profile.map(([radius, height]) =>
    ring.map(([across, up]) =>
      add(add(centre_mm, scale(z, height)), add(scale(x, radius * across), scale(y, radius * up))),
    ),
  );
}

/** Corners in order, px; nothing when part of it is behind the eye. */
export function lensOutlinePx(
  camera: Camera,
  viewport: Viewport,
  body: LensBody,
): Point[] | undefined {
  const points: Point[] = [];
  for (const point_mm of ringsMm(body).flat()) {
    const point_px = projectPx(camera, viewport, point_mm);
    if (!point_px) return undefined;
    points.push(point_px);
  }
  return convexHull(points);
}

/** Pairs of neighbours on the surface. */
function edgesMm(body: LensBody): [Vector3, Vector3][] {
  const rings = ringsMm(body);
  return rings.flatMap((ring, height) =>
    ring.flatMap((point, index): [Vector3, Vector3][] => {
      const beside = ring[(index + 1) % ring.length];
      const above = rings[height + 1]?.[index];
      return [beside, above].flatMap((other) => (other ? [[point, other]] : []));
    }),
  );
}

/** Corners in order, px; nothing where the plane misses it. */
export function lensCutPx(view: SliceProjection, body: LensBody): Point[] | undefined {
  const points = edgesMm(body).flatMap(([from_mm, to_mm]) => {
    const [from, to] = [view.distanceMm(from_mm), view.distanceMm(to_mm)];
    if (from > 0 === to > 0) return [];
    return [view.toPicture(mix(from_mm, to_mm, from / (from - to)))];
  });
  return points.length > 2 ? convexHull(points) : undefined;
}

/** The corner that lies farthest in a direction of the picture. */
export function farthest(outline_px: readonly Point[], [x, y]: Point): Point {
  const reach = (point: Point): number => point[0] * x + point[1] * y;
  return outline_px.reduce((most, point) => (reach(point) > reach(most) ? point : most));
}

/** As SVG's polygon wants them. */
export const cornersOf = (points: readonly Point[]): string =>
  points.map((point) => point.map((part) => part.toFixed(1)).join(',')).join(' ');
