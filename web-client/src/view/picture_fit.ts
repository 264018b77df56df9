// Where a picture lies in the element that shows it: whole, in its own shape, centred (CSS
// object-fit: contain).
import type { Point, Viewport } from './camera.ts';

export interface ElementSize {
  readonly width: number;
  readonly height: number;
}

interface Fit {
  /** CSS pixels for one of the picture's. */
  readonly scale: number;
  readonly left: number;
  readonly top: number;
}

function fit({ width_px, height_px }: Viewport, { width, height }: ElementSize): Fit {
  const scale = Math.min(width / width_px, height / height_px);
  return { scale, left: (width - width_px * scale) / 2, top: (height - height_px * scale) / 2 };
}

/** CSS pixels from the element's upper left corner. */
export function pictureToElement(
  [x_px, y_px]: Point,
  viewport: Viewport,
  size: ElementSize,
): Point {
  const { scale, left, top } = fit(viewport, size);
  return [left + x_px * scale, top + y_px * scale];
}

/** Device pixels of the picture; may lie outside of it. */
export function elementToPicture([x, y]: Point, viewport: Viewport, size: ElementSize): Point {
  const { scale, left, top } = fit(viewport, size);
  return [(x - left) / scale, (y - top) / scale];
}
