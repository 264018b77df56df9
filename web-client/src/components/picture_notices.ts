// What must be known of the picture at all times: that it is no diagnostic image, and whether it is
// compressed.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-picture-notices')
export class PictureNotices extends SessionElement {
  protected override readonly draws = ['capabilities', 'shown'] as const;

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
  `;

  override render() {
    const { capabilities, shown } = this.state;
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
