// The volumes that the server can open, and what it refused.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { RefusedEntry, VolumeEntry } from '../protocol/messages.ts';
import { volumeFacts, volumeWarnings } from '../state/volume_text.ts';
import { shared } from '../styles/shared.ts';
import { overallFraction } from './loading_card.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-volume-list')
export class VolumeList extends SessionElement {
  protected override readonly draws = [
    'volumes',
    'refused',
    'scanning',
    'volume',
    'loading',
  ] as const;

  static override styles = [
    shared,
    css`
      ul {
        display: grid;
        gap: 8px;
      }
      .entry {
        position: relative;
        display: block;
        width: 100%;
        padding: 10px 12px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
        text-align: left;
        overflow: hidden;
        transition:
          background 120ms,
          border-color 120ms;
      }
      .entry:hover {
        background: var(--surface-hover);
      }
      .entry[aria-current='true'] {
        border-color: var(--accent);
        box-shadow: inset 3px 0 0 var(--accent);
      }
      .title {
        display: block;
        font-weight: 600;
        overflow-wrap: anywhere;
      }
      .progress {
        position: absolute;
        left: 0;
        bottom: 0;
        height: 3px;
        background: var(--accent);
      }
      .warning {
        display: flex;
        gap: 6px;
        margin-top: 4px;
        color: var(--warning);
        font-size: 12px;
      }
      .warning wa-icon {
        flex: none;
        font-size: 14px;
        margin-top: 1px;
      }
      .scanning {
        margin-top: 12px;
      }
      details {
        margin-top: 18px;
      }
      summary {
        padding: 6px 0;
        color: var(--text-quiet);
        cursor: pointer;
      }
      .refused li {
        padding: 8px 12px;
        border-left: 2px solid var(--problem);
        background: var(--surface-raised);
        overflow-wrap: anywhere;
      }
      .refused ul {
        gap: 6px;
      }
    `,
  ];

  override render() {
    const { volumes, refused, scanning } = this.state;
    const none = volumes.length === 0 && !scanning;
    return html`
      ${none ? html`<p class="quiet">${words().panel.volumes.none}</p>` : nothing}
      <ul>
        ${volumes.map((entry) => html`<li>${this.entry(entry)}</li>`)}
      </ul>
      ${scanning ? html`<p class="quiet scanning">${words().panel.volumes.scanning}</p>` : nothing}
      ${refused.length > 0 ? this.refusedList(refused) : nothing}
    `;
  }

  private entry(entry: VolumeEntry) {
    const { volume, loading } = this.state;
    const percent = loading?.volume === entry.id ? overallFraction(loading) * 100 : 0;
    return html`<button
      class="entry"
      data-volume=${entry.id}
      aria-current=${volume?.id === entry.id ? 'true' : 'false'}
      @click=${() => this.session.commands.openVolume(entry.id)}
    >
      <span class="title">${entry.title}</span>
      <span class="quiet small">${volumeFacts(entry) || entry.format}</span>
      ${volumeWarnings(entry, volume).map(
        (text) =>
          html`<span class="warning"><wa-icon name="warning"></wa-icon><span>${text}</span></span>`,
      )}
      <span class="progress" style="width: ${percent}%"></span>
    </button>`;
  }

  private refusedList(refused: readonly RefusedEntry[]) {
    return html`<details class="refused">
      <summary>${words().panel.volumes.refused(refused.length)}</summary>
      <ul>
        ${refused.map(
          ({ path, reason }) =>
            html`<li>
              <div>${path}</div>
              <div class="quiet small">${reason}</div>
            </li>`,
        )}
      </ul>
    </details>`;
  }
}
