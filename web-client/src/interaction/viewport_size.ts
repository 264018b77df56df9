// The size of an element in device pixels, also where the display's pixels are no whole multiple of
// CSS pixels.
import type { Limits } from '../protocol/messages.ts';
import type { Viewport } from '../view/camera.ts';
import type { ElementSize } from '../view/picture_fit.ts';

const LARGEST_ROUNDING_PX = 1;

type ViewportLimits = Pick<Limits, 'viewport_side_px' | 'viewport_pixels'>;

/** `exact` is not there in every browser, and in an emulated display it may be in CSS pixels. */
export function deviceSize(
  css: ElementSize,
  exact: Viewport | undefined,
  device_pixels: number,
): Viewport {
  const width_px = Math.round(css.width * device_pixels);
  const height_px = Math.round(css.height * device_pixels);
  const rounded = exact && Math.abs(exact.width_px - width_px) <= LARGEST_ROUNDING_PX;
  return rounded ? exact : { width_px, height_px };
}

function sizeOf({ contentRect, devicePixelContentBoxSize }: ResizeObserverEntry): Viewport {
  // Whatever its type says.
  const [box] = (devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined) ?? [];
  const exact = box && { width_px: box.inlineSize, height_px: box.blockSize };
  return deviceSize(contentRect, exact, devicePixelRatio);
}

/** `resized` hears of every size but an empty one. */
export function observeViewport(
  element: Element,
  resized: (viewport: Viewport) => void,
): ResizeObserver {
  const observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const viewport = sizeOf(entry);
    if (viewport.width_px > 0 && viewport.height_px > 0) resized(viewport);
  });
  try {
    observer.observe(element, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(element);
  }
  return observer;
}

/** The largest viewport of the same shape that the server's limits allow, once they are known. */
export function withinLimits(viewport: Viewport, limits: ViewportLimits | undefined): Viewport {
  if (!limits) return viewport;
  const { width_px, height_px } = viewport;
  const shrink = Math.min(
    1,
    limits.viewport_side_px / Math.max(width_px, height_px),
    Math.sqrt(limits.viewport_pixels / (width_px * height_px)),
  );
  if (shrink === 1) return viewport;
  const fit = (side: number): number => Math.max(1, Math.floor(side * shrink));
  return { width_px: fit(width_px), height_px: fit(height_px) };
}

export const isSameSize = (a: Viewport | undefined, b: Viewport): boolean =>
  a?.width_px === b.width_px && a.height_px === b.height_px;
