// What must be known of the picture at all times: that it is no diagnostic image, and whether it is
// compressed.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shownIn, viewChoice } from '../state/slice_views.ts';
import { visibleViews, type ViewName } from '../state/views.ts';
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
      max-width: calc(50% - 24px);
      pointer-events: none;
    }
    span {
      box-sizing: border-box;
      padding: 3px 8px;
      border-radius: 5px;
      background: var(--on-picture-surface);
      color: var(--on-picture-text);
      font-size: 12px;
    }
    .notice {
      color: var(--on-picture-warning);
    }
    /* Above the other one, it has the picture's whole width: no letter is in its way there. */
    .notice:not(:only-child) {
      flex: none;
      width: max-content;
      max-width: calc(100cqw - 20px);
    }
    /* Where there is little room, one of the pictures says it for all. */
    @container (max-width: 340px) {
      span {
        font-size: 11px;
      }
      :host(:not([first])) .notice {
        display: none;
      }
    }
    @container (max-width: 220px) {
      :host {
        left: 4px;
        max-width: calc(100% - 8px);
      }
      :host([first]) {
        bottom: 36px;
      }
      :host(:not([first])) {
        display: none;
      }
    }
  `;

  /** The pictures that it speaks of: the first one may be the only one with room for it. */
  private views: readonly ViewName[] = [];

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const visible = visibleViews(viewChoice(this.state));
    const is_first = visible[0] === this.view;
    this.views = is_first ? visible : [this.view];
    this.toggleAttribute('first', is_first);
  }

  override render() {
    const { capabilities } = this.state;
    const texts = words().page;
    const lossy = this.views.some((view) => shownIn(this.state, view)?.lossless === false);
    return html`
      <span class="notice" data-part="notice"
        >${capabilities?.notice ?? texts.not_for_diagnosis}</span
      >
      ${lossy ? html`<span data-part="lossy" title=${texts.lossy_hint}>${texts.lossy}</span>` : nothing}
    `;
  }
}
