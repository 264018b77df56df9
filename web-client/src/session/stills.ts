// Lossless pictures that the server makes on demand. It makes one at a time and lets one more wait;
// what is asked beyond that waits here. A refusal that time may end, a lost connection and a server
// that starts anew cost none of them: they are asked for again.
import type { Counter } from '../protocol/counter.ts';
import type { ErrorMessage } from '../protocol/messages.ts';
import { errorDetail, errorTitle } from '../state/error_text.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import type { Stream } from '../stream/stream.ts';
import type { Viewport } from '../view/camera.ts';

export const STILLS_IN_FLIGHT = 2;

/** How often one still is asked for again after each kind of refusal that time may end. */
const REPEATS: Readonly<Partial<Record<ErrorMessage['code'], number>>> = {
  'rate-limited': 12,
  'render-failed': 4, // given up by the renderer, which may be starting anew
};
const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 8_000;

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
  still: Still;
  /** For when it is asked for again: the session's scene may be another one by then. */
  readonly scene_then: JsonObject | undefined;
  readonly made: (png: Blob) => void;
  readonly failed: (reason: unknown) => void;
  refusals: number;
  given_up: boolean;
}

export class Stills {
  private waiting: readonly Wanted[] = [];
  /** By request. Nobody waits any more for one that was given up, but the server still makes it. */
  private readonly outstanding = new Map<number, Wanted>();
  /** The server shows the page's scene. */
  private is_served = false;
  private pause: ReturnType<typeof setTimeout> | undefined;
  private pauses = 0;

  constructor(
    private readonly stream: Stream,
    private readonly requests: Counter,
    /** Sends what the user has changed already: the picture is of the scene that the server knows. */
    private readonly changes: { flush(): void },
    /** Hears whether somebody waits for a still that is to be asked for again. */
    private readonly lags: (lags: boolean) => void,
  ) {}

  /** PNG. Fails with an ExportError, or with the signal's reason. */
  make(still: Still, signal: AbortSignal, scene_then = still.scene): Promise<Blob> {
    return new Promise((made, failed) => {
      const wanted = { still, scene_then, made, failed, refusals: 0, given_up: false };
      signal.addEventListener('abort', () => this.giveUp(wanted, signal.reason), { once: true });
      if (signal.aborted) return failed(signal.reason as Error);
      this.waiting = [...this.waiting, wanted];
      this.askNext();
    });
  }

  arrived(request: number, png: Blob): void {
    const wanted = this.outstanding.get(request);
    this.outstanding.delete(request);
    this.pauses = 0;
    wanted?.made(png);
    this.askNext();
  }

  /**
   * Whether the refused request was one for a still. Messages that come too fast are refused without
   * a word of which they were: any that is outstanding may be among them.
   */
  refused(error: ErrorMessage): boolean {
    if (error.request === undefined) {
      if (error.code === 'rate-limited') this.takeBack([...this.outstanding.keys()], error);
      return false;
    }
    const is_own = this.outstanding.has(error.request);
    if (is_own) this.takeBack([error.request], error);
    return is_own;
  }

  /** What a lost connection was asked for will not come. */
  interrupted(): void {
    this.is_served = false;
    this.endPause();
    this.putBack([...this.outstanding.keys()]);
    this.tell();
  }

  /** The server shows the page's scene, perhaps again. */
  served(): void {
    this.is_served = true;
    this.askNext();
  }

  private giveUp(wanted: Wanted, reason: unknown): void {
    wanted.given_up = true;
    this.waiting = this.waiting.filter((one) => one !== wanted);
    wanted.failed(reason);
    this.tell();
  }

  private takeBack(requests: readonly number[], error: ErrorMessage): void {
    const most = REPEATS[error.code] ?? 0;
    for (const request of requests) {
      const wanted = this.outstanding.get(request);
      if (!wanted || ++wanted.refusals <= most) continue;
      this.outstanding.delete(request);
      wanted.failed(new ExportError(errorTitle(error), errorDetail(error)));
    }
    if (this.putBack(requests)) this.pause ??= setTimeout(() => this.goOn(), this.nextPauseMs());
    this.askNext();
  }

  /** Whether there is one that somebody still waits for. */
  private putBack(requests: readonly number[]): boolean {
    const back = requests.flatMap((request) => this.outstanding.get(request) ?? []);
    for (const request of requests) this.outstanding.delete(request);
    const wanted = back.filter(({ given_up }) => !given_up);
    for (const one of wanted)
      if (one.scene_then) one.still = { ...one.still, scene: one.scene_then };
    this.waiting = [...wanted, ...this.waiting];
    return wanted.length > 0;
  }

  private nextPauseMs(): number {
    return Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** this.pauses++);
  }

  private goOn(): void {
    this.endPause();
    this.askNext();
  }

  private endPause(): void {
    clearTimeout(this.pause);
    this.pause = undefined;
  }

  private tell(): void {
    this.lags(this.waiting.length > 0 && (!this.is_served || this.pause !== undefined));
  }

  private askNext(): void {
    while (this.waiting[0] && this.mayAsk()) this.ask(this.waiting[0]);
    this.tell();
  }

  private mayAsk(): boolean {
    const { is_served, pause, outstanding } = this;
    return is_served && pause === undefined && outstanding.size < STILLS_IN_FLIGHT;
  }

  private ask(wanted: Wanted): void {
    this.waiting = this.waiting.slice(1);
    const request = this.requests.next();
    this.outstanding.set(request, wanted);
    this.changes.flush();
    this.stream.send({ type: 'save_still', request, ...wanted.still });
  }
}
