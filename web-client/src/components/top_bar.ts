// Whose picture it is, the connection, and what can be done with the whole view.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { copyText } from '../session/copy_text.ts';
import { volumeFacts } from '../state/volume_text.ts';
import { shared } from '../styles/shared.ts';
import './layout_choice.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-top-bar')
export class TopBar extends SessionElement {
  protected override readonly draws = [
    'link',
    'volume',
    'preferences',
    'shown',
    'can_undo',
    'can_redo',
    'lens_follows',
  ] as const;

  static override styles = [
    shared,
    css`
      :host {
        display: flex;
        align-items: center;
        gap: 12px;
        min-width: 0;
        padding: 0 8px 0 14px;
        border-bottom: 1px solid var(--line);
        background: var(--surface);
      }
      .brand {
        display: flex;
        align-items: center;
        gap: 9px;
        margin: 0;
        font-size: 14px;
        font-weight: 650;
        letter-spacing: 0.01em;
      }
      .brand img {
        width: 24px;
        height: 24px;
        border-radius: 6px;
      }
      .volume {
        flex: 1;
        min-width: 0;
        padding-left: 14px;
        border-left: 1px solid var(--line);
        line-height: 1.25;
      }
      .volume > * {
        display: block;
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .title {
        font-weight: 550;
      }
      .link {
        display: flex;
        align-items: center;
        gap: 7px;
        color: var(--text-quiet);
        font-size: 12px;
      }
      .dot {
        width: 8px;
        height: 8px;
        border-radius: 50%;
        background: var(--warning);
      }
      .connected .dot {
        background: var(--good);
      }
      .queued .dot,
      .gave_way .dot,
      .waiting .dot {
        background: var(--problem);
      }
      nav {
        display: flex;
        gap: 2px;
      }
      .follow[aria-pressed='true'] {
        background: var(--accent);
        color: var(--on-accent);
      }
      /* A finger has no place before it touches. */
      @media (hover: none) {
        .follow {
          display: none;
        }
      }
      @media (max-width: 720px) {
        :host {
          padding-right: 2px;
          gap: 8px;
        }
        .brand span,
        .link span:last-child,
        .panel-toggle {
          position: absolute;
          width: 1px;
          height: 1px;
          overflow: hidden;
          clip-path: inset(50%);
        }
        .panel-toggle {
          display: none;
        }
        .volume {
          padding-left: 10px;
        }
        nav {
          gap: 0;
        }
      }
      /* On a phone the volume's name needs the room more than ours. */
      @media (max-width: 480px) {
        :host {
          gap: 4px;
          padding: 0 0 0 10px;
        }
        .brand {
          position: absolute;
        }
        .brand img {
          display: none;
        }
        .volume {
          padding-left: 0;
          border-left: 0;
        }
        .volume .title {
          display: -webkit-box;
          -webkit-box-orient: vertical;
          -webkit-line-clamp: 2;
          font-size: 12px;
          white-space: normal;
          overflow-wrap: anywhere;
        }
        .volume .title ~ * {
          display: none;
        }
      }
    `,
  ];

  override render() {
    const { link, volume, preferences, shown, can_undo, can_redo } = this.state;
    const { commands, measuring } = this.session;
    const { bar, links } = words().page;
    const toggle = preferences.panel_open ? bar.hide_panel : bar.show_panel;
    return html`
      <h1 class="brand"><img src="./favicon.svg" alt="" /><span>Cutaway</span></h1>
      <div class="volume" data-part="volume-title">
        ${
          volume
            ? html`<span class="title">${volume.title}</span
                ><span class="quiet small">${volumeFacts(volume)}</span>`
            : nothing
        }
      </div>
      <div class="link ${link.phase}">
        <span class="dot"></span><span>${links[link.phase]}</span>
      </div>
      <nav aria-label=${bar.view}>
        <cutaway-layout-choice .session=${this.session}></cutaway-layout-choice>
        ${this.followButton()} ${this.button('undo', bar.undo, () => measuring.undo(), !can_undo)}
        ${this.button('redo', bar.redo, () => commands.redo(), !can_redo)}
        ${this.button('link', bar.copy_link, () => void this.copyLink(), !volume)}
        ${this.button('save', words().export.open, () => this.session.exporting.open(), !shown)}
        ${this.button('help', bar.help, () => commands.toggleHelp(true))}
        ${this.button('panel', toggle, () => commands.togglePanel(), false, 'panel-toggle')}
      </nav>
    `;
  }

  private button(icon: string, label: string, action: () => void, disabled = false, extra = '') {
    return html`<button
      class="icon-button ${extra}"
      aria-label=${label}
      title=${label}
      ?disabled=${disabled}
      @click=${action}
    >
      <wa-icon name=${icon}></wa-icon>
    </button>`;
  }

  private followButton() {
    const { lens_follows, volume } = this.state;
    const { follow } = words().page.bar;
    return html`<button
      class="icon-button follow"
      aria-label=${follow}
      aria-pressed=${lens_follows ? 'true' : 'false'}
      title="${follow} (f)"
      ?disabled=${!volume}
      @click=${() => this.session.commands.followPointer()}
    >
      <wa-icon name="follow"></wa-icon>
    </button>`;
  }

  private async copyLink(): Promise<void> {
    const address = this.session.commands.sceneLink();
    if (!address) return;
    try {
      await copyText(address);
      this.session.toasts.note(words().messages.link_in_clipboard);
    } catch {
      this.session.toasts.note(words().messages.link_in_address_bar);
    }
  }
}
