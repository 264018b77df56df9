// The size of an element in device pixels, also where the display's pixels are no whole multiple of
// CSS pixels.
import type { Viewport } from '../view/camera.ts';
import type { ElementSize } from '../view/picture_fit.ts';

const LARGEST_ROUNDING_PX = 1;

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

export const isSameSize = (a: Viewport | undefined, b: Viewport): boolean =>
  a?.width_px === b.width_px && a.height_px === b.height_px;
