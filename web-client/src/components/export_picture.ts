// The current view as a lossless picture.
import { html, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { chosenSize, picturePresets, type SizeWish } from '../film/picture_size.ts';
import { export_styles } from '../styles/export.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './export_size.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-export-picture')
export class ExportPicture extends SessionElement {
  protected override readonly draws = ['capabilities', 'viewport'] as const;

  @property({ attribute: false }) wish!: SizeWish;
  @property({ attribute: false }) chosen!: (wish: SizeWish) => void;

  static override styles = [shared, export_styles];

  override render() {
    const { capabilities, viewport } = this.state;
    if (!capabilities || !viewport) return nothing;
    const limit_px = capabilities.limits.still_side_px;
    const presets = picturePresets(viewport, limit_px);
    const { size, dots_per_inch } = chosenSize(this.wish, presets);
    const save = (): void => void this.session.exporting.savePicture(size, dots_per_inch);
    return html`<cutaway-export-size
        .wish=${this.wish}
        .presets=${presets}
        .view=${viewport}
        .limit_px=${limit_px}
        .chosen=${this.chosen}
      ></cutaway-export-size>
      <p class="quiet small">${words().export.picture_note(capabilities.notice)}</p>
      <button class="text-button primary" @click=${save}>${words().export.save_picture}</button>`;
  }
}
