// One immutable state, replaced by changes; who listens is told after each.

export type Listener<State> = (state: State, before: State) => void;

export class Store<State extends object> {
  private current: State;
  private readonly listeners = new Set<Listener<State>>();

  constructor(initial: State) {
    this.current = initial;
  }

  get state(): State {
    return this.current;
  }

  /** Listeners are not called where every given field is what it was. */
  update(change: Partial<State>): void {
    const before = this.current;
    const keys = Object.keys(change) as (keyof State)[];
    if (keys.every((key) => Object.is(before[key], change[key]))) return;
    this.current = { ...before, ...change };
    for (const listener of [...this.listeners]) listener(this.current, before);
  }

  /** Returns the function that ends the subscription. */
  subscribe(listener: Listener<State>): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
