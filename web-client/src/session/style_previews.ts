// The gallery's pictures: the user's own scene in each named style, rendered by the server. They
// are asked for while somebody looks at the gallery, a few at a time, once the scene has come to
// rest.
import type { Counter } from '../protocol/counter.ts';
import { previewSubject } from '../state/preview_subject.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { Stream } from '../stream/stream.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import type { Viewport } from '../view/camera.ts';

const REST_MS = 1_000;
/** Live frames share the renderer with them. */
const MOST_OUTSTANDING = 2;

interface Asked {
  readonly style: string;
  readonly round: number;
}

export class StylePreviews {
  private wanted: readonly string[] = [];
  private size: Viewport | undefined;
  private subject = '';
  /** Counts up when all pictures are out of date. */
  private round = 0;
  /** By style: the round whose picture, or failure, is here. */
  private readonly answered = new Map<string, number>();
  /** By request. */
  private readonly outstanding = new Map<number, Asked>();
  /** The last picture of the connection before. */
  private shown_before: ShownFrame | undefined;
  private resting = false;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly stream: Stream,
    private readonly requests: Counter,
  ) {
    store.subscribe((state, before) => this.changed(state, before));
  }

  /** The styles that the gallery shows now, those to be drawn first in front; none where it is hidden. */
  want(styles: readonly string[], size: Viewport | undefined): void {
    this.wanted = styles;
    const { width_px, height_px } = this.size ?? {};
    if (size && (size.width_px !== width_px || size.height_px !== height_px)) {
      this.size = size;
      this.round += 1;
    }
    this.askNext();
  }

  /**
   * Takes the picture over; there is none where it could not be decoded. One that was asked for
   * before the scene changed may show anything in between, and is dropped.
   */
  arrived(request: number, picture: ImageBitmap | undefined): void {
    const asked = this.outstanding.get(request);
    this.outstanding.delete(request);
    if (asked?.round === this.round) this.keep(asked, picture);
    else picture?.close();
    this.askNext();
  }

  /** Whether the refused request was one for a preview; its style goes without until the next round. */
  refused(request: number | undefined): boolean {
    if (request === undefined || !this.outstanding.has(request)) return false;
    this.arrived(request, undefined);
    return true;
  }

  /** What a lost connection was asked for will not come; a new one has nothing to draw at first. */
  restart(): void {
    this.outstanding.clear();
    this.shown_before = this.store.state.shown;
  }

  private changed(state: ViewerState, before: ViewerState): void {
    if (state.volume?.id !== before.volume?.id) this.forgetAll();
    if (state.scene && state.scene !== before.scene) this.sceneChanged(previewSubject(state.scene));
    this.askNext();
  }

  private sceneChanged(subject: string): void {
    if (subject === this.subject) return;
    this.subject = subject;
    this.round += 1;
    this.resting = false;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.resting = true;
      this.askNext();
    }, REST_MS);
  }

  private askNext(): void {
    const { size } = this;
    if (!size || !this.mayAsk()) return;
    for (const style of this.wanted.filter((name) => this.isDue(name))) {
      if (this.outstanding.size >= MOST_OUTSTANDING) return;
      this.ask(style, size);
    }
  }

  /** Not while anything moves, and not before the refined picture itself is there. */
  private mayAsk(): boolean {
    const { link, volume, loading, pointer_held, shown } = this.store.state;
    const showing = link.phase === 'connected' && volume !== undefined && !loading;
    const refined = shown?.still === true && shown !== this.shown_before;
    return showing && refined && this.resting && !pointer_held;
  }

  private isDue(style: string): boolean {
    const asked = [...this.outstanding.values()].some((one) => one.style === style);
    return !asked && this.answered.get(style) !== this.round;
  }

  private ask(style: string, size: Viewport): void {
    const request = this.requests.next();
    this.outstanding.set(request, { style, round: this.round });
    this.stream.send({ type: 'preview', request, style, ...size });
  }

  private keep({ style, round }: Asked, picture: ImageBitmap | undefined): void {
    this.answered.set(style, round);
    const previews = new Map(this.store.state.previews);
    const old = previews.get(style);
    if (picture) previews.set(style, picture);
    else previews.delete(style);
    this.store.update({ previews });
    old?.close();
  }

  private forgetAll(): void {
    const { previews } = this.store.state;
    this.answered.clear();
    this.store.update({ previews: new Map() });
    for (const picture of previews.values()) picture.close();
  }
}
