// Messages at the lower edge of the picture. Notes go by themselves, problems stay until they are
// read.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { repeat } from 'lit/directives/repeat.js';
import type { Toast, ToastAction } from '../state/viewer_state.ts';
import { shared } from '../styles/shared.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

const NOTE_MS = 4_000;
/** Time to read it and to reach its button. */
const ACTION_MS = 10_000;
const PROBLEM_MS = 15_000;

function lastsMs({ tone, action }: Toast): number {
  if (tone === 'problem') return PROBLEM_MS;
  return action ? ACTION_MS : NOTE_MS;
}

@customElement('cutaway-toast-stack')
export class ToastStack extends SessionElement {
  protected override readonly draws = ['toasts'] as const;

  private readonly timers = new Map<number, ReturnType<typeof setTimeout>>();

  static override styles = [
    shared,
    css`
      :host {
        display: grid;
        gap: 8px;
        pointer-events: none;
      }
      .toast {
        display: flex;
        gap: 10px;
        align-items: flex-start;
        padding: 10px 6px 10px 14px;
        border: 1px solid var(--line-strong);
        border-radius: var(--radius);
        background: var(--surface-floating);
        box-shadow: var(--shadow);
        pointer-events: auto;
        animation: rise 180ms ease-out;
      }
      .text {
        flex: 1;
        min-width: 0;
        padding: 6px 0;
        overflow-wrap: anywhere;
      }
      .problem .mark {
        color: var(--problem);
      }
      .note .mark {
        color: var(--good);
      }
      .mark {
        margin-top: 8px;
      }
      strong {
        display: block;
        font-weight: 600;
      }
      @keyframes rise {
        from {
          opacity: 0;
          transform: translateY(8px);
        }
      }
    `,
  ];

  override render() {
    const { toasts } = this.state;
    return repeat(
      toasts,
      ({ id }) => id,
      (toast) => this.toast(toast),
    );
  }

  override updated(): void {
    for (const toast of this.state.toasts) {
      if (this.timers.has(toast.id)) continue;
      const dismiss = (): void => this.session.toasts.dismiss(toast.id);
      this.timers.set(toast.id, setTimeout(dismiss, lastsMs(toast)));
    }
  }

  private toast({ id, tone, title, detail, action }: Toast) {
    return html`<div
      class="toast ${tone}"
      role=${tone === 'problem' ? 'alert' : 'status'}
      data-part="toast"
    >
      <wa-icon class="mark" name=${tone === 'problem' ? 'warning' : 'check'}></wa-icon>
      <div class="text"><strong>${title}</strong><span class="quiet small">${detail}</span></div>
      ${action ? this.action(id, action) : nothing}
      <button
        class="icon-button"
        aria-label=${words().page.dismiss}
        @click=${() => this.session.toasts.dismiss(id)}
      >
        <wa-icon name="close"></wa-icon>
      </button>
    </div>`;
  }

  private action(id: number, { label, run }: ToastAction) {
    const act = (): void => {
      run();
      this.session.toasts.dismiss(id);
    };
    return html`<button class="text-button" @click=${act}>${label}</button>`;
  }
}
