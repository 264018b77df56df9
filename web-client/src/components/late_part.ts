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

  /** Where it cannot be had it says so, and `give_up` closes what it was wanted for. */
  async ask(toasts: Toasts, give_up: () => void): Promise<void> {
    if (this.phase !== 'unknown') return;
    this.phase = 'asked for';
    try {
      await this.load();
      this.phase = 'there';
      this.host.requestUpdate();
    } catch {
      this.phase = 'unknown';
      give_up();
      const { part_missing, part_missing_detail } = words().messages;
      toasts.problem(part_missing, part_missing_detail);
    }
  }
}
