// The gallery's pictures: the user's own scene in each style, rendered by the server. They
// are asked for while somebody looks at the gallery, a few at a time, once the scene has come to
// rest.
import { previewSubject } from '../state/preview_subject.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import type { Viewport } from '../view/camera.ts';
import type { PreviewRequests, PreviewWish } from './preview_requests.ts';

const REST_MS = 1_000;
/** Live frames share the renderer with them. */
const MOST_OUTSTANDING = 2;

/** A style of the server's by its name, an own one by what it changes. */
export interface StyleWish {
  /** Where its picture is kept. */
  readonly key: string;
  readonly preview: Pick<PreviewWish, 'style' | 'scene'>;
}

/** Who shows them. */
export type StyleShelf = 'served' | 'own';

export class StylePreviews {
  private readonly shelves: Record<StyleShelf, readonly StyleWish[]> = { served: [], own: [] };
  private size: Viewport | undefined;
  private subject = '';
  /** Counts up when all pictures are out of date. */
  private round = 0;
  /** By key: the round whose picture, or failure, is here. */
  private readonly answered = new Map<string, number>();
  /** Keys of those that are on their way. */
  private readonly asked = new Set<string>();
  /** The last picture of the connection before. */
  private shown_before: ShownFrame | undefined;
  private resting = false;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly requests: PreviewRequests,
  ) {
    store.subscribe((state, before) => this.changed(state, before));
  }

  /** The styles that can be seen now, those to be drawn first in front; none where they are hidden. */
  want(shelf: StyleShelf, styles: readonly StyleWish[]): void {
    this.shelves[shelf] = styles;
    this.askNext();
  }

  /** Of all pictures, device pixels. Another size makes them all out of date. */
  resize(size: Viewport): void {
    const { width_px, height_px } = this.size ?? {};
    if (size.width_px === width_px && size.height_px === height_px) return;
    this.size = size;
    this.round += 1;
    this.askNext();
  }

  /** What a lost connection was asked for will not come; a new one has nothing to draw at first. */
  restart(): void {
    this.asked.clear();
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
    const wishes = [...this.shelves.served, ...this.shelves.own];
    for (const wish of wishes.filter(({ key }) => this.isDue(key))) {
      if (this.asked.size >= MOST_OUTSTANDING) return;
      this.ask(wish, size);
    }
  }

  /** Not while anything moves, and not before the refined picture itself is there. */
  private mayAsk(): boolean {
    const { link, volume, loading, pointer_held, shown } = this.store.state;
    const showing = link.phase === 'connected' && volume !== undefined && !loading;
    const refined = shown?.still === true && shown !== this.shown_before;
    return showing && refined && this.resting && !pointer_held;
  }

  private isDue(key: string): boolean {
    return !this.asked.has(key) && this.answered.get(key) !== this.round;
  }

  private ask({ key, preview }: StyleWish, size: Viewport): void {
    const { round } = this;
    this.asked.add(key);
    this.requests.ask({ ...preview, ...size }, (picture) => {
      this.asked.delete(key);
      // One that was asked for before the scene changed may show anything in between.
      if (round === this.round) this.keep(key, picture);
      else picture?.close();
      this.askNext();
    });
  }

  private keep(key: string, picture: ImageBitmap | undefined): void {
    this.answered.set(key, this.round);
    const previews = new Map(this.store.state.previews);
    const old = previews.get(key);
    if (picture) previews.set(key, picture);
    else previews.delete(key);
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
