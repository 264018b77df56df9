// Gestures and keys.
import { css, html } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shared } from '../styles/shared.ts';
import { keyList } from './key_list.ts';
import './modal.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-help-dialog')
export class HelpDialog extends SessionElement {
  protected override readonly draws = ['help_open', 'capabilities'] as const;

  static override styles = [
    shared,
    css`
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
        gap: 1px 0;
      }
      dt,
      dd {
        padding: 5px 0;
        border-bottom: 1px solid var(--line);
      }
      dt {
        padding-right: 8px;
        color: var(--accent-strong);
      }
      .about {
        margin-top: 16px;
      }
    `,
  ];

  override render() {
    const row = (what: string, meaning: string) =>
      html`<dt>${what}</dt>
        <dd>${meaning}</dd>`;
    const { keys, page } = words();
    const notice = this.state.capabilities?.notice ?? page.not_for_diagnosis;
    return html`<cutaway-modal
      heading=${keys.help}
      ?open=${this.state.help_open}
      .closed=${() => this.session.commands.toggleHelp(false)}
    >
      <h3>${keys.gestures_heading}</h3>
      <dl>${Object.values(keys.gestures).map(([what, meaning]) => row(what, meaning))}</dl>
      <h3>${keys.slice_gestures_heading}</h3>
      <dl>${Object.values(keys.slice_gestures).map(([what, meaning]) => row(what, meaning))}</dl>
      <h3>${keys.keys_heading}</h3>
      ${keyList()}
      <p class="quiet small about">
        ${keys.about(notice.replace(/\.?$/, '.'))} ${this.state.capabilities?.server ?? ''}
      </p>
    </cutaway-modal>`;
  }
}
