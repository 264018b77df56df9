// How things look, in detail: what `capabilities` offers for both branches, the lens and the light.
import { html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { CapabilitiesMessage, Scene, VolumeSummary } from '../protocol/messages.ts';
import type { Control } from '../state/controls.ts';
import { filterListModel, type BranchName } from '../state/filter_model.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { moduleModel } from '../state/module_model.ts';
import { backgroundControl, lightControls, sceneChoiceControl } from '../state/scene_controls.ts';
import { bandModel } from '../state/surface_controls.ts';
import { isTranslucent, lightOnSurface } from '../state/light_on_surface.ts';
import { preparationSwitches } from '../state/preparation_controls.ts';
import { tissuePresets } from '../state/tissue_presets.ts';
import { headings } from '../styles/headings.ts';
import { shared } from '../styles/shared.ts';
import './band_editor.ts';
import './filter_list.ts';
import './lens_section.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

interface Known {
  readonly capabilities: CapabilitiesMessage;
  readonly scene: Scene;
  readonly volume: VolumeSummary;
}

@customElement('cutaway-adjust-tab')
export class AdjustTab extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene', 'volume'] as const;

  static override styles = [shared, headings];

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  override render() {
    const { capabilities, scene, volume } = this.state;
    if (!capabilities || !scene || !volume)
      return html`<p class="quiet">${words().panel.adjust.later}</p>`;
    const known = { capabilities, scene, volume };
    return html`<cutaway-lens-section .session=${this.session}></cutaway-lens-section>
      ${this.branch('focus', known)} ${this.branch('context', known)} ${this.light(known)}`;
  }

  private field(control: Control, group: string) {
    return html`<cutaway-control
      .control=${control}
      .group=${group}
      .change=${this.change}
    ></cutaway-control>`;
  }

  private branch(branch: BranchName, known: Known) {
    const { capabilities, scene } = known;
    const texts = words().panel.adjust;
    const [heading, hint] = [texts[branch], texts[`${branch}_hint`]];
    const shading = moduleModel(
      words().controls.shading,
      [branch, 'shading'],
      capabilities.modules.shading,
      scene,
    );
    return html`<cutaway-section
      heading=${heading}
      hint=${hint}
      ?open=${branch === 'focus'}
      .reset=${() => this.session.commands.resetGroup(branch)}
    >
      ${this.band(branch, known, heading)}
      ${
        branch === 'context'
          ? preparationSwitches(scene).map((control) => this.field(control, heading))
          : nothing
      }
      ${this.field(shading.choice, heading)}
      <cutaway-module-fields
        .controls=${shading.controls}
        .group=${heading}
        .change=${this.change}
      ></cutaway-module-fields>
      ${this.lightOn(branch, known, heading)}
      <h3>${texts.filters}</h3>
      <cutaway-filter-list
        .model=${filterListModel(branch, capabilities.modules.filter, scene)}
        .group=${heading}
        .change=${this.change}
      ></cutaway-filter-list>
    </cutaway-section>`;
  }

  private lightOn(branch: BranchName, { scene, volume }: Known, group: string) {
    const { surface_and_light, only_opaque } = words().panel.adjust;
    return html`<h3>${surface_and_light}</h3>
      ${
        isTranslucent(scene)
          ? html`<p class="quiet small">${only_opaque}</p>`
          : html`<cutaway-module-fields
              .controls=${lightOnSurface(branch, scene, volume)}
              .group=${group}
              .change=${this.change}
            ></cutaway-module-fields>`
      }`;
  }

  private band(branch: BranchName, { scene, volume }: Known, group: string) {
    const model = bandModel(branch, scene, volume);
    return html`<cutaway-band-editor
        .model=${model}
        .counts=${volume.histogram}
        .tissues=${tissuePresets(branch, scene, volume)}
        .group=${group}
        .change=${this.change}
      ></cutaway-band-editor>
      ${this.field(model.opacity, group)}`;
  }

  private light({ scene }: Known) {
    const { light, light_and_background } = words().panel.adjust;
    const frame = sceneChoiceControl('light.frame', words().controls.light_turns_with, scene);
    return html`<cutaway-section
      heading=${light_and_background}
      .reset=${() => this.session.commands.resetGroup('light')}
    >
      ${this.field(frame, light)}
      ${lightControls(scene).map((control) => this.field(control, light))}
      ${this.field(backgroundControl(scene), '')}
    </cutaway-section>`;
  }
}
