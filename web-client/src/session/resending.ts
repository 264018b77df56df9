// What comes too fast is not heeded by the server, which says so once a second and not of which
// message: what the page shows goes out again once it is quiet.
import type { ErrorMessage } from '../protocol/messages.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';

/** Refusals within a second after one that was said are not said. */
const QUIET_MS = 1_500;

export interface Resent {
  readonly presence: { restart(): void };
  readonly link: { repeat(): void };
  readonly layout: { restart(): void };
  /** Which cannot be asked again: the pointer is elsewhere. */
  readonly picker: { restart(): void };
}

export class Resending {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly parts: Resent,
  ) {}

  refused({ code, input, request }: ErrorMessage): void {
    if (code !== 'rate-limited' || input !== undefined || request !== undefined) return;
    this.parts.picker.restart();
    this.wait();
  }

  /** A new connection is told everything anyhow. */
  restart(): void {
    clearTimeout(this.timer);
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.end(), QUIET_MS);
  }

  private end(): void {
    const { link, loading } = this.store.state;
    if (link.phase !== 'connected') return;
    if (loading) return this.wait();
    this.parts.presence.restart();
    this.parts.link.repeat();
    this.parts.layout.restart();
  }
}
