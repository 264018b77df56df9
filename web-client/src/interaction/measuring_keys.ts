// Keys of the measuring tools. With a tool in hand the arrows move its point, and with Alt the camera:
// what Alt does without a tool, panning, then takes Shift too.
import type { Measuring } from '../session/measuring.ts';
import type { MeasurementKind } from '../view/measurement.ts';
import type { ViewName } from '../state/views.ts';
import { ARROWS, isPlainKey, type KeyBinding } from './key_binding.ts';

const STEP_CSS_PIXELS = 12;
/** As far as an arrow moves the camera without a tool. */
const CAMERA_CSS_PIXELS = 24;

/** `action` says whether the key meant anything now. */
function onKey(
  names: string,
  action: (measuring: Measuring, view: ViewName) => boolean,
): KeyBinding['apply'] {
  return (event, { measuring }, { view }) => isPlainKey(event, names) && action(measuring, view);
}

const takeTool = (name: string, kind: MeasurementKind): KeyBinding['apply'] =>
  onKey(name, (measuring) => {
    measuring.take(kind);
    return true;
  });

const movePoint: KeyBinding['apply'] = (event, { measuring }, { view, device_pixels }) => {
  const direction = ARROWS[event.key];
  if (!direction || !measuring.has_tool || event.altKey || event.ctrlKey || event.metaKey)
    return false;
  const step_px = (event.shiftKey ? 1 : STEP_CSS_PIXELS) * device_pixels;
  measuring.nudge(view, direction[0] * step_px, direction[1] * step_px);
  return true;
};

const moveCamera: KeyBinding['apply'] = (
  event,
  { measuring, commands },
  { view, device_pixels },
) => {
  const direction = view === '3d' && ARROWS[event.key];
  if (!direction || !measuring.has_tool || !event.altKey || event.ctrlKey || event.metaKey)
    return false;
  const [dx_px, dy_px] = direction.map((part) => part * CAMERA_CSS_PIXELS * device_pixels);
  if (event.shiftKey) commands.pan(dx_px ?? 0, dy_px ?? 0);
  else commands.orbit(dx_px ?? 0, dy_px ?? 0);
  return true;
};

const BINDINGS: readonly Omit<KeyBinding, 'group'>[] = [
  { keys: 'm', meaning: 'measure_distance', apply: takeTool('m', 'distance') },
  { keys: 'a', meaning: 'measure_angle', apply: takeTool('a', 'angle') },
  { keys: 'v', meaning: 'measure_probe', apply: takeTool('v', 'probe') },
  { keys: '(Shift +) ← ↑ → ↓', meaning: 'move_point', apply: movePoint },
  { keys: 'Alt (+ Shift) + ← ↑ → ↓', meaning: 'rotate_with_tool', apply: moveCamera },
  {
    keys: 'Enter',
    meaning: 'place_point',
    apply: onKey('Enter Space', (m, view) => m.place(view)),
  },
  {
    keys: 'Backspace',
    meaning: 'take_back_point',
    apply: onKey('Backspace', (m) => m.takeBackPoint()),
  },
  { keys: 'Esc', meaning: 'cancel_measuring', apply: onKey('Escape', (m) => m.cancel()) },
];

export const MEASURING_KEYS: readonly KeyBinding[] = BINDINGS.map((binding) => ({
  ...binding,
  group: 'measure',
}));
