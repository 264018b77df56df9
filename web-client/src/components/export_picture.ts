// A view as it is now, as a lossless picture.
import { html, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { chosenSize, picturePresets, withSide, type SizeWish } from '../film/picture_size.ts';
import type { Control } from '../state/controls.ts';
import { openViews, viewportOf } from '../state/slice_views.ts';
import type { ViewName } from '../state/views.ts';
import { export_styles } from '../styles/export.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './control_field.ts';
import './export_labels.ts';
import './export_size.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-export-picture')
export class ExportPicture extends SessionElement {
  protected override readonly draws = [
    'capabilities',
    'viewport',
    'slice_views',
    'exporting',
  ] as const;

  @property({ attribute: false }) wish!: SizeWish;
  @property({ attribute: false }) chosen!: (wish: SizeWish) => void;

  static override styles = [shared, export_styles];

  override render() {
    const { capabilities } = this.state;
    const { view } = this;
    const viewport = viewportOf(this.state, view);
    if (!capabilities || !viewport) return nothing;
    const limit_px = capabilities.limits.still_side_px;
    const presets = picturePresets(viewport, limit_px);
    const { size, dots_per_inch } = chosenSize(this.wish, presets);
    const save = (): void => void this.session.exporting.savePicture(view, size, dots_per_inch);
    return html`${this.viewChoice(view)}
      <cutaway-export-size
        .wish=${this.wish}
        .presets=${presets}
        .view=${viewport}
        .limit_px=${limit_px}
        .chosen=${this.chosen}
      ></cutaway-export-size>
      <cutaway-export-labels .session=${this.session} what="picture"></cutaway-export-labels>
      <button class="text-button primary" @click=${save}>${words().export.save_picture}</button>`;
  }

  /** One that was closed meanwhile gives way to the volume. */
  private get view(): ViewName {
    const { view } = this.state.exporting;
    return openViews(this.state).includes(view) ? view : '3d';
  }

  private viewChoice(view: ViewName) {
    const views = openViews(this.state);
    if (views.length < 2) return nothing;
    const { names } = words().slices;
    const control: Control = {
      kind: 'choice',
      id: 'export-view',
      label: words().export.picture_of,
      description: '',
      value: view,
      choices: views.map((value) => ({ value, label: names[value] })),
      toPatch: (value) => ({ view: value }),
    };
    const change = (patch: { readonly view?: unknown }): void =>
      this.chooseView(patch.view as ViewName);
    return html`<cutaway-control .control=${control} .change=${change}></cutaway-control>`;
  }

  /** Own sides that keep the view's shape get that of the other view. */
  private chooseView(view: ViewName): void {
    this.session.exporting.chooseView(view);
    const { own, keeps_shape } = this.wish;
    const viewport = viewportOf(this.state, view);
    const limit_px = this.state.capabilities?.limits.still_side_px;
    if (!keeps_shape || !viewport || !limit_px) return;
    const sides = withSide(own, 'width_px', own.width_px, viewport, limit_px);
    this.chosen({ ...this.wish, own: sides });
  }
}
