// A component that draws a part of the session's state.
import { LitElement } from 'lit';
import { property } from 'lit/decorators.js';
import type { ViewerSession } from '../session/viewer_session.ts';
import type { ViewerState } from '../state/viewer_state.ts';

export abstract class SessionElement extends LitElement {
  /** The parts of the state that it draws: only a change of these draws it
   * again, and one of the language. */
  protected abstract readonly draws: readonly (keyof ViewerState)[];

  @property({ attribute: false }) session!: ViewerSession;

  private unsubscribe: (() => void) | undefined;

  protected get state(): ViewerState {
    return this.session.store.state;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.unsubscribe = this.session.store.subscribe((state, before) => {
      const parts = [...this.draws, 'language'] as const;
      if (parts.some((part) => state[part] !== before[part])) this.requestUpdate();
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.unsubscribe?.();
  }
}
