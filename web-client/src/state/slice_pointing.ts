// What the pointer does in a slice.
import type { Point } from '../view/camera.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import type { Vector3 } from '../view/vector.ts';
import type { MeasuredPoint } from '../view/measurement.ts';

/** Where it is, and what lies under it. */
export interface SliceHover {
  readonly slice: SliceName;
  /** Device pixels of the picture. */
  readonly position_px: Point;
  /** Nothing beside the volume, or until the server has answered. */
  readonly found: MeasuredPoint | undefined;
}

/** It holds an end of a crosshair line. */
export interface Tilting {
  readonly slice: SliceName;
  /** The picture's right when that began, unit vector of patient space. */
  readonly right: Vector3;
}
