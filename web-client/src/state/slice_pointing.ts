// What the pointer does in a slice.
import type { SliceName } from '../view/slice_geometry.ts';
import type { Vector3 } from '../view/vector.ts';
import type { MeasuredPoint } from './measurement.ts';

/** What lies under it. */
export interface SliceHover {
  readonly slice: SliceName;
  /** Nothing beside the volume, or until the server has answered. */
  readonly found: MeasuredPoint | undefined;
}

/** It holds an end of a crosshair line. */
export interface Tilting {
  readonly slice: SliceName;
  /** The picture's right when that began, unit vector of patient space. */
  readonly right: Vector3;
}
