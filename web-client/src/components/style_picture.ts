// What a style looks like: the server's picture of the user's own volume, or, until that is there,
// a drawing in the style's colours: context outside, focus through the lens.
import { css, html, LitElement, nothing, svg } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { Swatch, Tones } from '../state/style_swatch.ts';
import { shared } from '../styles/shared.ts';

@customElement('cutaway-style-picture')
export class StylePicture extends LitElement {
  @property({ attribute: false }) picture: ImageBitmap | undefined;
  /** Needed while there is no picture. */
  @property({ attribute: false }) swatch: Swatch | undefined;
  @query('canvas') private canvas!: HTMLCanvasElement | null;

  static override styles = [
    shared,
    css`
      :host {
        display: block;
        aspect-ratio: 4 / 3;
        overflow: hidden;
        background: var(--page);
      }
      canvas,
      svg {
        display: block;
        width: 100%;
        height: 100%;
        object-fit: cover;
        animation: appear 200ms ease-out;
      }
      @keyframes appear {
        from {
          opacity: 0;
        }
      }
    `,
  ];

  override render() {
    if (this.picture) return html`<canvas></canvas>`;
    return this.swatch ? this.drawing(this.swatch) : nothing;
  }

  /** Once: the bitmap may be closed when the next one is there. */
  override updated(changed: Map<string, unknown>): void {
    const { canvas, picture } = this;
    if (!canvas || !picture || !changed.has('picture')) return;
    canvas.width = picture.width;
    canvas.height = picture.height;
    canvas.getContext('2d', { alpha: false })?.drawImage(picture, 0, 0);
  }

  private drawing({ background, context, focus, focus_share }: Swatch) {
    return html`<svg viewBox="0 0 80 60" preserveAspectRatio="xMidYMid slice" aria-hidden="true">
      ${this.ramp('context', context)} ${this.ramp('focus', focus)}
      ${svg`<rect width="80" height="60" fill=${background} />
        <circle cx="40" cy="30" r="24" fill="url(#context)" />
        <circle cx="44" cy="32" r="13" fill="url(#focus)" opacity=${focus_share} />`}
    </svg>`;
  }

  private ramp(id: string, { dark, light, flat }: Tones) {
    const [from, to] = flat ? ['52%', '54%'] : ['12%', '92%'];
    return svg`<linearGradient id=${id} x1="0.15" y1="0.05" x2="0.85" y2="0.95">
      <stop offset=${from} stop-color=${light} /><stop offset=${to} stop-color=${dark} />
    </linearGradient>`;
  }
}
