// Exporting pictures and films: what is open, what is being made, and how the last one went.
import type { CameraPath } from '../film/camera_path.ts';
import type { ViewName } from './views.ts';

export interface ExportJob {
  readonly what: 'picture' | 'film';
  readonly frames: number;
  readonly frames_done: number;
  /** On the clock of `performance.now`. */
  readonly began_ms: number;
}

export type ExportOutcome =
  | { readonly kind: 'saved'; readonly name: string; readonly bytes: number }
  | { readonly kind: 'failed'; readonly title: string; readonly detail: string };

export interface ExportState {
  readonly open: boolean;
  /** Which of the session's pictures is to be saved. */
  readonly view: ViewName;
  readonly job: ExportJob | undefined;
  /** The job goes on once the server takes requests again. */
  readonly lags: boolean;
  readonly outcome: ExportOutcome | undefined;
  /** When it began, on the clock of `performance.now`; nothing while none is made. */
  readonly recording_since_ms: number | undefined;
  readonly path: CameraPath | undefined;
}

export const NOTHING_EXPORTED: ExportState = {
  open: false,
  view: '3d',
  job: undefined,
  lags: false,
  outcome: undefined,
  recording_since_ms: undefined,
  path: undefined,
};

/** Nothing before the first frame is there. */
export function timeLeftMs(
  { frames, frames_done, began_ms }: ExportJob,
  now_ms: number,
): number | undefined {
  if (frames_done === 0) return undefined;
  return ((now_ms - began_ms) / frames_done) * (frames - frames_done);
}
