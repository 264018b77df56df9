// The view as a picture or as a film in a file.
import { css, html, nothing } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import type { CameraPath } from '../film/camera_path.ts';
import type { SizeWish } from '../film/picture_size.ts';
import type { ExportOutcome } from '../state/export_state.ts';
import { FIRST_FILM, type FilmSettings } from '../state/film_settings.ts';
import { chip_styles } from '../styles/chips.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './export_film.ts';
import './export_picture.ts';
import './export_progress.ts';
import './modal.ts';
import { SessionElement } from './session_element.ts';

const KINDS = ['picture', 'film'] as const;
/** Before the user has given sides, a preset's are taken. */
const FIRST_OWN = { own: { width_px: 1, height_px: 1 }, keeps_shape: true };
const BYTES_PER_MEGABYTE = 1e6;

@customElement('cutaway-export-dialog')
export class ExportDialog extends SessionElement {
  protected override readonly draws = ['exporting'] as const;

  @state() private kind: (typeof KINDS)[number] = 'picture';
  @state() private picture_size: SizeWish = { ...FIRST_OWN, preset: 'double' };
  @state() private film_size: SizeWish = { ...FIRST_OWN, preset: 'full_hd' };
  @state() private film: FilmSettings = FIRST_FILM;
  private path: CameraPath | undefined;

  static override styles = [
    shared,
    chip_styles,
    css`
      .kinds {
        display: flex;
        gap: 6px;
        margin: 8px 0 14px;
      }
      .outcome {
        display: flex;
        gap: 10px;
        margin-top: 14px;
        padding: 10px 12px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
        overflow-wrap: anywhere;
      }
      .outcome wa-icon {
        flex: none;
      }
      .saved wa-icon {
        color: var(--good);
      }
      .failed wa-icon {
        color: var(--problem);
      }
    `,
  ];

  /** A recording that has ended is what the user wants a film of. */
  override willUpdate(): void {
    const { path } = this.state.exporting;
    if (path === this.path) return;
    this.path = path;
    this.film = { ...this.film, motion: path ? 'path' : 'turntable' };
    if (path) this.kind = 'film';
  }

  override render() {
    const { open, job, outcome } = this.state.exporting;
    return html`<cutaway-modal
      heading=${words().export.heading}
      ?open=${open}
      .closed=${() => this.session.exporting.show(false)}
    >
      ${open ? this.content(job !== undefined) : nothing}
      ${outcome ? this.outcome(outcome) : nothing}
    </cutaway-modal>`;
  }

  private content(works: boolean) {
    if (!works) return this.choices();
    return html`<cutaway-export-progress .session=${this.session}></cutaway-export-progress>`;
  }

  private choices() {
    const { kinds, kind } = words().export;
    return html`<div class="kinds" role="group" aria-label=${kind}>
        ${KINDS.map(
          (one) =>
            html`<button
              class="chip"
              aria-pressed=${this.kind === one ? 'true' : 'false'}
              @click=${() => (this.kind = one)}
            >
              ${kinds[one]}
            </button>`,
        )}
      </div>
      ${this.kind === 'picture' ? this.pictureChoices() : this.filmChoices()}`;
  }

  private pictureChoices() {
    return html`<cutaway-export-picture
      .session=${this.session}
      .wish=${this.picture_size}
      .chosen=${(wish: SizeWish) => (this.picture_size = wish)}
    ></cutaway-export-picture>`;
  }

  private filmChoices() {
    return html`<cutaway-export-film
      .session=${this.session}
      .wish=${this.film_size}
      .settings=${this.film}
      .chosen=${(wish: SizeWish) => (this.film_size = wish)}
      .set=${(settings: FilmSettings) => (this.film = settings)}
    ></cutaway-export-film>`;
  }

  private outcome(outcome: ExportOutcome) {
    if (outcome.kind === 'failed')
      return html`<div class="outcome failed" role="alert" data-part="export-outcome">
        <wa-icon name="warning"></wa-icon>
        <div><strong>${outcome.title}</strong> <span class="quiet">${outcome.detail}</span></div>
      </div>`;
    const { saved, megabytes } = words().export;
    return html`<div class="outcome saved" role="status" data-part="export-outcome">
      <wa-icon name="check"></wa-icon>
      <div>
        ${saved(outcome.name)}
        <span class="quiet">${megabytes(outcome.bytes / BYTES_PER_MEGABYTE)}</span>
      </div>
    </div>`;
  }
}
