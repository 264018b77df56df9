// Over the 3-D picture: left drag or one finger rotates, middle or Shift+left or two fingers pan,
// right drag or pinch zooms.
import type { Commands } from '../session/commands.ts';
import {
  magnificationOf,
  MIDDLE_BUTTON,
  RIGHT_BUTTON,
  type Drag,
  type PointerTarget,
} from './pointer_gestures.ts';

type Motion = 'orbit' | 'pan' | 'zoom';

function motionOf(event: PointerEvent): Motion {
  if (event.button === MIDDLE_BUTTON) return 'pan';
  if (event.button === RIGHT_BUTTON) return 'zoom';
  return event.shiftKey ? 'pan' : 'orbit';
}

/** `device_pixels` gives how many of them a CSS pixel of the picture has. */
export function volumeGestures(
  commands: Commands,
  device_pixels: () => number,
  slip_css_px: () => number,
): PointerTarget<Motion> {
  return {
    motionOf,
    slip_css_px,
    dragged: (motion, drag: Drag) => {
      const [dx_px, dy_px] = [drag.dx * device_pixels(), drag.dy * device_pixels()];
      if (motion === 'zoom') commands.zoom(magnificationOf(drag));
      else if (motion === 'pan') commands.pan(dx_px, dy_px);
      else commands.orbit(dx_px, dy_px);
    },
    pinched: ({ dx, dy, magnification }) => {
      commands.pan(dx * device_pixels(), dy * device_pixels());
      commands.zoom(magnification);
    },
  };
}
