// Progress of opening a volume, over the picture.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { LoadingMessage } from '../protocol/messages.ts';
import { shared } from '../styles/shared.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

const STAGES = ['read', 'decode', 'min_max', 'upload'] as const;

/** Of the whole way through the stages, 0..1. */
export function overallFraction({ stage, fraction }: LoadingMessage): number {
  const index = STAGES.findIndex((name) => name === stage);
  return index < 0 ? 1 : (index + fraction) / STAGES.length;
}

@customElement('cutaway-loading-card')
export class LoadingCard extends SessionElement {
  protected override readonly draws = ['loading', 'volumes'] as const;

  static override styles = [
    shared,
    css`
      .card {
        position: absolute;
        left: 50%;
        top: 50%;
        transform: translate(-50%, -50%);
        width: min(320px, calc(100% - 48px));
        padding: 16px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-floating);
        box-shadow: var(--shadow);
      }
      .title {
        font-weight: 600;
        overflow-wrap: anywhere;
      }
      .track {
        height: 6px;
        margin: 12px 0;
        border-radius: 3px;
        background: var(--surface-hover);
        overflow: hidden;
      }
      .fill {
        height: 100%;
        border-radius: 3px;
        background: var(--accent);
        transition: width 160ms;
      }
      .row {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
    `,
  ];

  override render() {
    const { loading, volumes } = this.state;
    if (!loading) return nothing;
    const title = volumes.find(({ id }) => id === loading.volume)?.title ?? loading.volume;
    const { opening_a_volume, opening, stages, cancel } = words().page;
    const percent = Math.round(overallFraction(loading) * 100);
    return html`<section class="card" aria-label=${opening_a_volume}>
      <p class="title">${title}</p>
      <div
        class="track"
        role="progressbar"
        aria-label=${opening(title)}
        aria-valuenow=${percent}
        aria-valuemin="0"
        aria-valuemax="100"
      >
        <div class="fill" style="width: ${percent}%"></div>
      </div>
      <div class="row">
        <span class="quiet small">${stages[loading.stage]} · ${percent} %</span>
        <button class="text-button" @click=${() => this.session.commands.cancelLoad()}>
          ${cancel}
        </button>
      </div>
    </section>`;
  }
}
