// Keys of the pictures. The help sheet lists the same table.
import type { Commands } from '../session/commands.ts';
import type { ViewName } from '../state/views.ts';
import {
  ARROWS,
  isPlainKey,
  type KeyBinding,
  type KeyPlace,
  type KeyTarget,
} from './key_binding.ts';
import { EXPORT_KEYS } from './export_keys.ts';
import { MEASURING_KEYS } from './measuring_keys.ts';
import { SLICE_KEYS } from './slice_keys.ts';
import { VIEW_KEYS } from './view_keys.ts';

const TURN_CSS_PIXELS = 24;
const NUDGE_CSS_PIXELS = 12;
const ZOOM_FACTOR = 1.1;
const LENS_FACTOR = 1.08;
const ROLL_RADIANS = Math.PI / 36;

type ArrowAction = (commands: Commands, dx_px: number, dy_px: number) => void;

const heldKey = ({ shiftKey, altKey }: KeyboardEvent): 'shift' | 'alt' | 'none' =>
  shiftKey ? 'shift' : altKey ? 'alt' : 'none';

function arrows(
  modifier: 'none' | 'shift' | 'alt',
  css_pixels: number,
  action: ArrowAction,
): KeyBinding['apply'] {
  return (event, { commands }, { device_pixels }) => {
    const direction = ARROWS[event.key];
    if (!direction || heldKey(event) !== modifier || event.ctrlKey || event.metaKey) return false;
    const distance_px = css_pixels * device_pixels;
    action(commands, direction[0] * distance_px, direction[1] * distance_px);
    return true;
  };
}

function key(names: string, action: (commands: Commands) => void): KeyBinding['apply'] {
  return (event, { commands }) => {
    if (!isPlainKey(event, names)) return false;
    action(commands);
    return true;
  };
}

/** With Ctrl, or on a Mac with Command. */
function chord(
  wanted: (key: string, shift: boolean) => boolean,
  action: (target: KeyTarget) => void,
): KeyBinding['apply'] {
  return (event, target) => {
    const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
    if (!(ctrlKey || metaKey) || altKey || !wanted(key.toLowerCase(), shiftKey)) return false;
    action(target);
    return true;
  };
}

export const KEY_BINDINGS: readonly KeyBinding[] = [
  ...MEASURING_KEYS,
  ...VIEW_KEYS,
  ...SLICE_KEYS,
  {
    keys: '← ↑ → ↓',
    meaning: 'rotate',
    group: 'view',
    apply: arrows('none', TURN_CSS_PIXELS, (c, dx, dy) => c.orbit(dx, dy)),
  },
  {
    keys: 'Alt + ← ↑ → ↓',
    meaning: 'pan',
    group: 'view',
    apply: arrows('alt', TURN_CSS_PIXELS, (c, dx, dy) => c.pan(dx, dy)),
  },
  {
    keys: 'Shift + ← ↑ → ↓',
    meaning: 'move_lens',
    group: 'lens',
    apply: arrows('shift', NUDGE_CSS_PIXELS, (c, dx, dy) => c.nudgeLens(dx, dy)),
  },
  { keys: '+', meaning: 'zoom_in', group: 'view', apply: key('+ =', (c) => c.zoom(ZOOM_FACTOR)) },
  {
    keys: '-',
    meaning: 'zoom_out',
    group: 'view',
    apply: key('- _', (c) => c.zoom(1 / ZOOM_FACTOR)),
  },
  {
    keys: ']',
    meaning: 'larger_lens',
    group: 'lens',
    apply: key(']', (c) => c.scaleLens(LENS_FACTOR)),
  },
  {
    keys: '[',
    meaning: 'smaller_lens',
    group: 'lens',
    apply: key('[', (c) => c.scaleLens(1 / LENS_FACTOR)),
  },
  { keys: 'x', meaning: 'toggle_lens', group: 'lens', apply: key('x', (c) => c.toggleLens()) },
  {
    keys: 'f',
    meaning: 'follow',
    group: 'lens',
    apply: key('f', (c) => c.followPointer()),
  },
  {
    keys: 'b',
    meaning: 'compare',
    group: 'style',
    apply: key('b', (c) => c.compare(true)),
  },
  {
    keys: 'Ctrl + Z',
    meaning: 'undo',
    group: 'style',
    anywhere: true,
    apply: chord(
      (name, shift) => name === 'z' && !shift,
      ({ measuring }) => measuring.undo(),
    ),
  },
  {
    keys: 'Ctrl + Y, Ctrl + Shift + Z',
    meaning: 'redo',
    group: 'style',
    anywhere: true,
    apply: chord(
      (name, shift) => name === 'y' || (name === 'z' && shift),
      ({ commands }) => commands.redo(),
    ),
  },
  { keys: ',', meaning: 'roll_left', group: 'view', apply: key(',', (c) => c.roll(-ROLL_RADIANS)) },
  { keys: '.', meaning: 'roll_right', group: 'view', apply: key('.', (c) => c.roll(ROLL_RADIANS)) },
  ...EXPORT_KEYS,
  { keys: 'r', meaning: 'reset_view', group: 'view', apply: key('r', (c) => c.resetView()) },
  { keys: 'p', meaning: 'toggle_panel', group: 'page', apply: key('p', (c) => c.togglePanel()) },
  {
    keys: 'i',
    meaning: 'status_line',
    group: 'page',
    apply: key('i', (c) => c.toggleStatusLine()),
  },
  { keys: '?', meaning: 'help', group: 'page', apply: key('?', (c) => c.toggleHelp()) },
];

