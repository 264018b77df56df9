// The size of an exported picture: one of a few, or two sides.
import { css, html, LitElement, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { chosenSize, withSide, type SizePreset, type SizeWish } from '../film/picture_size.ts';
import type { Control } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { shared } from '../styles/shared.ts';
import type { Viewport } from '../view/camera.ts';
import { words } from '../words/words.ts';
import './control_field.ts';

@customElement('cutaway-export-size')
export class ExportSize extends LitElement {
  @property({ attribute: false }) wish!: SizeWish;
  @property({ attribute: false }) presets: readonly SizePreset[] = [];
  /** Whose shape may be kept. */
  @property({ attribute: false }) view!: Viewport;
  @property({ attribute: false }) limit_px = 0;
  @property({ attribute: false }) chosen!: (wish: SizeWish) => void;

  static override styles = [
    shared,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      .sides {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 0 18px;
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void =>
    this.chosen({ ...this.wish, ...(patch as Partial<SizeWish>) });

  override render() {
    return html`${this.field(this.presetControl())}
      <div class="sides">
        ${this.field(this.sideControl('width_px', words().export.width))}
        ${this.field(this.sideControl('height_px', words().export.height))}
      </div>
      ${this.field(this.shapeControl())}
      ${this.wish.keeps_shape ? nothing : html`<p class="quiet small">${words().export.free_shape_hint}</p>`}`;
  }

  private field(control: Control) {
    return html`<cutaway-control
      .control=${control}
      .change=${this.change}
      .bare=${true}
    ></cutaway-control>`;
  }

  private presetControl(): Control {
    const { presets: names, preset, pixels, size: label } = words().export;
    const choices = this.presets.map(({ id, size }) => ({
      value: id,
      label: preset(names[id], pixels(size.width_px, size.height_px)),
    }));
    return {
      kind: 'choice',
      id: 'export-preset',
      label,
      description: '',
      value: this.wish.preset,
      choices: [...choices, { value: 'own', label: names.own }],
      // Own sides begin with those of the preset before.
      toPatch: (value) => ({ preset: value, own: { ...this.size } }),
    };
  }

  private sideControl(side: 'width_px' | 'height_px', label: string): Control {
    const keeps = this.wish.keeps_shape ? this.view : undefined;
    return {
      kind: 'number',
      id: `export-${side}`,
      label,
      description: '',
      value: this.size[side],
      minimum: 1,
      maximum: this.limit_px,
      step: 1,
      unit: 'px',
      toPatch: (value) => ({
        preset: 'own',
        own: { ...withSide(this.size, side, Number(value), keeps, this.limit_px) },
      }),
    };
  }

  private shapeControl(): Control {
    return {
      kind: 'boolean',
      id: 'export-shape',
      label: words().export.keep_shape,
      description: '',
      value: this.wish.keeps_shape,
      toPatch: (value) => {
        const { width_px } = this.size;
        const own = value
          ? withSide(this.size, 'width_px', width_px, this.view, this.limit_px)
          : this.size;
        return { keeps_shape: value, own: { ...own } };
      },
    };
  }

  private get size(): Viewport {
    return chosenSize(this.wish, this.presets).size;
  }
}
