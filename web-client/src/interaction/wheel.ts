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

function magnificationOf(event: WheelEvent): number {
  const exponent = -wheelPixels(event) * (event.ctrlKey ? PINCH_PER_PIXEL : ZOOM_PER_PIXEL);
  return Math.exp(Math.max(-LARGEST_EXPONENT, Math.min(LARGEST_EXPONENT, exponent)));
}

/** The page itself does not scroll or zoom. */
function listen(surface: HTMLElement, turned: (event: WheelEvent) => void): void {
  const listener = (event: WheelEvent): void => {
    event.preventDefault();
    turned(event);
  };
  surface.addEventListener('wheel', listener, { passive: false });
}

export function listenToWheel(surface: HTMLElement, target: WheelTarget): void {
  listen(surface, (event) => {
    const factor = magnificationOf(event);
    if (event.altKey || event.shiftKey) target.scaleLens(factor);
    else target.zoom(factor);
  });
}

export interface SliceWheelTarget {
  readonly scroll: (steps: number) => void;
  readonly zoom: (magnification: number, event: WheelEvent) => void;
  readonly scaleLens: (factor: number) => void;
}

/** What a touchpad moves for one slice; a notch of a wheel is one slice, whatever it reports. */
const PIXELS_PER_SLICE = 40;

/** Over a slice the wheel steps through the slices: away from the user is superior, anterior, left. */
export function listenToSliceWheel(surface: HTMLElement, target: SliceWheelTarget): void {
  let rest_px = 0;
  listen(surface, (event) => {
    if (event.ctrlKey) return target.zoom(magnificationOf(event), event);
    if (event.altKey || event.shiftKey) return target.scaleLens(magnificationOf(event));
    const turned_px = -wheelPixels(event);
    if (Math.abs(turned_px) >= PIXELS_PER_SLICE) return target.scroll(Math.sign(turned_px));
    rest_px += turned_px;
    const steps = Math.trunc(rest_px / PIXELS_PER_SLICE);
    rest_px -= steps * PIXELS_PER_SLICE;
    if (steps !== 0) target.scroll(steps);
  });
}
