// Tells the server whether the page is seen, and takes a session up again that went to another while
// its user was away.
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { Stream } from '../stream/stream.ts';

/** What the page knows of its user. */
export interface PageSight {
  readonly visible: () => boolean;
  /** `seen`: it came into sight or went out of it; `used`: a pointer or a key moved. */
  readonly watch: (seen: () => void, used: () => void) => void;
}

export class Presence {
  constructor(
    private readonly store: Store<ViewerState>,
    private readonly stream: Stream,
    private readonly sight: PageSight,
  ) {
    sight.watch(
      () => this.seen(),
      () => this.resume(),
    );
  }

  /** A session begins: it counts as unseen until it was told otherwise. */
  restart(): void {
    this.stream.send({ type: 'presence', visible: this.sight.visible() });
  }

  private seen(): void {
    if (this.store.state.link.phase === 'connected') this.restart();
    this.resume();
  }

  /** Hidden, it would only be taken away again. */
  private resume(): void {
    const gave_way = this.store.state.link.phase === 'gave_way';
    if (gave_way && this.sight.visible()) this.stream.connectNow();
  }
}

export function pageSight(page: Document, view: Window): PageSight {
  return {
    visible: () => page.visibilityState === 'visible',
    watch: (seen, used) => {
      page.addEventListener('visibilitychange', seen);
      for (const sign of ['pointermove', 'pointerdown', 'keydown', 'wheel', 'focus'] as const)
        view.addEventListener(sign, used, { capture: true, passive: true });
    },
  };
}
