// How a camera maps patient space (LPS, mm) to a viewport (px); the counterpart of
// server/scene/view_geometry.h.
import { add, cross, dot, normalize, scale, subtract, type Vector3 } from './vector.ts';

export interface PerspectiveCamera {
  readonly projection: 'perspective';
  readonly vertical_fov_degrees: number;
}

export interface OrthographicCamera {
  readonly projection: 'orthographic';
  /** What the viewport's height spans. */
  readonly view_height_mm: number;
}

/** The picture's right is direction x up. */
export type Camera = (PerspectiveCamera | OrthographicCamera) & {
  readonly eye_mm: Vector3;
  readonly target_mm: Vector3;
  readonly up: Vector3;
};

export interface Viewport {
  readonly width_px: number;
  readonly height_px: number;
}

export type Point = readonly [number, number];

/** Orthonormal, in patient space: right x up = backward, towards the viewer. */
export interface CameraAxes {
  readonly right: Vector3;
  readonly up: Vector3;
  readonly backward: Vector3;
}

export function cameraAxes(camera: Camera): CameraAxes {
  const backward = normalize(subtract(camera.eye_mm, camera.target_mm));
  const right = normalize(cross(camera.up, backward));
  return { right, up: cross(backward, right), backward };
}

/** Height of what the viewport shows at a depth in front of the eye. */
function viewHeightMm(camera: Camera, depth_mm: number): number {
  if (camera.projection === 'orthographic') return camera.view_height_mm;
  return 2 * depth_mm * Math.tan((camera.vertical_fov_degrees * Math.PI) / 360);
}

function depthMm(camera: Camera, axes: CameraAxes, point_mm: Vector3): number {
  return dot(subtract(camera.eye_mm, point_mm), axes.backward);
}

/** Where a patient point appears; nothing where it is not in front of the eye. */
export function projectPx(
  camera: Camera,
  viewport: Viewport,
  point_mm: Vector3,
): Point | undefined {
  const axes = cameraAxes(camera);
  const depth_mm = depthMm(camera, axes, point_mm);
  if (depth_mm <= 0) return undefined;
  const pixels_per_mm = viewport.height_px / viewHeightMm(camera, depth_mm);
  const offset_mm = subtract(point_mm, camera.eye_mm);
  return [
    viewport.width_px / 2 + dot(offset_mm, axes.right) * pixels_per_mm,
    viewport.height_px / 2 - dot(offset_mm, axes.up) * pixels_per_mm,
  ];
}

export interface ViewRay {
  readonly origin_mm: Vector3;
  /** Unit length. */
  readonly direction: Vector3;
}

/**
 * The ray through a point of the viewport, whose (0, 0) is the upper left corner of the upper left
 * pixel.
 */
export function rayThrough(camera: Camera, viewport: Viewport, position_px: Point): ViewRay {
  const { right, up, backward } = cameraAxes(camera);
  const mm_per_pixel = viewHeightMm(camera, 1) / viewport.height_px;
  const x_mm = (position_px[0] - viewport.width_px / 2) * mm_per_pixel;
  const y_mm = (viewport.height_px / 2 - position_px[1]) * mm_per_pixel;
  const offset_mm = add(scale(right, x_mm), scale(up, y_mm));
  if (camera.projection === 'orthographic') {
    return { origin_mm: add(camera.eye_mm, offset_mm), direction: scale(backward, -1) };
  }
  return { origin_mm: camera.eye_mm, direction: normalize(subtract(offset_mm, backward)) };
}

/** Height of one pixel in mm at the depth of a patient point. */
export function pixelSizeMm(camera: Camera, viewport: Viewport, point_mm: Vector3): number {
  const depth_mm = Math.abs(depthMm(camera, cameraAxes(camera), point_mm));
  return viewHeightMm(camera, depth_mm) / viewport.height_px;
}
