// The lens' sphere where a slice cuts it.
import type { Point } from './camera.ts';
import type { SliceProjection } from './slice_geometry.ts';
import type { Vector3 } from './vector.ts';

export interface CutLens {
  readonly centre_px: Point;
  readonly radius_px: number;
}

/** Nothing where the plane misses the sphere. */
export function cutLens(
  view: SliceProjection,
  centre_mm: Vector3,
  radius_mm: number,
): CutLens | undefined {
  const distance_mm = view.distanceMm(centre_mm);
  if (Math.abs(distance_mm) >= radius_mm) return undefined;
  const cut_mm = Math.sqrt(radius_mm ** 2 - distance_mm ** 2);
  return { centre_px: view.toPicture(centre_mm), radius_px: cut_mm / view.mm_per_pixel };
}

/** The sphere's radius where its cut is to be that large, mm. */
export function radiusOfCut(view: SliceProjection, centre_mm: Vector3, cut_px: number): number {
  return Math.hypot(cut_px * view.mm_per_pixel, view.distanceMm(centre_mm));
}
