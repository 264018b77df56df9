// How often each value occurs, on a logarithmic scale, with the band of values that is drawn.
import { css, html, LitElement, nothing, svg } from 'lit';
import { customElement, property } from 'lit/decorators.js';

const HEIGHT = 56;

/** Ends of a band, 0..1 over the range. */
export interface HistogramBand {
  readonly lower: number;
  /** Nothing where the band is open. */
  readonly upper: number | undefined;
}

@customElement('cutaway-histogram')
export class HistogramView extends LitElement {
  @property({ attribute: false }) counts: readonly number[] = [];
  @property({ attribute: false }) band: HistogramBand = { lower: 0, upper: undefined };

  static override styles = css`
    svg {
      display: block;
      width: 100%;
      height: 56px;
    }
    path {
      fill: var(--line-strong);
      opacity: 0.7;
    }
    rect {
      fill: var(--accent);
      opacity: 0.2;
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
    return html`<svg viewBox="0 0 ${bins} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
      ${svg`<path d="M0 ${HEIGHT}${steps}V${HEIGHT}Z" />`} ${this.bandOver(bins)}
    </svg>`;
  }

  private bandOver(bins: number) {
    const { lower, upper } = this.band;
    const end = (share: number) =>
      svg`<line x1=${share * bins} x2=${share * bins} y1="0" y2=${HEIGHT} />`;
    const width = Math.max(0, (upper ?? 1) - lower) * bins;
    return svg`<rect x=${lower * bins} y="0" width=${width} height=${HEIGHT} />
      ${end(lower)}${upper === undefined ? nothing : end(upper)}`;
  }
}
