// The size of an element in device pixels, also where the display's pixels are no whole multiple of
// CSS pixels.
import type { Viewport } from '../view/camera.ts';

function deviceSize(entry: ResizeObserverEntry): Viewport {
  // Not every browser has it, whatever its type says.
  const exact = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
  if (exact) return { width_px: exact.inlineSize, height_px: exact.blockSize };
  const { width, height } = entry.contentRect;
  return {
    width_px: Math.round(width * devicePixelRatio),
    height_px: Math.round(height * devicePixelRatio),
  };
}

/** `resized` hears of every size but an empty one. */
export function observeViewport(
  element: Element,
  resized: (viewport: Viewport) => void,
): ResizeObserver {
  const observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const viewport = deviceSize(entry);
    if (viewport.width_px > 0 && viewport.height_px > 0) resized(viewport);
  });
  try {
    observer.observe(element, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(element);
  }
  return observer;
}

/** The largest viewport of the same shape that the server's limits allow. */
export function withinLimits(viewport: Viewport, side_px: number, pixels: number): Viewport {
  const { width_px, height_px } = viewport;
  const shrink = Math.min(
    1,
    side_px / Math.max(width_px, height_px),
    Math.sqrt(pixels / (width_px * height_px)),
  );
  if (shrink === 1) return viewport;
  const fit = (side: number): number => Math.max(1, Math.floor(side * shrink));
  return { width_px: fit(width_px), height_px: fit(height_px) };
}
