// The measuring tools, over the picture.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { MEASUREMENT_KINDS, type MeasurementKind } from '../view/measurement.ts';
import { toolInHand } from '../state/measure_state.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-measure-toolbar')
export class MeasureToolbar extends SessionElement {
  protected override readonly draws = ['measure', 'volume'] as const;

  static override styles = [
    shared,
    css`
      :host {
        position: absolute;
        top: 12px;
        left: 12px;
        pointer-events: none;
      }
      [role='toolbar'] {
        display: grid;
        gap: 2px;
        padding: 3px;
        border: 1px solid rgb(255 255 255 / 10%);
        border-radius: 11px;
        background: rgb(10 13 15 / 66%);
        pointer-events: auto;
      }
      .icon-button {
        color: #cfd8dd;
      }
      .icon-button[aria-pressed='true'] {
        background: var(--accent);
        color: var(--on-accent);
      }
    `,
  ];

  override render() {
    if (!this.state.volume) return nothing;
    return html`<div role="toolbar" aria-label=${words().measure.tools} aria-orientation="vertical">
      ${MEASUREMENT_KINDS.map((kind) => this.button(kind))}
    </div>`;
  }

  private button(kind: MeasurementKind) {
    const title = words().measure.tool_titles[kind];
    return html`<button
      class="icon-button"
      aria-label=${title}
      aria-pressed=${toolInHand(this.state.measure) === kind ? 'true' : 'false'}
      title=${title}
      data-tool=${kind}
      @click=${() => this.session.measuring.take(kind)}
    >
      <wa-icon name=${kind}></wa-icon>
    </button>`;
  }
}
