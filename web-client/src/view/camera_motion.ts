// What a drag, a wheel or a key does to a camera. Every function gives a new camera; distances are
// mm, angles radians.
import { cameraAxes, pixelSizeMm, type Camera, type Viewport } from './camera.ts';
import { add, length, rotateAbout, scale, subtract, type Vector3 } from './vector.ts';

/** A drag over the shorter side of the viewport turns the volume half around. */
const TURN_PER_SHORT_SIDE_RADIANS = Math.PI;
const NEAREST_MM = 1;
/** Of the volume's diagonal: what is a few micrometres across wants to be seen as near. */
const NEAREST_SHARE = 0.005;
const FARTHEST_MM = 20_000;

/**
 * Turns the eye about the target: `right_radians` about the picture's vertical, `up_radians` about
 * its horizontal, so that positive angles carry the front of the volume to the right and up. `up`
 * turns along, which leaves no pole.
 */
export function orbit(camera: Camera, right_radians: number, up_radians: number): Camera {
  const { right, up } = cameraAxes(camera);
  const turn = (vector: Vector3): Vector3 =>
    rotateAbout(rotateAbout(vector, right, up_radians), up, -right_radians);
  const arm_mm = turn(subtract(camera.eye_mm, camera.target_mm));
  return { ...camera, eye_mm: add(camera.target_mm, arm_mm), up: turn(up) };
}

export function orbitByPixels(
  camera: Camera,
  viewport: Viewport,
  dx_px: number,
  dy_px: number,
): Camera {
  const short_side_px = Math.max(1, Math.min(viewport.width_px, viewport.height_px));
  const radians_per_px = TURN_PER_SHORT_SIDE_RADIANS / short_side_px;
  return orbit(camera, dx_px * radians_per_px, -dy_px * radians_per_px);
}

/** Turns the picture about its centre; positive is clockwise. */
export function roll(camera: Camera, angle_radians: number): Camera {
  const { up, backward } = cameraAxes(camera);
  return { ...camera, up: rotateAbout(up, backward, angle_radians) };
}

/** Moves the picture so that what lies at the target's depth follows the pointer. */
export function panByPixels(
  camera: Camera,
  viewport: Viewport,
  dx_px: number,
  dy_px: number,
): Camera {
  const { right, up } = cameraAxes(camera);
  const mm_per_px = pixelSizeMm(camera, viewport, camera.target_mm);
  const shift_mm = add(scale(right, -dx_px * mm_per_px), scale(up, dy_px * mm_per_px));
  return {
    ...camera,
    eye_mm: add(camera.eye_mm, shift_mm),
    target_mm: add(camera.target_mm, shift_mm),
  };
}

/** How near one may come to what lies within a volume of that diagonal. */
export const nearestMm = (diagonal_mm: number): number =>
  Math.min(NEAREST_MM, NEAREST_SHARE * diagonal_mm);

/** Less than any picture shows: what rounding makes of a distance at its limit. */
const isSame = (a_mm: number, b_mm: number): boolean => Math.abs(a_mm - b_mm) < 1e-9 * b_mm;

/** `magnification` above 1 makes the volume larger in the picture. At the limit, the same camera. */
export function zoom(camera: Camera, magnification: number, diagonal_mm = Infinity): Camera {
  const clampDistance = (distance_mm: number): number =>
    Math.min(FARTHEST_MM, Math.max(nearestMm(diagonal_mm), distance_mm));
  if (camera.projection === 'orthographic') {
    const view_height_mm = clampDistance(camera.view_height_mm / magnification);
    return isSame(view_height_mm, camera.view_height_mm) ? camera : { ...camera, view_height_mm };
  }
  const arm_mm = subtract(camera.eye_mm, camera.target_mm);
  const distance_mm = length(arm_mm);
  const wanted_mm = clampDistance(distance_mm / magnification);
  if (isSame(wanted_mm, distance_mm)) return camera;
  const arm_scale = wanted_mm / distance_mm;
  return { ...camera, eye_mm: add(camera.target_mm, scale(arm_mm, arm_scale)) };
}

/** Looks at the same target from the same distance along a standard direction. */
export function lookFrom(camera: Camera, towards_eye: Vector3, up: Vector3): Camera {
  const distance_mm = length(subtract(camera.eye_mm, camera.target_mm));
  return { ...camera, eye_mm: add(camera.target_mm, scale(towards_eye, distance_mm)), up };
}

/** The other projection, with the same height of view at the target. */
export function withProjection(
  camera: Camera,
  projection: Camera['projection'],
  fov_degrees: number,
): Camera {
  if (projection === camera.projection) return camera;
  const { eye_mm, target_mm, up } = camera;
  const arm_mm = subtract(eye_mm, target_mm);
  if (camera.projection === 'perspective') {
    const view_height_mm =
      2 * length(arm_mm) * Math.tan((camera.vertical_fov_degrees * Math.PI) / 360);
    return { projection: 'orthographic', view_height_mm, eye_mm, target_mm, up };
  }
  const distance_mm = camera.view_height_mm / (2 * Math.tan((fov_degrees * Math.PI) / 360));
  const farther_eye_mm = add(target_mm, scale(arm_mm, distance_mm / length(arm_mm)));
  return {
    projection: 'perspective',
    vertical_fov_degrees: fov_degrees,
    eye_mm: farther_eye_mm,
    target_mm,
    up,
  };
}
