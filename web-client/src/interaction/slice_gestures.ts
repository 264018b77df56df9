// Over a slice: left drag or one finger moves the crosshair, middle or Shift+left or two fingers pan,
// right drag or pinch zooms about the pointer, Ctrl or Alt + left changes the window.
import type { Slicing } from '../session/slicing.ts';
import type { Point } from '../view/camera.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { SLIP_CSS_PX } from './placing.ts';
import {
  magnificationOf,
  MIDDLE_BUTTON,
  RIGHT_BUTTON,
  type PointerTarget,
} from './pointer_gestures.ts';

type Motion = 'crosshair' | 'window' | 'pan' | 'zoom';

export interface SlicePage {
  readonly slice: SliceName;
  /** The point of the picture (device pixels) at a place of the page. */
  readonly pointAt: (place: { readonly x: number; readonly y: number }) => Point;
  readonly device_pixels: () => number;
  /** Whether a plain drag changes the window. */
  readonly drags_window: () => boolean;
  /** Whether a press is meant for a measuring tool. */
  readonly measures: () => boolean;
}

function motionOf(event: PointerEvent, drags_window: boolean): Motion {
  if (event.button === MIDDLE_BUTTON) return 'pan';
  if (event.button === RIGHT_BUTTON) return 'zoom';
  if (event.shiftKey) return 'pan';
  return event.ctrlKey || event.altKey || drags_window ? 'window' : 'crosshair';
}

const placeOf = ({ clientX, clientY }: PointerEvent): { x: number; y: number } => ({
  x: clientX,
  y: clientY,
});

export function sliceGestures(slicing: Slicing, page: SlicePage): PointerTarget<Motion> {
  const { slice, pointAt, device_pixels } = page;
  const pan = (dx: number, dy: number): void =>
    slicing.pan(slice, dx * device_pixels(), dy * device_pixels());
  return {
    motionOf: (event) => motionOf(event, page.drags_window()),
    slip_css_px: () => SLIP_CSS_PX,
    pressed: (motion, event) => {
      if (motion === 'crosshair' && !page.measures())
        slicing.pointCrosshair(slice, pointAt(placeOf(event)));
    },
    dragged: (motion, drag) => {
      if (motion === 'crosshair') slicing.pointCrosshair(slice, pointAt(placeOf(drag.event)));
      else if (motion === 'window') slicing.dragWindow(drag.dx, drag.dy);
      else if (motion === 'pan') pan(drag.dx, drag.dy);
      else slicing.zoom(slice, magnificationOf(drag), pointAt(drag.start));
    },
    pinched: (pinch) => {
      pan(pinch.dx, pinch.dy);
      slicing.zoom(slice, pinch.magnification, pointAt(pinch));
    },
  };
}
