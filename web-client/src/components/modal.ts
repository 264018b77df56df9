// A sheet over the page, that everything else waits for. Escape, a press beside it and its button
// close it.
import { css, html, LitElement } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-modal')
export class Modal extends LitElement {
  @property() heading = '';
  @property({ type: Boolean }) open = false;
  /** The user has closed it, or wants to. */
  @property({ attribute: false }) closed!: () => void;

  @query('dialog') private dialog!: HTMLDialogElement;

  static override styles = [
    shared,
    css`
      dialog {
        width: min(560px, calc(100vw - 24px));
        max-height: calc(100dvh - 24px);
        padding: 0;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--surface);
        color: var(--text);
        box-shadow: var(--shadow);
      }
      dialog::backdrop {
        background: rgb(0 0 0 / 55%);
      }
      .head {
        position: sticky;
        z-index: 1;
        top: 0;
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding: 12px 12px 4px 20px;
        background: var(--surface);
      }
      h2 {
        font-size: 17px;
        font-weight: 600;
      }
      .body {
        padding: 0 20px 20px;
      }
    `,
  ];

  override updated(): void {
    if (this.open && !this.dialog.open) this.dialog.showModal();
    if (!this.open && this.dialog.open) this.dialog.close();
  }

  override render() {
    const close = words().keys.close;
    return html`<dialog
      aria-labelledby="heading"
      @close=${() => this.closed()}
      @click=${this.onClick}
    >
      <div class="head">
        <h2 id="heading">${this.heading}</h2>
        <button
          class="icon-button"
          aria-label=${close}
          title=${close}
          autofocus
          @click=${() => this.closed()}
        >
          <wa-icon name="close"></wa-icon>
        </button>
      </div>
      <div class="body"><slot></slot></div>
    </dialog>`;
  }

  /** What lies in the sheet is another target. */
  private onClick(event: MouseEvent): void {
    if (event.target === this.dialog) this.closed();
  }
}
