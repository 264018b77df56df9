// What must be known of the picture at all times: that it is no diagnostic image, and whether it is
// compressed.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shownIn, viewChoice } from '../state/slice_views.ts';
import { visibleViews } from '../state/views.ts';
import { ViewElement } from './view_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-picture-notices')
export class PictureNotices extends ViewElement {
  protected override readonly draws = [
    'capabilities',
    'shown',
    'slice_views',
    'preferences',
    'maximised',
  ] as const;

  static override styles = css`
    :host {
      position: absolute;
      left: 10px;
      bottom: 10px;
      display: flex;
      flex-wrap: wrap;
      gap: 6px;
      max-width: calc(50% - 40px);
      pointer-events: none;
    }
    span {
      padding: 3px 8px;
      border-radius: 5px;
      background: var(--on-picture-surface);
      color: var(--on-picture-text);
      font-size: 12px;
    }
    .notice {
      color: var(--on-picture-warning);
    }
    /* Where there is little room, one of the pictures says it for all. */
    @container (max-width: 340px) {
      :host {
        max-width: calc(100% - 20px);
      }
      :host([first]) {
        bottom: 36px;
      }
      span {
        font-size: 11px;
      }
      :host(:not([first])) .notice {
        display: none;
      }
    }
    @container (max-width: 170px) {
      :host {
        left: 4px;
      }
      span {
        padding: 1px 4px;
      }
    }
  `;

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const [first] = visibleViews(viewChoice(this.state));
    this.toggleAttribute('first', first === this.view);
  }

  override render() {
    const { capabilities } = this.state;
    const shown = shownIn(this.state, this.view);
    const texts = words().page;
    const lossy = shown !== undefined && !shown.lossless;
    return html`
      <span class="notice" data-part="notice"
        >${capabilities?.notice ?? texts.not_for_diagnosis}</span
      >
      ${lossy ? html`<span data-part="lossy" title=${texts.lossy_hint}>${texts.lossy}</span>` : nothing}
    `;
  }
}
