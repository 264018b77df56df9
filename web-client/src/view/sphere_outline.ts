// The outline of a sphere in the picture.
import { cameraAxes, projectPx, type Camera, type Point, type Viewport } from './camera.ts';
import { add, cross, length, normalize, scale, subtract, type Vector3 } from './vector.ts';

const POINTS = 72;

interface Circle {
  readonly centre_mm: Vector3;
  readonly radius_mm: number;
  readonly normal: Vector3;
}

/** Where the rays of sight touch the sphere; nothing when the eye is inside of it. */
function contourCircle(camera: Camera, centre_mm: Vector3, radius_mm: number): Circle | undefined {
  const { backward } = cameraAxes(camera);
  if (camera.projection === 'orthographic') return { centre_mm, radius_mm, normal: backward };
  const to_eye_mm = subtract(camera.eye_mm, centre_mm);
  const distance_mm = length(to_eye_mm);
  if (distance_mm <= radius_mm) return undefined;
  const sine = radius_mm / distance_mm;
  const normal = normalize(to_eye_mm);
  return {
    centre_mm: add(centre_mm, scale(normal, radius_mm * sine)),
    radius_mm: radius_mm * Math.sqrt(1 - sine * sine),
    normal,
  };
}

/**
 * Points of the outline, px, clockwise from the picture's right; nothing when part of it is behind
 * the eye.
 */
export function sphereOutlinePx(
  camera: Camera,
  viewport: Viewport,
  centre_mm: Vector3,
  radius_mm: number,
): Point[] | undefined {
  const circle = contourCircle(camera, centre_mm, radius_mm);
  if (!circle) return undefined;
  const horizontal = normalize(cross(cameraAxes(camera).up, circle.normal));
  const vertical = cross(circle.normal, horizontal);
  const points: Point[] = [];
  for (let index = 0; index < POINTS; index++) {
    const angle = (-2 * Math.PI * index) / POINTS;
    const on_circle_mm = add(
      scale(horizontal, circle.radius_mm * Math.cos(angle)),
      scale(vertical, circle.radius_mm * Math.sin(angle)),
    );
    const point_px = projectPx(camera, viewport, add(circle.centre_mm, on_circle_mm));
    if (!point_px) return undefined;
    points.push(point_px);
  }
  return points;
}
