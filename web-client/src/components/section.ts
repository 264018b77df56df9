// A foldable part of the panel.
import { css, html, LitElement, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { words } from '../words/words.ts';
import { shared } from '../styles/shared.ts';

@customElement('cutaway-section')
export class PanelSection extends LitElement {
  @property() heading = '';
  @property() hint = '';
  @property({ type: Boolean }) open = false;
  /** Puts the part back; without it there is no button for that. */
  @property({ attribute: false }) reset: (() => void) | undefined;

  static override styles = [
    shared,
    css`
      :host {
        position: relative;
        display: block;
        border-bottom: 1px solid var(--line);
      }
      summary {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 44px;
        padding: 0 2px;
        cursor: pointer;
        list-style: none;
      }
      summary::-webkit-details-marker {
        display: none;
      }
      summary wa-icon {
        margin-left: auto;
        color: var(--text-quiet);
        transition: transform 160ms;
      }
      details[open] summary wa-icon {
        transform: rotate(180deg);
      }
      h2 {
        font-size: 14px;
        font-weight: 600;
      }
      .reset {
        position: absolute;
        top: 4px;
        right: 30px;
      }
      details:not([open]) + .reset {
        display: none;
      }
      @media (pointer: coarse) {
        .reset {
          top: 0;
        }
      }
      .body {
        display: grid;
        gap: 10px;
        padding: 2px 2px 18px;
      }
    `,
  ];

  override render() {
    return html`<details ?open=${this.open}>
        <summary>
          <h2>${this.heading}</h2>
          <span class="quiet small">${this.hint}</span>
          <wa-icon name="down"></wa-icon>
        </summary>
        <div class="body"><slot></slot></div>
      </details>
      ${this.resetButton()}`;
  }

  /** Beside the heading rather than in it: a control within a control cannot be reached. */
  private resetButton() {
    if (!this.reset) return nothing;
    const label = words().panel.reset(this.heading);
    return html`<button
      class="icon-button reset"
      aria-label=${label}
      title=${label}
      @click=${this.reset}
    >
      <wa-icon name="reset"></wa-icon>
    </button>`;
  }
}
