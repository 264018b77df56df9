// Lossless pictures that the server makes on demand. It makes one at a time and lets one more wait;
// what is asked beyond that waits here.
import type { Counter } from '../protocol/counter.ts';
import type { ErrorMessage } from '../protocol/messages.ts';
import { errorDetail, errorTitle } from '../state/error_text.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import type { Stream } from '../stream/stream.ts';
import type { Viewport } from '../view/camera.ts';
import { words } from '../words/words.ts';

export const STILLS_IN_FLIGHT = 2;

export interface Still extends Viewport {
  /** By its number; left out, the 3-D picture. */
  readonly view?: number;
  /** How it differs from the session's scene. */
  readonly scene?: JsonObject;
}

/** In words for the user. */
export class ExportError extends Error {
  constructor(
    readonly title: string,
    readonly detail: string,
  ) {
    super(title);
  }
}

interface Wanted {
  readonly still: Still;
  readonly made: (png: Blob) => void;
  readonly failed: (reason: unknown) => void;
}

export class Stills {
  private waiting: readonly Wanted[] = [];
  /** By request. Nobody waits any more for one that was given up, but the server still makes it. */
  private readonly outstanding = new Map<number, Wanted>();

  constructor(
    private readonly stream: Stream,
    private readonly requests: Counter,
    /** Sends what the user has changed already: the picture is of the scene that the server knows. */
    private readonly flush: () => void,
  ) {}

  /** PNG. Fails with an ExportError, or with the signal's reason. */
  make(still: Still, signal: AbortSignal): Promise<Blob> {
    return new Promise((made, failed) => {
      const wanted: Wanted = { still, made, failed };
      signal.addEventListener('abort', () => this.giveUp(wanted, signal.reason), { once: true });
      if (signal.aborted) return failed(signal.reason as Error);
      this.waiting = [...this.waiting, wanted];
      this.askNext();
    });
  }

  arrived(request: number, png: Blob): void {
    this.settle(request)?.made(png);
  }

  /** Whether the refused request was one for a still. */
  refused(error: ErrorMessage): boolean {
    const wanted = error.request === undefined ? undefined : this.settle(error.request);
    wanted?.failed(new ExportError(errorTitle(error), errorDetail(error)));
    return wanted !== undefined;
  }

  /** What a lost connection was asked for will not come. */
  restart(): void {
    const lost = [...this.outstanding.values(), ...this.waiting];
    this.outstanding.clear();
    this.waiting = [];
    const { connection_lost, connection_lost_detail } = words().export;
    for (const { failed } of lost) failed(new ExportError(connection_lost, connection_lost_detail));
  }

  private giveUp(wanted: Wanted, reason: unknown): void {
    this.waiting = this.waiting.filter((one) => one !== wanted);
    wanted.failed(reason);
  }

  private settle(request: number): Wanted | undefined {
    const wanted = this.outstanding.get(request);
    this.outstanding.delete(request);
    this.askNext();
    return wanted;
  }

  private askNext(): void {
    const [next, ...rest] = this.waiting;
    if (!next || this.outstanding.size >= STILLS_IN_FLIGHT) return;
    this.waiting = rest;
    const request = this.requests.next();
    this.outstanding.set(request, next);
    this.flush();
    this.stream.send({ type: 'save_still', request, ...next.still });
    this.askNext();
  }
}
