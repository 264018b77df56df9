// The slices' part of the panel.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import { CONVENTIONS } from '../preferences/preferences.ts';
import type { Control } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import {
  conventionControl,
  lensAtCrosshairControl,
  windowControls,
} from '../state/slice_controls.ts';
import { viewChoice } from '../state/slice_views.ts';
import { hasPresets, windowPreset, WINDOW_PRESET_NAMES } from '../state/value_window.ts';
import { showsSlices } from '../state/views.ts';
import { SLICE_NAMES } from '../view/slice_geometry.ts';
import { isTilted } from '../view/slice_motion.ts';
import { chip_styles } from '../styles/chips.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './control_field.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-slices-section')
export class SlicesSection extends SessionElement {
  protected override readonly draws = [
    'scene',
    'volume',
    'preferences',
    'maximised',
    'lens_at_crosshair',
  ] as const;

  static override styles = [
    shared,
    chip_styles,
    css`
      .chips {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
      }
      .pair {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 6px;
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  private readonly convene = ({ convention }: JsonObject): void => {
    const chosen = CONVENTIONS.find((one) => one === convention);
    if (chosen) this.session.slicing.setConvention(chosen);
  };

  override render() {
    const { scene, volume } = this.state;
    if (!scene?.slices || !volume) return nothing;
    const shows = showsSlices(viewChoice(this.state));
    return html`<cutaway-section heading=${words().slices.heading} open>
      ${shows ? this.controls(scene, volume) : this.showButton()}
    </cutaway-section>`;
  }

  private showButton() {
    return html`<button class="text-button" @click=${() => this.session.layout.choose('grid')}>
      ${words().slices.show}
    </button>`;
  }

  private controls(scene: Scene, volume: VolumeSummary) {
    const { slicing } = this.session;
    const follows = lensAtCrosshairControl(this.state.lens_at_crosshair);
    return html`
      ${windowControls(scene, volume).map((control) => this.field(control, this.change))}
      ${hasPresets(volume) ? this.presets(scene) : nothing}
      ${this.field(conventionControl(scene), this.convene)}
      ${this.field(follows, () => slicing.toggleLensAtCrosshair())}
      <div class="pair">
        <button class="text-button" @click=${() => this.resetViews()}>
          ${words().slices.reset_views}
        </button>
        <button
          class="text-button"
          ?disabled=${!isTilted(scene.slices ?? {})}
          @click=${() => slicing.resetTilt()}
        >
          ${words().slices.reset_tilt}
        </button>
      </div>
    `;
  }

  private resetViews(): void {
    this.session.commands.change({
      slices: Object.fromEntries(SLICE_NAMES.map((name) => [name, null])),
    });
  }

  private presets(scene: Scene) {
    const { centre, width } = scene.slices?.window ?? {};
    const { presets_heading, presets, preset_hint } = words().slices;
    return html`<div class="chips" role="group" aria-label=${presets_heading}>
      ${WINDOW_PRESET_NAMES.map((name, index) => {
        const preset = windowPreset(name);
        const chosen = preset.centre === centre && preset.width === width;
        return html`<button
          class="chip"
          aria-pressed=${chosen ? 'true' : 'false'}
          title=${preset_hint(index + 1, String(preset.centre), String(preset.width))}
          data-preset=${name}
          @click=${() => this.session.slicing.usePreset(name)}
        >
          ${presets[name]}
        </button>`;
      })}
    </div>`;
  }

  private field(control: Control, change: (patch: JsonObject) => void) {
    return html`<cutaway-control
      .control=${control}
      .group=${words().slices.heading}
      .change=${change}
    ></cutaway-control>`;
  }
}
