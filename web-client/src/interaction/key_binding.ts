// What a key does, and where the help sheet lists it.
import type { Commands } from '../session/commands.ts';
import type { Exporting } from '../session/exporting.ts';
import type { Measuring } from '../session/measuring.ts';
import type { Words } from '../words/words.ts';

export type KeyGroup = keyof Words['keys']['groups'];

export interface KeyTarget {
  readonly commands: Commands;
  readonly exporting: Exporting;
  readonly measuring: Measuring;
}

export interface KeyBinding {
  /** As the help sheet shows them. */
  readonly keys: string;
  readonly meaning: keyof Words['keys']['meanings'];
  readonly group: KeyGroup;
  /** Wherever the focus is, but in a text field; else only while the picture has it. */
  readonly anywhere?: boolean;
  /** Whether the event is one of them; if so it has been carried out. */
  readonly apply: (event: KeyboardEvent, target: KeyTarget, device_pixels: number) => boolean;
}

/** Right and down in the picture. */
export const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
