// The frames of one view: the newest is decoded and painted, and each is acknowledged.
import type { FrameMessage } from '../protocol/frame_header.ts';
import { FrameQueue } from './frame_queue.ts';
import { PicturePainter } from './picture_painter.ts';

export interface FrameListener {
  /** The frame is on the screen, was dropped as too old, or could not be decoded. */
  done(message: FrameMessage): void;
  painted(message: FrameMessage): void;
  failed(message: FrameMessage, error: unknown): void;
}

export class ViewStream {
  private readonly queue = new FrameQueue();
  private readonly painter: PicturePainter;
  private painting = false;

  constructor(
    canvas: OffscreenCanvas,
    private readonly listener: FrameListener,
  ) {
    this.painter = new PicturePainter(canvas);
  }

  /** Also of a view that was closed meanwhile: its credit counts when it is opened again. */
  received(message: FrameMessage): void {
    if (this.queue.offer(message)) void this.paintWaiting();
    else this.listener.done(message);
  }

  /** A new session counts its frames from 1 again. */
  restart(): void {
    this.queue.restart();
  }

  private async paintWaiting(): Promise<void> {
    if (this.painting) return;
    this.painting = true;
    for (let next = this.queue.take(); next; next = this.queue.take()) await this.show(next);
    this.painting = false;
  }

  /**
   * A frame that cannot be decoded is acknowledged as well, or its credit would never come back.
   */
  private async show(message: FrameMessage): Promise<void> {
    try {
      await this.painter.paint(message);
      this.listener.painted(message);
    } catch (error) {
      this.listener.failed(message, error);
    }
    this.listener.done(message);
  }
}