const applied = (
  bindings: readonly KeyBinding[],
  event: KeyboardEvent,
  target: KeyTarget,
  place: KeyPlace,
): void => {
  if (bindings.some((binding) => binding.apply(event, target, place))) event.preventDefault();
};

/** The volume's own keys mean nothing in a slice, and the other way round. */
const isOf = ({ group }: KeyBinding, view: ViewName): boolean =>
  view === '3d' ? group !== 'slices' : group !== 'view' && group !== 'lens';

export function applyKey(event: KeyboardEvent, target: KeyTarget, place: KeyPlace): void {
  const bindings = KEY_BINDINGS.filter((one) => !one.anywhere && isOf(one, place.view));
  applied(bindings, event, target, place);
}

const TEXT_FIELDS = /^(text|number|search|email|url|tel|password)$/;

/** Where Ctrl+Z undoes what was typed. */
function takesText([target]: readonly EventTarget[]): boolean {
  if (target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && TEXT_FIELDS.test(target.type) && !target.readOnly;
}

/** What has a use of its own for a letter or a digit, or has had it; and what lies over the page. */
const KEEPS_CHARACTERS = 'input, textarea, select, dialog, [role=application], [role=dialog]';

const keepsCharacters = (path: readonly EventTarget[]): boolean =>
  path.some((target) => target instanceof Element && target.matches(KEEPS_CHARACTERS));

const isCharacter = ({ key }: KeyboardEvent): boolean => key.length === 1 && key !== ' ';

/**
 * For keys that work anywhere, and letters, digits and marks for the chief picture where no other
 * has the focus; and for a held key that is let go. Lasts as long as the page.
 */
export function listenToKeys(page: Window, target: KeyTarget): void {
  const anywhere = KEY_BINDINGS.filter((binding) => binding.anywhere);
  page.addEventListener('keydown', (event) => {
    const path = event.composedPath();
    const place: KeyPlace = {
      view: target.layout.chief_view,
      device_pixels: page.devicePixelRatio,
    };
    if (event.defaultPrevented || takesText(path)) return;
    applied(anywhere, event, target, place);
    if (isCharacter(event) && !keepsCharacters(path)) applyKey(event, target, place);
  });
  const released = (): void => target.commands.compare(false);
  page.addEventListener('keyup', ({ key: name }) => {
    if (name === 'b') released();
  });
  page.addEventListener('blur', released);
}
