// The volumes that the server can open, and what it refused.
import { html, nothing } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { InSight } from '../interaction/in_sight.ts';
import type { RefusedEntry, VolumeEntry } from '../protocol/messages.ts';
import { previewSize } from '../state/preview_subject.ts';
import {
  EVERY_VOLUME,
  matchingVolumes,
  modalitiesOf,
  type VolumeFilter,
} from '../state/volume_search.ts';
import { volumeFacts, volumeWarnings } from '../state/volume_text.ts';
import { chip_styles } from '../styles/chips.ts';
import type { Viewport } from '../view/camera.ts';
import { shared } from '../styles/shared.ts';
import { overallFraction } from './loading_card.ts';
import { SessionElement } from './session_element.ts';
import './style_picture.ts';
import { volume_list_styles } from './volume_list_styles.ts';
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
    'volume_pictures',
  ] as const;

  private readonly sight = new InSight(this, () => this.askForPictures());

  @state() private filter: VolumeFilter = EVERY_VOLUME;

  static override styles = [shared, chip_styles, volume_list_styles];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.session.volume_pictures.want([], undefined);
  }

  private askForPictures(): void {
    const { names } = this.sight;
    const seen = this.state.volumes.map(({ id }) => id).filter((id) => names.has(id));
    this.session.volume_pictures.want(seen, this.pictureSize());
  }

  private pictureSize(): Viewport | undefined {
    const { clientWidth } = this.renderRoot.querySelector('.picture') ?? {};
    if (!clientWidth) return undefined;
    const width_px = Math.round(clientWidth * devicePixelRatio);
    return previewSize({ width_px, height_px: Math.round((width_px * 3) / 4) });
  }

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
      data-card=${entry.id}
      aria-current=${volume?.id === entry.id ? 'true' : 'false'}
      @click=${() => this.session.commands.openVolume(entry.id)}
    >
      ${this.picture(entry)}
      <span class="texts">
        <span class="title">${entry.title}</span>
        <span class="quiet small">${volumeFacts(entry) || entry.format}</span>
        ${volumeWarnings(entry, volume).map(
          (text) =>
            html`<span class="warning"
              ><wa-icon name="warning"></wa-icon><span>${text}</span></span
            >`,
        )}
      </span>
    </button>`;
  }

  /** Quiet where there is none: the entry says all without it. */
  private picture({ id }: VolumeEntry) {
    const picture = this.state.volume_pictures.get(id);
    const drawn = picture !== undefined && picture !== 'failed';
    return html`<span class="picture" data-picture=${drawn ? 'rendered' : (picture ?? 'waiting')}>
      ${
        drawn
          ? html`<cutaway-style-picture .picture=${picture}></cutaway-style-picture>`
          : html`<wa-icon name="volumes"></wa-icon>`
      }
    </span>`;
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
