// What the lens does, how large it is, and where it lies in the patient.
import { html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { CapabilitiesMessage, Scene, VolumeSummary } from '../protocol/messages.ts';
import type { Control } from '../state/controls.ts';
import {
  lensCentreControls,
  lensMode,
  lensModeControls,
  lensRadiusControl,
} from '../state/lens_controls.ts';
import { isTranslucent } from '../state/light_on_surface.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { moduleModel } from '../state/module_model.ts';
import { sceneChoiceControl } from '../state/scene_controls.ts';
import { wallControls } from '../state/wall_controls.ts';
import { headings } from '../styles/headings.ts';
import { shared } from '../styles/shared.ts';
import './coordinate_fields.ts';
import './module_fields.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-lens-section')
export class LensSection extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene', 'volume'] as const;

  static override styles = [shared, headings];

  private readonly reset = (): void => this.session.commands.resetGroup('lens');

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  override render() {
    const { capabilities, scene, volume } = this.state;
    if (!capabilities || !scene || !volume) return nothing;
    return html`<cutaway-section heading=${words().panel.adjust.lens} open .reset=${this.reset}>
      ${this.field(sceneChoiceControl('lens.mode', words().controls.mode, scene))}
      ${scene.lens?.mode === 'none' ? nothing : this.details(capabilities, scene, volume)}
    </cutaway-section>`;
  }

  private details({ modules }: CapabilitiesMessage, scene: Scene, volume: VolumeSummary) {
    const shapes = modules.lens_shape;
    const shape = moduleModel(words().controls.shape, ['lens', 'shape'], shapes, scene);
    return html`
      ${lensModeControls(scene).map((control) => this.field(control))}
      ${shapes.length > 1 ? this.field(shape.choice) : nothing}
      <cutaway-module-fields
        .controls=${shape.controls}
        .group=${words().panel.adjust.lens}
        .change=${this.change}
      ></cutaway-module-fields>
      ${this.field(lensRadiusControl(scene, volume))}
      <cutaway-coordinate-fields
        .controls=${lensCentreControls(scene)}
        .heading=${words().controls.centre_in_patient}
        .group=${words().panel.adjust.lens}
        .change=${this.change}
      ></cutaway-coordinate-fields>
      ${lensMode(scene) === 'cutaway' ? this.wall(scene) : nothing}
    `;
  }

  private wall(scene: Scene) {
    const { lens, wall, only_opaque } = words().panel.adjust;
    return html`<h3>${wall}</h3>
      ${
        isTranslucent(scene)
          ? html`<p class="quiet small">${only_opaque}</p>`
          : html`<cutaway-module-fields
              .controls=${wallControls(scene)}
              .group=${`${lens}, ${wall}`}
              .change=${this.change}
            ></cutaway-module-fields>`
      }`;
  }

  private field(control: Control) {
    return html`<cutaway-control
      .control=${control}
      .group=${words().panel.adjust.lens}
      .change=${this.change}
    ></cutaway-control>`;
  }
}
