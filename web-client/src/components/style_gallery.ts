// The named styles. Each card's swatch is drawn from the style's own colours: context outside,
// focus through the lens.
import { css, html, svg } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { Scene, Style } from '../protocol/messages.ts';
import { toHex } from '../state/colour.ts';
import { matchingStyle } from '../state/style_patch.ts';
import { shared } from '../styles/shared.ts';
import { SessionElement } from './session_element.ts';

interface Tones {
  readonly dark: string;
  readonly light: string;
  /** A step between the two, as against a ramp. */
  readonly flat: boolean;
}

const GREY: readonly [number, number, number] = [0.5, 0.5, 0.5];
const SHADOW = 0.35;

function tonesOf(branch: Scene['focus']): Tones {
  const shading = branch?.shading;
  if (shading?.name === 'tone') {
    return {
      dark: toHex(shading.dark ?? GREY),
      light: toHex(shading.light ?? GREY),
      flat: (shading.detail ?? 1) < 0.2,
    };
  }
  const colour = shading?.colour ?? GREY;
  return { dark: toHex(colour.map((part) => part * SHADOW)), light: toHex(colour), flat: false };
}

@customElement('cutaway-style-gallery')
export class StyleGallery extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene'] as const;

  static override styles = [
    shared,
    css`
      ul {
        display: grid;
        gap: 8px;
      }
      button {
        display: grid;
        grid-template-columns: 64px 1fr;
        gap: 12px;
        align-items: center;
        width: 100%;
        padding: 8px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
        text-align: left;
        transition:
          background 120ms,
          border-color 120ms;
      }
      button:hover {
        background: var(--surface-hover);
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        box-shadow: inset 3px 0 0 var(--accent);
      }
      svg {
        display: block;
        width: 64px;
        height: 64px;
        border-radius: 7px;
      }
      .title {
        display: block;
        font-weight: 600;
      }
      .quiet {
        display: block;
      }
    `,
  ];

  override render() {
    const { capabilities, scene } = this.state;
    if (!capabilities) return html`<p class="quiet">Waiting for the server…</p>`;
    const worn = matchingStyle(scene, capabilities.styles);
    return html`<ul>
      ${capabilities.styles.map((style, index) => this.card(style, index, style === worn))}
    </ul>`;
  }

  private card(style: Style, index: number, worn: boolean) {
    return html`<li>
      <button
        aria-pressed=${worn ? 'true' : 'false'}
        data-style=${style.name}
        @click=${() => this.session.commands.applyStyle(style)}
      >
        ${this.swatch(style, index)}
        <span>
          <span class="title">${style.title}</span>
          <span class="quiet small">${style.description}</span>
        </span>
      </button>
    </li>`;
  }

  private swatch({ scene }: Style, index: number) {
    const lens_radius = scene.lens?.mode === 'none' ? 0 : 14;
    const background = toHex(scene.background?.colour ?? [0, 0, 0]);
    return html`<svg viewBox="0 0 64 64" aria-hidden="true">
      ${this.ramp(`context-${index}`, tonesOf(scene.context))}
      ${this.ramp(`focus-${index}`, tonesOf(scene.focus))}
      ${svg`<rect width="64" height="64" fill=${background} />
        <circle cx="32" cy="32" r="26" fill="url(#context-${index})" />
        <circle cx="37" cy="34" r=${lens_radius} fill="url(#focus-${index})" />`}
    </svg>`;
  }

  private ramp(id: string, { dark, light, flat }: Tones) {
    const [from, to] = flat ? ['52%', '54%'] : ['12%', '92%'];
    return svg`<linearGradient id=${id} x1="0.15" y1="0.05" x2="0.85" y2="0.95">
      <stop offset=${from} stop-color=${light} /><stop offset=${to} stop-color=${dark} />
    </linearGradient>`;
  }
}
