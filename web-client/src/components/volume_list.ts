// The volumes that the server can open, and what it refused.
import { css, html, nothing } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { RefusedEntry, VolumeEntry } from '../protocol/messages.ts';
import {
  EVERY_VOLUME,
  matchingVolumes,
  modalitiesOf,
  type VolumeFilter,
} from '../state/volume_search.ts';
import { volumeFacts, volumeWarnings } from '../state/volume_text.ts';
import { chip_styles } from '../styles/chips.ts';
import { shared } from '../styles/shared.ts';
import { overallFraction } from './loading_card.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

/** So many are found at a glance. */
const FEW = 3;

@customElement('cutaway-volume-list')
export class VolumeList extends SessionElement {
  protected override readonly draws = [
    'volumes',
    'refused',
    'scanning',
    'volume',
    'loading',
  ] as const;

  @state() private filter: VolumeFilter = EVERY_VOLUME;

  static override styles = [
    shared,
    chip_styles,
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
        position: relative;
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding-left: 12px;
        font-variant-numeric: tabular-nums;
      }
      .bar {
        position: absolute;
        left: 0;
        top: 1px;
        height: 3px;
        border-radius: 2px;
        background: var(--accent);
        transition: width 160ms;
      }
      .search {
        display: grid;
        gap: 8px;
        margin-bottom: 12px;
      }
      .search input {
        min-width: 0;
        padding: 8px 12px;
        border: 1px solid var(--line-strong);
        border-radius: 9px;
        background: var(--surface-raised);
        color: var(--text);
        font: inherit;
      }
      .search input::placeholder {
        color: var(--text-quiet);
      }
      .modalities {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
      }
      @media (pointer: coarse) {
        .search input {
          min-height: 44px;
        }
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
    const found = matchingVolumes(volumes, this.filter);
    const texts = words().panel.volumes;
    const nothing_found = volumes.length > 0 && found.length === 0;
    return html`
      ${volumes.length > FEW ? this.search(volumes) : nothing}
      ${volumes.length === 0 && !scanning ? html`<p class="quiet">${texts.none}</p>` : nothing}
      <ul>
        ${found.map((entry) => html`<li>${this.entry(entry)}${this.progress(entry)}</li>`)}
      </ul>
      <p class="quiet" role="status">${nothing_found ? words().volume_browser.none_found : ''}</p>
      ${scanning ? html`<p class="quiet scanning">${texts.scanning}</p>` : nothing}
      ${refused.length > 0 ? this.refusedList(refused) : nothing}
    `;
  }

  private search(volumes: readonly VolumeEntry[]) {
    const modalities = modalitiesOf(volumes);
    const { search, modality, any } = words().volume_browser;
    return html`<div class="search" role="search">
      <input
        type="search"
        aria-label=${search}
        placeholder=${search}
        autocomplete="off"
        spellcheck="false"
        .value=${live(this.filter.text)}
        @input=${(event: Event) =>
          (this.filter = { ...this.filter, text: (event.target as HTMLInputElement).value })}
      />
      ${
        modalities.length < 2
          ? nothing
          : html`<div class="modalities" role="group" aria-label=${modality}>
              ${['', ...modalities].map((one) => this.modality(one, one || any))}
            </div>`
      }
    </div>`;
  }

  private modality(modality: string, label: string) {
    return html`<button
      class="chip"
      aria-pressed=${this.filter.modality === modality ? 'true' : 'false'}
      @click=${() => (this.filter = { ...this.filter, modality })}
    >
      ${label}
    </button>`;
  }

  private entry(entry: VolumeEntry) {
    const { volume } = this.state;
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
    </button>`;
  }

  private progress({ id, title }: VolumeEntry) {
    const { loading } = this.state;
    if (loading?.volume !== id) return nothing;
    const percent = Math.round(overallFraction(loading) * 100);
    const stage = words().page.stages[loading.stage];
    return html`<div class="progress" data-part="volume-progress">
      <span class="bar" style="width: ${percent}%"></span>
      <span class="quiet small">${stage} · ${percent} %</span>
      <button
        class="icon-button"
        aria-label=${words().volume_browser.cancel(title)}
        title=${words().volume_browser.cancel(title)}
        @click=${() => this.session.commands.cancelLoad()}
      >
        <wa-icon name="close"></wa-icon>
      </button>
    </div>`;
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
