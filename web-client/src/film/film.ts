// A film before it is drawn: how many frames, and how the scene differs in each.
import type { Scene } from '../protocol/messages.ts';
import type { JsonObject } from '../state/merge_patch.ts';

export interface Film {
  readonly frames: number;
  readonly frames_per_second: number;
  /** A patch that says the whole scene of a frame, 0 <= index < frames. */
  readonly sceneOf: (index: number) => JsonObject;
}

/** A picture, and what it shows. */
export interface FilmFrame {
  /** As the server made it. */
  readonly png: Blob;
  readonly scene: Scene;
}

export const frameCount = (seconds: number, frames_per_second: number): number =>
  Math.max(1, Math.round(seconds * frames_per_second));
