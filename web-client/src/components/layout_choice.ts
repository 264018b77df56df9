// How the views are laid out: one icon each.
import { css, html } from 'lit';
import { customElement } from 'lit/decorators.js';
import { LAYOUTS, type Layout } from '../state/views.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-layout-choice')
export class LayoutChoice extends SessionElement {
  protected override readonly draws = ['preferences', 'volume'] as const;

  static override styles = [
    shared,
    css`
      [role='group'] {
        display: flex;
        gap: 1px;
      }
      .icon-button[aria-pressed='true'] {
        color: var(--accent-strong);
      }
      .cycle {
        display: none;
      }
      @media (max-width: 720px) {
        [role='group'] {
          display: none;
        }
        .cycle {
          display: inline-grid;
        }
      }
    `,
  ];

  override render() {
    const { layout } = this.state.preferences;
    const { slices } = words();
    return html`<div role="group" aria-label=${slices.layout}>
        ${LAYOUTS.map((one) => this.button(one, slices.layouts[one], one === layout))}
      </div>
      <button
        class="icon-button cycle"
        aria-label="${slices.layout}: ${slices.layouts[layout]}"
        title="${slices.layout} (g)"
        data-part="next-layout"
        @click=${() => this.session.layout.next()}
      >
        <wa-icon name="layout-${layout}"></wa-icon>
      </button>`;
  }

  private button(layout: Layout, label: string, chosen: boolean) {
    return html`<button
      class="icon-button"
      aria-label=${label}
      aria-pressed=${chosen ? 'true' : 'false'}
      title="${label} (g)"
      data-layout=${layout}
      @click=${() => this.session.layout.choose(layout)}
    >
      <wa-icon name="layout-${layout}"></wa-icon>
    </button>`;
  }
}
