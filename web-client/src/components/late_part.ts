// Code that comes when it is first needed.
import type { ReactiveControllerHost } from 'lit';
import type { Toasts } from '../session/toasts.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { words } from '../words/words.ts';

export class LatePart {
  private coming: Promise<boolean> | undefined;
  private is_loaded = false;
  private is_asked_for = false;

  /** `host` is drawn again once the code is there. */
  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly load: () => Promise<unknown>,
  ) {}

  get is_there(): boolean {
    return this.is_loaded;
  }

  /** Where it cannot be had it says so, and `give_up` closes what it was wanted for. */
  async ask(toasts: Toasts, give_up: () => void): Promise<void> {
    if (this.is_loaded || this.is_asked_for) return;
    this.is_asked_for = true;
    const came = await this.come();
    this.is_asked_for = false;
    if (came) return;
    give_up();
    const { part_missing, part_missing_detail } = words().messages;
    toasts.problem(part_missing, part_missing_detail);
  }

  /** Before anybody asks for it: where it cannot be had, nobody needs to hear of that yet. */
  async foresee(): Promise<void> {
    await this.come();
  }

  private come(): Promise<boolean> {
    this.coming ??= this.load().then(
      () => this.arrived(),
      () => this.missed(),
    );
    return this.coming;
  }

  private arrived(): true {
    this.is_loaded = true;
    this.host.requestUpdate();
    return true;
  }

  private missed(): false {
    this.coming = undefined;
    return false;
  }
}

/** What comes then delays no first picture. */
export function afterFirstPicture(store: Store<ViewerState>, run: () => void): void {
  if (store.state.shown) return run();
  const end = store.subscribe(({ shown }) => {
    if (!shown) return;
    end();
    run();
  });
}
