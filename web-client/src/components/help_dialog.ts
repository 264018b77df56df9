// Gestures and keys.
import { css, html } from 'lit';
import { customElement, query } from 'lit/decorators.js';
import { shared } from '../styles/shared.ts';
import { keyList } from './key_list.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-help-dialog')
export class HelpDialog extends SessionElement {
  protected override readonly draws = ['help_open', 'capabilities'] as const;

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
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding: 12px 12px 4px 20px;
      }
      h2 {
        font-size: 17px;
        font-weight: 600;
      }
      .body {
        padding: 0 20px 20px;
      }
      h3 {
        margin: 14px 0 6px;
        color: var(--text-quiet);
        font-size: 12px;
        font-weight: 500;
      }
      h4 {
        margin: 10px 0 2px;
        font-size: 13px;
        font-weight: 600;
      }
      dl {
        display: grid;
        grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
        gap: 1px;
      }
      dt,
      dd {
        padding: 5px 0;
        border-bottom: 1px solid var(--line);
      }
      dt {
        color: var(--accent-strong);
      }
      .about {
        margin-top: 16px;
      }
    `,
  ];

  override updated(): void {
    const { help_open } = this.state;
    if (help_open && !this.dialog.open) this.dialog.showModal();
    if (!help_open && this.dialog.open) this.dialog.close();
  }

  override render() {
    const row = (what: string, meaning: string) =>
      html`<dt>${what}</dt>
        <dd>${meaning}</dd>`;
    const { keys, page } = words();
    const notice = this.state.capabilities?.notice ?? page.not_for_diagnosis;
    return html`<dialog
      aria-labelledby="heading"
      @close=${() => this.session.commands.toggleHelp(false)}
      @click=${this.onClick}
    >
      <div class="head">
        <h2 id="heading">${keys.help}</h2>
        <button
          class="icon-button"
          aria-label=${keys.close}
          autofocus
          @click=${() => this.session.commands.toggleHelp(false)}
        >
          <wa-icon name="close"></wa-icon>
        </button>
      </div>
      <div class="body">
        <h3>${keys.gestures_heading}</h3>
        <dl>${Object.values(keys.gestures).map(([what, meaning]) => row(what, meaning))}</dl>
        <h3>${keys.slice_gestures_heading}</h3>
        <dl>${Object.values(keys.slice_gestures).map(([what, meaning]) => row(what, meaning))}</dl>
        <h3>${keys.keys_heading}</h3>
        ${keyList()}
        <p class="quiet small about">
          ${keys.about(notice.replace(/\.?$/, '.'))} ${this.state.capabilities?.server ?? ''}
        </p>
      </div>
    </dialog>`;
  }

  /** A click beside the sheet closes it. */
  private onClick(event: MouseEvent): void {
    if (event.target === this.dialog) this.session.commands.toggleHelp(false);
  }
}
