// How things look, in detail: what `capabilities` offers for both branches, the lens and the light.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { CapabilitiesMessage, Scene, VolumeSummary } from '../protocol/messages.ts';
import type { Control, NumberControl } from '../state/controls.ts';
import { filterListModel, type BranchName } from '../state/filter_model.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { moduleModel } from '../state/module_model.ts';
import {
  backgroundControl,
  isoValueControl,
  lensRadiusControl,
  lightControls,
  sceneChoiceControl,
} from '../state/scene_controls.ts';
import { shared } from '../styles/shared.ts';
import './filter_list.ts';
import './histogram.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';

const BRANCHES: Readonly<Record<BranchName, { heading: string; hint: string }>> = {
  focus: { heading: 'Focus', hint: 'inside the lens' },
  context: { heading: 'Context', hint: 'around it' },
};

interface Known {
  readonly capabilities: CapabilitiesMessage;
  readonly scene: Scene;
  readonly volume: VolumeSummary;
}

@customElement('cutaway-adjust-tab')
export class AdjustTab extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene', 'volume'] as const;

  static override styles = [
    shared,
    css`
      h3 {
        margin: 6px 0 0;
        color: var(--text-quiet);
        font-size: 12px;
        font-weight: 500;
      }
      cutaway-histogram {
        margin: 0 8px -8px;
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  override render() {
    const { capabilities, scene, volume } = this.state;
    if (!capabilities || !scene || !volume)
      return html`<p class="quiet">Opens with the first picture.</p>`;
    const known = { capabilities, scene, volume };
    return html`${this.lens(known)} ${this.branch('focus', known)} ${this.branch('context', known)}
    ${this.light(known)}`;
  }

  private field(control: Control, group: string) {
    return html`<cutaway-control
      .control=${control}
      .group=${group}
      .change=${this.change}
    ></cutaway-control>`;
  }

  private branch(branch: BranchName, known: Known) {
    const { capabilities, scene, volume } = known;
    const { heading, hint } = BRANCHES[branch];
    const shading = moduleModel(
      'Shading',
      [branch, 'shading'],
      capabilities.modules.shading,
      scene,
    );
    const iso_value = isoValueControl(branch, scene, volume);
    return html`<cutaway-section heading=${heading} hint=${hint} ?open=${branch === 'focus'}>
      ${this.histogram(iso_value, volume)} ${this.field(iso_value, heading)}
      ${this.field(shading.choice, heading)}
      <cutaway-module-fields
        .controls=${shading.controls}
        .group=${heading}
        .change=${this.change}
      ></cutaway-module-fields>
      <h3>Filters, in the order they run</h3>
      <cutaway-filter-list
        .model=${filterListModel(branch, capabilities.modules.filter, scene)}
        .group=${heading}
        .change=${this.change}
      ></cutaway-filter-list>
    </cutaway-section>`;
  }

  private histogram({ value, minimum, maximum }: NumberControl, volume: VolumeSummary) {
    const mark = maximum > minimum ? (value - minimum) / (maximum - minimum) : 0;
    return html`<cutaway-histogram .counts=${volume.histogram} .mark=${mark}></cutaway-histogram>`;
  }

  private lens({ capabilities, scene, volume }: Known) {
    const shapes = capabilities.modules.lens_shape;
    const shape = moduleModel('Shape', ['lens', 'shape'], shapes, scene);
    return html`<cutaway-section heading="Lens" open>
      ${this.field(lensRadiusControl(scene, volume), 'Lens')}
      ${this.field(sceneChoiceControl('lens.mode', 'Mode', scene), 'Lens')}
      ${this.field(sceneChoiceControl('lens.cap', 'Cut surfaces', scene), 'Lens')}
      ${shapes.length > 1 ? this.field(shape.choice, 'Lens') : nothing}
      <cutaway-module-fields
        .controls=${shape.controls}
        .group=${'Lens'}
        .change=${this.change}
      ></cutaway-module-fields>
    </cutaway-section>`;
  }

  private light({ scene }: Known) {
    return html`<cutaway-section heading="Light and background">
      ${this.field(sceneChoiceControl('light.frame', 'Light turns with', scene), 'Light')}
      ${lightControls(scene).map((control) => this.field(control, 'Light'))}
      ${this.field(backgroundControl(scene), '')}
    </cutaway-section>`;
  }
}
