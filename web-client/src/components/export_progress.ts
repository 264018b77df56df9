// How far the export is, with a button that gives it up.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { framesText, timeLeftText } from '../state/export_text.ts';
import type { ExportJob } from '../state/export_state.ts';
import { export_styles } from '../styles/export.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-export-progress')
export class ExportProgress extends SessionElement {
  protected override readonly draws = ['exporting'] as const;

  static override styles = [
    shared,
    export_styles,
    css`
      progress {
        width: 100%;
        height: 8px;
        accent-color: var(--accent);
      }
      progress[value] {
        appearance: none;
        border: 0;
        border-radius: 4px;
        background: var(--surface-hover);
        overflow: hidden;
      }
      ::-webkit-progress-bar {
        background: var(--surface-hover);
      }
      ::-webkit-progress-value {
        background: var(--accent);
      }
      ::-moz-progress-bar {
        background: var(--accent);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        justify-content: space-between;
        gap: 4px 14px;
        font-variant-numeric: tabular-nums;
      }
    `,
  ];

  override render() {
    const { job, lags } = this.state.exporting;
    if (!job) return nothing;
    const { making, waiting, go_on, cancel } = words().export;
    return html`<p role="status">${lags ? waiting : making[job.what]}</p>
      ${job.what === 'film' ? this.film(job) : this.bar(undefined, 1)}
      <p class="quiet small">${go_on}</p>
      <button class="text-button" @click=${() => this.session.exporting.cancel()}>
        ${cancel}
      </button>`;
  }

  private film(job: ExportJob) {
    return html`${this.bar(job.frames_done, job.frames)}
      <div class="row" data-part="export-progress">
        <span>${framesText(job)}</span>
        <span class="quiet">
          ${this.state.exporting.lags ? nothing : timeLeftText(job, performance.now())}
        </span>
      </div>`;
  }

  /** Without a value it says that something goes on. */
  private bar(value: number | undefined, maximum: number) {
    const label = words().export.heading;
    return html`<progress aria-label=${label} max=${maximum} value=${value ?? nothing}></progress>`;
  }
}
