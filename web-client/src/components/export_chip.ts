// Over the picture: that the view is being recorded, or that a film is made while its dialog is
// closed.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { ExportJob } from '../state/export_state.ts';
import { framesText } from '../state/export_text.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

const TICK_MS = 250;

@customElement('cutaway-export-chip')
export class ExportChip extends SessionElement {
  protected override readonly draws = ['exporting'] as const;

  private clock: ReturnType<typeof setInterval> | undefined;

  static override styles = [
    shared,
    css`
      .chip {
        display: flex;
        align-items: center;
        gap: 10px;
        padding: 3px 4px 3px 14px;
        border-radius: 999px;
        background: var(--on-picture-surface);
        color: var(--on-picture-text);
        font-variant-numeric: tabular-nums;
      }
      .mark {
        width: 12px;
        height: 12px;
        border-radius: 50%;
        background: var(--recording);
        animation: blink 1.6s ease-in-out infinite;
      }
      @keyframes blink {
        50% {
          opacity: 0.35;
        }
      }
      .text-button {
        border-color: currentColor;
        border-radius: 999px;
        color: inherit;
      }
      .text-button:hover:not(:disabled) {
        background: var(--on-picture-accent);
        color: var(--on-picture-on-accent);
      }
    `,
  ];

  override updated(): void {
    const records = this.state.exporting.recording_since_ms !== undefined;
    if (records) this.clock ??= setInterval(() => this.requestUpdate(), TICK_MS);
    else {
      clearInterval(this.clock);
      this.clock = undefined;
    }
  }

  override render() {
    const { recording_since_ms, job, open } = this.state.exporting;
    if (recording_since_ms !== undefined) return this.recording(recording_since_ms);
    return job && !open ? this.making(job) : nothing;
  }

  private recording(since_ms: number) {
    const { recording, stop } = words().export;
    const seconds = (performance.now() - since_ms) / 1000;
    return html`<div class="chip" data-part="recording">
      <span class="mark"></span>
      <span role="status">${recording}</span>
      <span>${words().number(seconds, 0)} s</span>
      <button class="text-button" @click=${() => this.session.exporting.recorder.stop()}>
        ${stop}
      </button>
    </div>`;
  }

  private making(job: ExportJob) {
    const { making, waiting } = words().export;
    const progress = job.what === 'film' ? framesText(job) : making.picture;
    return html`<div class="chip" data-part="export-going-on">
      <span>${this.state.exporting.lags ? waiting : progress}</span>
      <button class="text-button" @click=${() => this.session.exporting.show(true)}>
        ${words().export.heading}
      </button>
    </div>`;
  }
}
