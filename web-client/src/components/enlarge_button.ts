// Makes a view the large or the only one, and goes back.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { viewChoice } from '../state/slice_views.ts';
import { loneView } from '../state/views.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { ViewElement } from './view_element.ts';

@customElement('cutaway-enlarge-button')
export class EnlargeButton extends ViewElement {
  protected override readonly draws = ['preferences', 'maximised'] as const;

  static override styles = [
    shared,
    css`
      :host {
        position: absolute;
        top: 4px;
        right: 4px;
      }
      .icon-button {
        width: 32px;
        height: 32px;
        background: var(--on-picture-surface);
        color: var(--on-picture-text);
      }
      .icon-button:hover {
        background: #33414a;
        color: #fff;
      }
      /* Its target reaches to the picture's corner. */
      @media (pointer: coarse) {
        .icon-button::after {
          content: '';
          position: absolute;
          inset: -4px -4px -8px -8px;
        }
      }
    `,
  ];

  override render() {
    const choice = viewChoice(this.state);
    const alone = loneView(choice) === this.view;
    if (alone && !choice.maximised && this.view === '3d') return nothing;
    const { slices } = words();
    const name = slices.names[this.view];
    const label = alone ? slices.shrink(name) : slices.enlarge(name);
    return html`<button
      class="icon-button"
      aria-label=${label}
      title=${label}
      data-part="enlarge"
      @click=${() => this.session.layout.enlarge(this.view)}
    >
      <wa-icon name=${alone ? 'shrink' : 'enlarge'}></wa-icon>
    </button>`;
  }
}
