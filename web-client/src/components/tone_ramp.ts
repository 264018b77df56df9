// A shading's dark and light colour with what it makes of them between: a click on an end chooses
// its colour.
import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { styleMap } from 'lit/directives/style-map.js';
import { fromHex, toHex } from '../state/colour.ts';
import type { ColourControl } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { rampGradient, type ToneRamp } from '../state/tone_ramp.ts';
import { control_styles } from '../styles/controls.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-tone-ramp')
export class ToneRampPicker extends LitElement {
  @property({ attribute: false }) ramp!: ToneRamp;
  /** Says whose colours they are, for names that are unique on the page. */
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  static override styles = [
    shared,
    control_styles,
    css`
      .ramp {
        display: flex;
        justify-content: space-between;
        height: 36px;
        padding: 4px;
        border: 1px solid var(--line-strong);
        border-radius: 9px;
      }
      input {
        width: 44px;
        height: 100%;
        padding: 0;
        border: 1.5px solid rgb(255 255 255 / 85%);
        border-radius: 6px;
        box-shadow: 0 0 0 1px rgb(0 0 0 / 55%);
        background: transparent;
        cursor: pointer;
      }
      input::-webkit-color-swatch-wrapper {
        padding: 0;
      }
      input::-webkit-color-swatch {
        border: 0;
        border-radius: 4px;
      }
      @media (pointer: coarse) {
        .ramp {
          height: 54px;
        }
        input {
          width: 60px;
        }
      }
    `,
  ];

  override render() {
    const { dark, light } = this.ramp;
    return html`<div class="head"><span>${words().look.tones}</span></div>
      <div class="ramp" style=${styleMap({ background: rampGradient(this.ramp) })}>
        ${this.end(dark)} ${this.end(light)}
      </div>`;
  }

  private end(control: ColourControl) {
    return html`<input
      type="color"
      aria-label="${this.group}: ${control.label}"
      title="${control.label}. ${control.description}"
      .value=${live(toHex(control.value))}
      @input=${(event: Event) =>
        this.change(control.toPatch(fromHex((event.target as HTMLInputElement).value)))}
    />`;
  }
}
