// Code that comes when it is first needed.
import type { ReactiveControllerHost } from 'lit';
import type { Toasts } from '../session/toasts.ts';
import { words } from '../words/words.ts';

export class LatePart {
  private phase: 'unknown' | 'asked for' | 'there' = 'unknown';

  /** `host` is drawn again once the code is there. */
  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly load: () => Promise<unknown>,
  ) {}

  get is_there(): boolean {
    return this.phase === 'there';
  }

  /** Once is enough. Says so where it cannot be had: a browser does not ask a second time. */
  async ask(toasts: Toasts): Promise<void> {
    if (this.phase !== 'unknown') return;
    this.phase = 'asked for';
    try {
      await this.load();
      this.phase = 'there';
      this.host.requestUpdate();
    } catch {
      const { part_missing, part_missing_detail } = words().messages;
      toasts.problem(part_missing, part_missing_detail);
    }
  }
}
