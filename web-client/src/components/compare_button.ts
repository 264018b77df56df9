// Shows the previous style for as long as it is held, by mouse, finger or key.
import { css, html } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

const HOLDING_KEYS: ReadonlySet<string> = new Set([' ', 'Enter']);

@customElement('cutaway-compare-button')
export class CompareButton extends SessionElement {
  protected override readonly draws = ['comparing', 'can_undo'] as const;

  static override styles = [
    shared,
    css`
      :host {
        display: block;
        margin-bottom: 14px;
      }
      button {
        display: flex;
        align-items: center;
        justify-content: center;
        gap: 8px;
        width: 100%;
        touch-action: none;
        user-select: none;
        -webkit-user-select: none;
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        background: var(--accent);
        color: var(--on-accent);
      }
    `,
  ];

  override render() {
    const { hold_to_compare, hold_to_compare_hint } = words().panel.styles;
    return html`<button
      class="text-button"
      title="${hold_to_compare_hint} (b)"
      aria-pressed=${this.state.comparing ? 'true' : 'false'}
      ?disabled=${!this.state.can_undo}
      data-part="compare"
      @pointerdown=${this.press}
      @pointerup=${this.release}
      @pointercancel=${this.release}
      @lostpointercapture=${this.release}
      @contextmenu=${(event: Event) => event.preventDefault()}
      @keydown=${this.onKey}
      @keyup=${this.release}
      @blur=${this.release}
    >
      <wa-icon name="compare"></wa-icon>${hold_to_compare}
    </button>`;
  }

  private press(event: PointerEvent): void {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.session.commands.compare(true);
  }

  private release(): void {
    this.session.commands.compare(false);
  }

  private onKey(event: KeyboardEvent): void {
    if (!HOLDING_KEYS.has(event.key)) return;
    event.preventDefault();
    if (!event.repeat) this.session.commands.compare(true);
  }
}
