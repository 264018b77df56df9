// Which received frame is decoded next. Decoding takes time, so at most one frame waits, and that
// is the newest.
import { isAfter } from '../protocol/counter.ts';
import type { FrameMessage } from '../protocol/frame_header.ts';

export class FrameQueue {
  private newest: number | undefined;
  private waiting: FrameMessage | undefined;

  /**
   * Takes a frame in. Returns false for one that is older than what was seen already: it is to be
   * acknowledged and dropped. A waiting frame that is replaced needs no acknowledgement of its own,
   * its successor's returns its credit.
   */
  offer(message: FrameMessage): boolean {
    const { frame } = message.header;
    if (this.newest !== undefined && !isAfter(frame, this.newest)) return false;
    this.newest = frame;
    this.waiting = message;
    return true;
  }

  take(): FrameMessage | undefined {
    const message = this.waiting;
    this.waiting = undefined;
    return message;
  }

  /** A new session counts its frames from 1 again. */
  restart(): void {
    this.newest = undefined;
    this.waiting = undefined;
  }
}
