// What must be known of the picture at all times: that it is no diagnostic image, and whether it is
// compressed.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { SessionElement } from './session_element.ts';

const FALLBACK_NOTICE = 'Not for diagnostic use';

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
      background: rgb(10 13 15 / 74%);
      color: #cfd8dd;
      font-size: 12px;
    }
    .notice {
      color: var(--warning);
    }
  `;

  override render() {
    const { capabilities, shown } = this.state;
    const lossy = shown !== undefined && !shown.lossless;
    return html`
      <span class="notice" data-part="notice">${capabilities?.notice ?? FALLBACK_NOTICE}</span>
      ${lossy ? html`<span data-part="lossy" title="JPEG-compressed">lossy</span>` : nothing}
    `;
  }
}
