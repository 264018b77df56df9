// What an overlay needs to know of a view: where a point of the patient lies in its picture, and
// how long a millimetre is there. Each kind of view (3-D, a slice) makes one of its own.
import {
  cameraAxes,
  pixelSizeMm,
  projectPx,
  type Camera,
  type Point,
  type Viewport,
} from './camera.ts';
import { add, dot, scale, subtract, type Vector3 } from './vector.ts';

/** Patient positions are LPS, mm; points of the picture are device pixels of `viewport`. */
export interface ViewProjection {
  readonly viewport: Viewport;
  /** Nothing where the view cannot show the point. */
  readonly toPicture: (position_mm: Vector3) => Point | undefined;
  /** The part of a straight line that the view can show; nothing where that is none. */
  readonly lineToPicture: (from_mm: Vector3, to_mm: Vector3) => readonly [Point, Point] | undefined;
  /** What the side of a pixel spans at a point of the patient, mm. */
  readonly pixelSizeMm: (position_mm: Vector3) => number;
  /** Where a scale drawn into the picture holds. */
  readonly scale_at_mm: Vector3;
  /** Whether it holds there only, since what is farther away is smaller. */
  readonly foreshortens: boolean;
}

/** What is nearer to the eye is not drawn: 1 mm, or less where the view is of something tiny. */
const NEAREST_MM = 1;
const NEAREST_SHARE = 0.01;

/** The piece of a line in front of the eye. */
function inFront(
  camera: Camera,
  from_mm: Vector3,
  to_mm: Vector3,
): readonly [Vector3, Vector3] | undefined {
  const { backward } = cameraAxes(camera);
  const depth = (point_mm: Vector3): number => dot(subtract(camera.eye_mm, point_mm), backward);
  const nearest_mm = Math.min(NEAREST_MM, NEAREST_SHARE * depth(camera.target_mm));
  const [first, last] = [depth(from_mm) - nearest_mm, depth(to_mm) - nearest_mm];
  if (first < 0 && last < 0) return undefined;
  if (first >= 0 && last >= 0) return [from_mm, to_mm];
  const crossing_mm = add(from_mm, scale(subtract(to_mm, from_mm), first / (first - last)));
  return first < 0 ? [crossing_mm, to_mm] : [from_mm, crossing_mm];
}

export function cameraProjection(camera: Camera, viewport: Viewport): ViewProjection {
  const toPicture = (position_mm: Vector3): Point | undefined =>
    projectPx(camera, viewport, position_mm);
  return {
    viewport,
    toPicture,
    lineToPicture: (from_mm, to_mm) => {
      const piece = inFront(camera, from_mm, to_mm);
      const [from_px, to_px] = piece?.map(toPicture) ?? [];
      return from_px && to_px && [from_px, to_px];
    },
    pixelSizeMm: (position_mm) => pixelSizeMm(camera, viewport, position_mm),
    scale_at_mm: camera.target_mm,
    foreshortens: camera.projection === 'perspective',
  };
}
