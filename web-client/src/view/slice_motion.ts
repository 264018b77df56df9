// What a drag, a wheel or a key does to slices: parts of the scene's `slices`. Positions are patient
// space (LPS, mm), angles radians.
import type { VolumeSummary } from '../protocol/messages.ts';
import type { Point } from './camera.ts';
import { nearestMm } from './camera_motion.ts';
import {
  extentAlong,
  runsAlongAxis,
  sliceFrame,
  sliceNormal,
  voxelStepMm,
  type Directions,
  type SliceName,
  type SliceProjection,
  type Slices,
} from './slice_geometry.ts';
import { add, cross, dot, rotateAbout, scale, subtract, type Vector3 } from './vector.ts';

const FARTHEST_MM = 20_000;
/** Of the way to the next: that near a slice it is that one. */
const ON_SLICE = 1e-3;

const clamped = (value: number, minimum: number, maximum: number): number =>
  Math.min(maximum, Math.max(minimum, value));

/** The crosshair on the plane at `offset_mm` along the slice's normal, within the volume. */
export function scrolledTo(
  slices: Slices,
  name: SliceName,
  offset_mm: number,
  volume: VolumeSummary,
): Vector3 | undefined {
  const { crosshair_mm } = slices;
  if (!crosshair_mm) return undefined;
  const normal = sliceNormal(slices, name);
  const { minimum, maximum } = extentAlong(volume, normal);
  const by_mm = clamped(offset_mm, minimum, maximum) - dot(crosshair_mm, normal);
  return add(crosshair_mm, scale(normal, by_mm));
}

/**
 * The crosshair so many slices further: from one of the volume's own to the next, wherever between
 * two it was, so that what is shown is what was measured; on an oblique plane by a voxel's size.
 */
export function scrolledBy(
  slices: Slices,
  name: SliceName,
  steps: number,
  volume: VolumeSummary,
): Vector3 | undefined {
  const { crosshair_mm } = slices;
  if (!crosshair_mm) return undefined;
  const normal = sliceNormal(slices, name);
  const step_mm = voxelStepMm(volume, normal);
  const offset_mm = dot(crosshair_mm, normal);
  if (!runsAlongAxis(volume, normal))
    return scrolledTo(slices, name, offset_mm + steps * step_mm, volume);
  const { minimum } = extentAlong(volume, normal);
  const slice = (offset_mm - minimum) / step_mm;
  const from = steps > 0 ? Math.floor(slice + ON_SLICE) : Math.ceil(slice - ON_SLICE);
  return scrolledTo(slices, name, minimum + (from + steps) * step_mm, volume);
}

export interface SlicePart {
  readonly centre_mm: Vector3;
  readonly view_height_mm: number;
}

/** The picture moved by a distance: what was under the pointer stays under it. */
export function panned(
  { plane, mm_per_pixel, viewport }: SliceProjection,
  dx_px: number,
  dy_px: number,
): SlicePart {
  const shift_mm = add(
    scale(plane.right, -dx_px * mm_per_pixel),
    scale(plane.up, dy_px * mm_per_pixel),
  );
  return {
    centre_mm: add(plane.centre_mm, shift_mm),
    view_height_mm: viewport.height_px * mm_per_pixel,
  };
}

/** Larger by `magnification`; what is at `about_px` stays there. */
export function zoomed(
  projection: SliceProjection,
  magnification: number,
  about_px: Point,
  diagonal_mm = Infinity,
): SlicePart {
  const { plane, mm_per_pixel, viewport } = projection;
  const height_mm = mm_per_pixel * viewport.height_px;
  const nearest_mm = nearestMm(diagonal_mm);
  const view_height_mm = clamped(height_mm / magnification, nearest_mm, FARTHEST_MM);
  const about_mm = projection.toPatient(about_px);
  const arm_mm = subtract(plane.centre_mm, about_mm);
  return { centre_mm: add(about_mm, scale(arm_mm, view_height_mm / height_mm)), view_height_mm };
}

/**
 * The other two planes turned about this one's normal, by an angle that is counter-clockwise in its
 * picture.
 */
export function tilted(
  slices: Slices,
  { right, up }: Pick<SliceProjection['plane'], 'right' | 'up'>,
  angle_radians: number,
): { superior: Vector3; anterior: Vector3 } {
  const { superior, anterior } = sliceFrame(slices);
  const towards_viewer = cross(right, up);
  const turn = (direction: Vector3): Vector3 =>
    rotateAbout(direction, towards_viewer, angle_radians);
  return { superior: turn(superior), anterior: turn(anterior) };
}

const TILT_SEEN = 1e-4;

/** Whether the planes are not the patient's own. */
export function isTilted(directions: Directions): boolean {
  const { superior, anterior } = sliceFrame(directions);
  return superior[2] < 1 - TILT_SEEN || anterior[1] > TILT_SEEN - 1;
}
