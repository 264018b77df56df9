// How far an export is, in words.
import { words } from '../words/words.ts';
import { timeLeftMs, type ExportJob } from './export_state.ts';

const MINUTE_S = 60;

/** Nothing before the first frame is there. */
export function timeLeftText(job: ExportJob, now_ms: number): string {
  const left_ms = timeLeftMs(job, now_ms);
  if (left_ms === undefined) return '';
  const seconds = Math.ceil(left_ms / 1000);
  const { seconds_left, minutes_left } = words().export;
  return seconds < 2 * MINUTE_S
    ? seconds_left(seconds)
    : minutes_left(Math.round(seconds / MINUTE_S));
}

export const framesText = ({ frames_done, frames }: ExportJob): string =>
  words().export.frame_of(Math.min(frames_done + 1, frames), frames);
