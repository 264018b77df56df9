// Keys while the picture has the focus. The help sheet lists the same table.
import type { Commands } from '../session/commands.ts';
import type { Words } from '../words/words.ts';

const TURN_CSS_PIXELS = 24;
const NUDGE_CSS_PIXELS = 12;
const ZOOM_FACTOR = 1.1;
const LENS_FACTOR = 1.08;
const ROLL_RADIANS = Math.PI / 36;

export interface KeyBinding {
  /** As the help sheet shows them. */
  readonly keys: string;
  readonly meaning: keyof Words['keys']['meanings'];
  /** Whether the event is one of them; if so it has been carried out. */
  readonly apply: (event: KeyboardEvent, commands: Commands, device_pixels: number) => boolean;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

type ArrowAction = (commands: Commands, dx_px: number, dy_px: number) => void;

function arrows(
  modifier: 'none' | 'shift' | 'alt',
  css_pixels: number,
  action: ArrowAction,
): KeyBinding['apply'] {
  return (event, commands, device_pixels) => {
    const direction = ARROWS[event.key];
    const held = event.shiftKey ? 'shift' : event.altKey ? 'alt' : 'none';
    if (!direction || held !== modifier || event.ctrlKey || event.metaKey) return false;
    const distance_px = css_pixels * device_pixels;
    action(commands, direction[0] * distance_px, direction[1] * distance_px);
    return true;
  };
}

function key(names: string, action: (commands: Commands) => void): KeyBinding['apply'] {
  return (event, commands) => {
    if (!names.split(' ').includes(event.key) || event.ctrlKey || event.metaKey || event.altKey)
      return false;
    action(commands);
    return true;
  };
}

export const KEY_BINDINGS: readonly KeyBinding[] = [
  {
    keys: '← ↑ → ↓',
    meaning: 'rotate',
    apply: arrows('none', TURN_CSS_PIXELS, (c, dx, dy) => c.orbit(dx, dy)),
  },
  {
    keys: 'Alt + ← ↑ → ↓',
    meaning: 'pan',
    apply: arrows('alt', TURN_CSS_PIXELS, (c, dx, dy) => c.pan(dx, dy)),
  },
  {
    keys: 'Shift + ← ↑ → ↓',
    meaning: 'move_lens',
    apply: arrows('shift', NUDGE_CSS_PIXELS, (c, dx, dy) => c.nudgeLens(dx, dy)),
  },
  { keys: '+', meaning: 'zoom_in', apply: key('+ =', (c) => c.zoom(ZOOM_FACTOR)) },
  { keys: '-', meaning: 'zoom_out', apply: key('- _', (c) => c.zoom(1 / ZOOM_FACTOR)) },
  { keys: ']', meaning: 'larger_lens', apply: key(']', (c) => c.scaleLens(LENS_FACTOR)) },
  { keys: '[', meaning: 'smaller_lens', apply: key('[', (c) => c.scaleLens(1 / LENS_FACTOR)) },
  { keys: 'x', meaning: 'toggle_lens', apply: key('x', (c) => c.toggleLens()) },
  {
    keys: 'f',
    meaning: 'follow',
    apply: key('f', (c) => c.followPointer()),
  },
  { keys: ',', meaning: 'roll_left', apply: key(',', (c) => c.roll(-ROLL_RADIANS)) },
  { keys: '.', meaning: 'roll_right', apply: key('.', (c) => c.roll(ROLL_RADIANS)) },
  { keys: 'r', meaning: 'reset_view', apply: key('r', (c) => c.resetView()) },
  { keys: 'p', meaning: 'toggle_panel', apply: key('p', (c) => c.togglePanel()) },
  { keys: '?', meaning: 'help', apply: key('?', (c) => c.toggleHelp()) },
];

export function applyKey(event: KeyboardEvent, commands: Commands, device_pixels: number): void {
  if (KEY_BINDINGS.some((binding) => binding.apply(event, commands, device_pixels)))
    event.preventDefault();
}
