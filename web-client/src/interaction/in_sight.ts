// Which parts of a component can be seen, so that pictures are asked for of those alone.
import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** What a part is called: its `data-card`. */
const nameOf = (part: Element): string => (part as HTMLElement).dataset['card'] ?? '';

export class InSight implements ReactiveController {
  private readonly seen = new Set<Element>();
  private watched = new WeakSet<Element>();
  private readonly observer = new IntersectionObserver((entries) => this.changed(entries));

  /** `told` hears of every change, and after each drawing: a part may then be another's. */
  constructor(
    private readonly host: ReactiveControllerHost & { readonly renderRoot: ParentNode },
    private readonly told: () => void,
  ) {
    host.addController(this);
  }

  /** Names of the parts that can be seen. */
  get names(): ReadonlySet<string> {
    return new Set([...this.seen].map(nameOf));
  }

  hostUpdated(): void {
    for (const part of this.host.renderRoot.querySelectorAll('[data-card]')) {
      if (this.watched.has(part)) continue;
      this.watched.add(part);
      this.observer.observe(part);
    }
    this.told();
  }

  hostDisconnected(): void {
    this.observer.disconnect();
    this.seen.clear();
    this.watched = new WeakSet();
  }

  private changed(entries: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) this.seen.add(target);
      else this.seen.delete(target);
    }
    this.told();
  }
}
