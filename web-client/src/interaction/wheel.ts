// The wheel zooms; with Alt or Shift it resizes the lens. A pinch on a touchpad arrives as a wheel
// with Ctrl, and zooms.

export interface WheelTarget {
  zoom(magnification: number): void;
  scaleLens(factor: number): void;
}

const PIXELS_PER_LINE = 16;
const PIXELS_PER_PAGE = 400;
const ZOOM_PER_PIXEL = 0.0015;
const PINCH_PER_PIXEL = 0.01;
/** One event never zooms by more than this, whatever the device reports. */
const LARGEST_EXPONENT = 0.5;

function wheelPixels(event: WheelEvent): number {
  const units: Record<number, number> = {
    [WheelEvent.DOM_DELTA_LINE]: PIXELS_PER_LINE,
    [WheelEvent.DOM_DELTA_PAGE]: PIXELS_PER_PAGE,
  };
  const delta = event.deltaY === 0 ? event.deltaX : event.deltaY;
  return delta * (units[event.deltaMode] ?? 1);
}

export function listenToWheel(surface: HTMLElement, target: WheelTarget): void {
  const turned = (event: WheelEvent): void => {
    event.preventDefault();
    const exponent = -wheelPixels(event) * (event.ctrlKey ? PINCH_PER_PIXEL : ZOOM_PER_PIXEL);
    const factor = Math.exp(Math.max(-LARGEST_EXPONENT, Math.min(LARGEST_EXPONENT, exponent)));
    if (event.altKey || event.shiftKey) target.scaleLens(factor);
    else target.zoom(factor);
  };
  surface.addEventListener('wheel', turned, { passive: false });
}
