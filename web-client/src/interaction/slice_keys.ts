// Keys while a slice has the focus.
import type { Slicing } from '../session/slicing.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { ARROWS, isPlainKey, type KeyBinding, type KeyPlace } from './key_binding.ts';

const STEPS_PER_PAGE = 10;
const ZOOM_FACTOR = 1.1;
const TILT_RADIANS = Math.PI / 90;
const NUDGE_CSS_PIXELS = 4;
const PAN_CSS_PIXELS = 24;

type Action = (slicing: Slicing, slice: SliceName) => void;

function key(names: string, action: Action): KeyBinding['apply'] {
  return (event, { slicing }, { view }) => {
    if (view === '3d' || !isPlainKey(event, names) || (event.shiftKey && ARROWS[event.key]))
      return false;
    action(slicing, view);
    return true;
  };
}

/** Either of two keys, forward and back. */
const pair =
  (forward: string, back: string, action: (...of: [...Parameters<Action>, 1 | -1]) => void) =>
  (...of: Parameters<KeyBinding['apply']>): boolean =>
    key(forward, (slicing, slice) => action(slicing, slice, 1))(...of) ||
    key(back, (slicing, slice) => action(slicing, slice, -1))(...of);

function moves(
  held: 'shiftKey' | 'altKey',
  css_pixels: number,
  action: (slicing: Slicing, slice: SliceName, dx_px: number, dy_px: number) => void,
): KeyBinding['apply'] {
  return (event, { slicing }, { view, device_pixels }: KeyPlace) => {
    const direction = ARROWS[event.key];
    if (!direction || view === '3d' || !event[held] || event.ctrlKey || event.metaKey) return false;
    const [dx_px, dy_px] = [direction[0] * css_pixels, direction[1] * css_pixels];
    action(slicing, view, dx_px * device_pixels, dy_px * device_pixels);
    return true;
  };
}

const BINDINGS: readonly Omit<KeyBinding, 'group'>[] = [
  {
    keys: '↑ →, ↓ ←',
    meaning: 'scroll',
    apply: pair('ArrowUp ArrowRight', 'ArrowDown ArrowLeft', (s, slice, sign) =>
      s.scroll(slice, sign),
    ),
  },
  {
    keys: 'PageUp, PageDown',
    meaning: 'scroll_ten',
    apply: pair('PageUp', 'PageDown', (s, slice, sign) => s.scroll(slice, sign * STEPS_PER_PAGE)),
  },
  {
    keys: 'Shift + ← ↑ → ↓',
    meaning: 'move_crosshair',
    apply: moves('shiftKey', NUDGE_CSS_PIXELS, (s, slice, dx, dy) =>
      s.nudgeCrosshair(slice, dx, dy),
    ),
  },
  {
    keys: 'Alt + ← ↑ → ↓',
    meaning: 'pan',
    apply: moves('altKey', PAN_CSS_PIXELS, (s, slice, dx, dy) => s.pan(slice, dx, dy)),
  },
  {
    keys: '+, -',
    meaning: 'zoom_slice',
    apply: pair('+ =', '- _', (s, slice, sign) => s.zoom(slice, ZOOM_FACTOR ** sign)),
  },
  {
    keys: ', .',
    meaning: 'tilt',
    apply: pair(',', '.', (s, slice, sign) => s.tilt(slice, sign * TILT_RADIANS)),
  },
  { keys: 't', meaning: 'reset_tilt', apply: key('t', (s) => s.resetTilt()) },
  { keys: 'r', meaning: 'reset_slice', apply: key('r', (s, slice) => s.resetView(slice)) },
  { keys: 'w', meaning: 'drag_window', apply: key('w', (s) => s.toggleWindowDrag()) },
];

export const SLICE_KEYS: readonly KeyBinding[] = BINDINGS.map((binding) => ({
  ...binding,
  group: 'slices',
}));
