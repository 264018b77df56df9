// What a key does, and where the help sheet lists it.
import type { Commands } from '../session/commands.ts';
import type { Exporting } from '../session/exporting.ts';
import type { Measuring } from '../session/measuring.ts';
import type { Slicing } from '../session/slicing.ts';
import type { ViewLayout } from '../session/view_layout.ts';
import type { ViewName } from '../state/views.ts';
import type { Words } from '../words/words.ts';

export type KeyGroup = keyof Words['keys']['groups'];

export interface KeyTarget {
  readonly commands: Commands;
  readonly exporting: Exporting;
  readonly measuring: Measuring;
  readonly slicing: Slicing;
  readonly layout: ViewLayout;
}

/** Which picture has the focus, and how many device pixels a CSS pixel of it has. */
export interface KeyPlace {
  readonly view: ViewName;
  readonly device_pixels: number;
}

export interface KeyBinding {
  /** As the help sheet shows them. */
  readonly keys: string;
  readonly meaning: keyof Words['keys']['meanings'];
  readonly group: KeyGroup;
  /** Also with Ctrl, wherever the focus is but in a text field. */
  readonly anywhere?: boolean;
  /** Whether the event is one of them; if so it has been carried out. */
  readonly apply: (event: KeyboardEvent, target: KeyTarget, place: KeyPlace) => boolean;
}

/** `names` as of KeyboardEvent.key, and 'Space'; without Ctrl, Alt or Command. */
export function isPlainKey(event: KeyboardEvent, names: string): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  return names.split(' ').includes(nameOf(event));
}

/** Caps Lock makes no other key of a letter. */
function nameOf({ key, shiftKey }: KeyboardEvent): string {
  if (key === ' ') return 'Space';
  if (key.length > 1) return key;
  return shiftKey ? key.toUpperCase() : key.toLowerCase();
}

/** Right and down in the picture. */
export const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
