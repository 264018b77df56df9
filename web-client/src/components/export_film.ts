// A turntable or a recorded path as a film.
import { css, html, nothing } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { formatSupport, type FormatSupport } from '../film/film_file.ts';
import { chosenSize, even, filmPresets, type SizeWish } from '../film/picture_size.ts';
import type { Control } from '../state/controls.ts';
import {
  filmFacts,
  formatControl,
  motionControl,
  speedControl,
  turntableControls,
  type FilmSettings,
} from '../state/film_settings.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { export_styles } from '../styles/export.ts';
import { shared } from '../styles/shared.ts';
import type { Viewport } from '../view/camera.ts';
import { words } from '../words/words.ts';
import './control_field.ts';
import './export_labels.ts';
import './export_size.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-export-film')
export class ExportFilm extends SessionElement {
  protected override readonly draws = ['capabilities', 'viewport', 'exporting'] as const;

  @property({ attribute: false }) settings!: FilmSettings;
  @property({ attribute: false }) wish!: SizeWish;
  @property({ attribute: false }) chosen!: (wish: SizeWish) => void;
  @property({ attribute: false }) set!: (settings: FilmSettings) => void;

  /** What the browser can write, of films of `asked_for`. */
  @state() private support: readonly FormatSupport[] | undefined;
  private asked_for = '';

  static override styles = [
    shared,
    export_styles,
    css`
      .pairs {
        display: grid;
        grid-template-columns: repeat(auto-fit, minmax(200px, 1fr));
        gap: 10px 18px;
      }
      .recorded {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 8px 14px;
      }
      .mark {
        display: inline-block;
        width: 10px;
        height: 10px;
        margin-right: 6px;
        border-radius: 50%;
        background: var(--recording);
      }
    `,
  ];

  override updated(): void {
    const asked_for = JSON.stringify([this.size, this.settings.frames_per_second]);
    if (!this.size || asked_for === this.asked_for) return;
    this.asked_for = asked_for;
    void formatSupport(this.size, this.settings.frames_per_second).then((support) => {
      if (this.asked_for === asked_for) this.support = support;
    });
  }

  private readonly change = (patch: JsonObject): void => {
    this.set({ ...this.settings, ...(patch as Partial<FilmSettings>) });
  };

  private get limit_px(): number {
    return this.state.capabilities?.limits.still_side_px ?? 0;
  }

  private get size(): Viewport | undefined {
    const { viewport } = this.state;
    return viewport && even(chosenSize(this.wish, filmPresets(viewport, this.limit_px)).size);
  }

  /** What the chosen format needs, or the first that there is. */
  private get format(): FormatSupport | undefined {
    const there = this.support?.filter((one) => !('missing' in one));
    return there?.find(({ format }) => format === this.settings.format) ?? there?.[0];
  }

  override render() {
    const { capabilities, viewport, exporting } = this.state;
    if (!capabilities || !viewport) return nothing;
    const { settings, wish, limit_px } = this;
    const path_ms = exporting.path?.duration_ms;
    const ready = settings.motion === 'turntable' || path_ms !== undefined;
    return html`${this.field(motionControl(settings))}
      ${settings.motion === 'turntable' ? this.turntable() : this.recording(path_ms)}
      <cutaway-export-size
        .wish=${wish}
        .presets=${filmPresets(viewport, limit_px)}
        .view=${viewport}
        .limit_px=${limit_px}
        .chosen=${this.chosen}
      ></cutaway-export-size>
      <div class="pairs">${this.field(speedControl(settings))} ${this.formats()}</div>
      ${this.missing()}
      <cutaway-export-labels .session=${this.session} what="film"></cutaway-export-labels>
      <button class="text-button primary" ?disabled=${!ready || !this.format} @click=${this.save}>
        ${words().export.save_film}${ready ? ` · ${filmFacts(settings, path_ms)}` : ''}
      </button>`;
  }

  private field(control: Control) {
    return html`<cutaway-control .control=${control} .change=${this.change}></cutaway-control>`;
  }

  private turntable() {
    return html`<div class="pairs">
      ${turntableControls(this.settings).map((control) => this.field(control))}
    </div>`;
  }

  private recording(path_ms: number | undefined) {
    const { record, record_anew, record_hint, recorded } = words().export;
    return html`<div class="recorded">
        <button class="text-button" @click=${() => this.session.exporting.recorder.start()}>
          <span class="mark"></span>${path_ms === undefined ? record : record_anew}
        </button>
        ${path_ms === undefined ? nothing : html`<span>${recorded(path_ms / 1000)}</span>`}
      </div>
      <p class="quiet small">${record_hint}</p>`;
  }

  private formats() {
    const { formats, format_with, codecs, looking } = words().export;
    if (!this.support) return html`<p class="quiet small" role="status">${looking}</p>`;
    const there = this.support.flatMap((one) => {
      if ('missing' in one) return [];
      const name = formats[one.format];
      return [[one.format, one.codec ? format_with(name, codecs[one.codec]) : name] as const];
    });
    return this.field(formatControl(this.settings, this.format?.format, Object.fromEntries(there)));
  }

  private missing() {
    const { formats, format_missing, missing } = words().export;
    return this.support?.map((one) =>
      'missing' in one
        ? html`<p class="quiet small">
            ${format_missing(formats[one.format], missing[one.missing])}
          </p>`
        : nothing,
    );
  }

  private save(): void {
    const { size, format, settings } = this;
    const motion = settings.motion === 'path' ? 'path' : settings;
    const { frames_per_second } = settings;
    if (size && format)
      void this.session.exporting.saveFilm({ motion, frames_per_second, size, format });
  }
}
