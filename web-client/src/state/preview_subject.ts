// What a style's picture shows besides the style: the volume, from where, and where it is cut.
import type { Scene } from '../protocol/messages.ts';
import type { Viewport } from '../view/camera.ts';
import { PREVIEW_SIDE_PX } from '../protocol/messages.ts';

/** Equal for two scenes exactly where all their previews are. */
export function previewSubject({ volume, camera, lens, focus, context }: Scene): string {
  const place = [lens?.shape, lens?.centre_mm, lens?.radius_mm];
  return JSON.stringify([volume, camera, place, focus?.surface, context?.surface]);
}

/** The largest preview of the same shape that the protocol allows. */
export function previewSize({ width_px, height_px }: Viewport): Viewport {
  const shrink = Math.min(1, PREVIEW_SIDE_PX.maximum / Math.max(width_px, height_px));
  const fit = (side: number): number => Math.max(1, Math.round(side * shrink));
  return { width_px: fit(width_px), height_px: fit(height_px) };
}
