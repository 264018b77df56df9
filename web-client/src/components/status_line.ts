// How the stream does, under the picture, for who wants to know.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { ShownFrame } from '../stream/worker_messages.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

const BYTES_PER_KIB = 1024;

@customElement('cutaway-status-line')
export class StatusLine extends SessionElement {
  protected override readonly draws = ['shown', 'capabilities', 'frames_per_second'] as const;

  static override styles = [
    shared,
    css`
      dl {
        display: flex;
        flex-wrap: wrap;
        gap: 2px 18px;
        padding: 5px 14px;
        border-top: 1px solid var(--line);
        background: var(--surface);
        font-size: 12px;
        font-variant-numeric: tabular-nums;
      }
      div {
        display: flex;
        gap: 6px;
        white-space: nowrap;
      }
      .renderer {
        min-width: 0;
        overflow: hidden;
      }
      .renderer dd {
        overflow: hidden;
        text-overflow: ellipsis;
      }
    `,
  ];

  override render() {
    const { shown, capabilities } = this.state;
    const texts = words().page.status;
    return html`<dl aria-label=${texts.name} data-part="status-line">
      ${shown ? this.stream(shown) : nothing}
      ${capabilities ? this.entry(texts.renderer, capabilities.renderer, 'renderer') : nothing}
    </dl>`;
  }

  private stream(shown: ShownFrame) {
    const { number, page } = words();
    const texts = page.status;
    const { still, lossless, latency_ms, bytes, width_px, viewport_width_px } = shown;
    const rate = still ? texts.at_rest : number(this.state.frames_per_second);
    const quality = lossless ? texts.lossless : still ? texts.high : texts.in_motion;
    return [
      this.entry(texts.frames_per_second, rate),
      this.entry(texts.latency, `${number(latency_ms)} ms`),
      this.entry(texts.bytes, `${number(bytes / BYTES_PER_KIB, 1)} KiB`),
      this.entry(texts.scale, number(width_px / viewport_width_px, 2)),
      this.entry(texts.quality, quality),
    ];
  }

  private entry(term: string, value: string, part = '') {
    return html`<div class=${part}>
      <dt class="quiet">${term}</dt>
      <dd>${value}</dd>
    </div>`;
  }
}
