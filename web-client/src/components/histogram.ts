// How often each value occurs, on a logarithmic scale, with a mark at the chosen one.
import { css, html, LitElement, svg } from 'lit';
import { customElement, property } from 'lit/decorators.js';

const HEIGHT = 34;

@customElement('cutaway-histogram')
export class HistogramView extends LitElement {
  @property({ attribute: false }) counts: readonly number[] = [];
  /** 0..1 over the range. */
  @property({ type: Number }) mark = 0;

  static override styles = css`
    svg {
      display: block;
      width: 100%;
      height: 34px;
    }
    path {
      fill: var(--line-strong);
      opacity: 0.7;
    }
    line {
      stroke: var(--accent);
      stroke-width: 2;
      vector-effect: non-scaling-stroke;
    }
  `;

  override render() {
    const heights = this.counts.map((count) => Math.log1p(count));
    const highest = Math.max(1, ...heights);
    const top = (height: number): string => (HEIGHT - (height / highest) * HEIGHT).toFixed(2);
    const steps = heights.map((height, bin) => `V${top(height)}H${bin + 1}`).join('');
    const bins = Math.max(1, heights.length);
    const mark = this.mark * bins;
    return html`<svg viewBox="0 0 ${bins} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
      ${svg`<path d="M0 ${HEIGHT}${steps}V${HEIGHT}Z" />
        <line x1=${mark} x2=${mark} y1="0" y2=${HEIGHT} />`}
    </svg>`;
  }
}
