// One control of the panel, whatever its kind.
import '@awesome.me/webawesome/dist/components/option/option.js';
import '@awesome.me/webawesome/dist/components/select/select.js';
import '@awesome.me/webawesome/dist/components/slider/slider.js';
import '@awesome.me/webawesome/dist/components/switch/switch.js';
import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type {
  BooleanControl,
  ChoiceControl,
  ColourControl,
  Control,
  NumberControl,
} from '../state/controls.ts';
import { fromHex, toHex } from '../state/colour.ts';
import type { Json, JsonObject } from '../state/merge_patch.ts';
import { shared } from '../styles/shared.ts';

/** Digits after the point that a step asks for. */
function digitsOf(step: number): number {
  return Math.max(0, Math.min(6, Math.ceil(-Math.log10(step) - 1e-9)));
}

/** A slider's value is a number, a field's its text. */
const inputValue = (event: Event): number | string =>
  (event.target as unknown as { value: number | string }).value;

@customElement('cutaway-control')
export class ControlField extends LitElement {
  @property({ attribute: false }) control!: Control;
  /** Says whose control it is, for a name that is unique on the page: 'Focus'. */
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  static override styles = [
    shared,
    css`
      :host {
        display: block;
        font-size: 13px;
      }
      .head {
        display: flex;
        justify-content: space-between;
        align-items: center;
        gap: 8px;
        min-height: 26px;
      }
      .number {
        width: 72px;
        padding: 2px 6px;
        border: 1px solid transparent;
        border-radius: 6px;
        background: transparent;
        color: var(--text);
        font: inherit;
        font-variant-numeric: tabular-nums;
        text-align: right;
        appearance: textfield;
        -moz-appearance: textfield;
      }
      .number::-webkit-inner-spin-button {
        display: none;
      }
      .number:hover,
      .number:focus {
        border-color: var(--line-strong);
        background: var(--surface-raised);
      }
      .unit {
        margin-left: 2px;
        color: var(--text-quiet);
        font-size: 12px;
      }
      wa-slider {
        --track-size: 4px;
        --thumb-width: 16px;
        --thumb-height: 16px;
        display: block;
        margin: 2px 8px 4px;
      }
      wa-slider::part(indicator) {
        background: var(--accent);
      }
      wa-slider::part(track) {
        background: var(--line-strong);
      }
      wa-slider::part(label) {
        display: none;
      }
      wa-select {
        width: 100%;
      }
      wa-select::part(form-control-label) {
        margin-bottom: 4px;
        font-size: 13px;
        font-weight: 400;
      }
      wa-select::part(display-input) {
        font-size: 13px;
      }
      .row {
        display: flex;
        align-items: center;
        justify-content: space-between;
        min-height: 36px;
      }
      input[type='color'] {
        width: 48px;
        height: 28px;
        padding: 2px;
        border: 1px solid var(--line-strong);
        border-radius: 7px;
        background: transparent;
        cursor: pointer;
      }
      @media (pointer: coarse) {
        input[type='color'] {
          width: 64px;
          height: 44px;
        }
        .number {
          min-height: 40px;
        }
        wa-select::part(combobox) {
          min-height: 44px;
        }
        wa-slider {
          --thumb-width: 24px;
          --thumb-height: 24px;
          margin: 8px 12px 10px;
        }
      }
    `,
  ];

  override render() {
    const { control } = this;
    switch (control.kind) {
      case 'number':
        return this.numberField(control);
      case 'choice':
        return this.choiceField(control);
      case 'boolean':
        return this.booleanField(control);
      case 'colour':
        return this.colourField(control);
    }
  }

  private get fullName(): string {
    return this.group ? `${this.group}: ${this.control.label}` : this.control.label;
  }

  private set(value: Json): void {
    this.change(this.control.toPatch(value));
  }

  private setNumber(text: number | string, { minimum, maximum }: NumberControl): void {
    const value = typeof text === 'string' ? Number.parseFloat(text) : text;
    if (Number.isFinite(value)) this.set(Math.min(maximum, Math.max(minimum, value)));
    this.requestUpdate();
  }

  private valueText(value: number, { step, unit }: NumberControl): string {
    return `${value.toFixed(digitsOf(step))} ${unit}`.trim();
  }

  private numberField(control: NumberControl) {
    const shown = control.value.toFixed(digitsOf(control.step));
    return html`
      <div class="head" title=${control.description}>
        <span aria-hidden="true">${control.label}</span>
        <span>
          <input
            class="number"
            type="number"
            aria-label="${this.fullName}, number"
            min=${control.minimum}
            max=${control.maximum}
            step="any"
            .value=${live(shown)}
            @change=${(event: Event) => this.setNumber(inputValue(event), control)}
          /><span class="unit">${control.unit}</span>
        </span>
      </div>
      <wa-slider
        label=${this.fullName}
        min=${control.minimum}
        max=${control.maximum}
        step=${control.step}
        .value=${live(control.value)}
        .valueFormatter=${(value: number) => this.valueText(value, control)}
        @input=${(event: Event) => this.setNumber(inputValue(event), control)}
      ></wa-slider>
    `;
  }

  private choiceField(control: ChoiceControl) {
    return html`<wa-select
      size="s"
      label=${control.label}
      title=${control.description}
      .value=${live(control.value)}
      @change=${(event: Event) => this.set((event.target as HTMLSelectElement).value)}
    >
      ${control.choices.map(({ value, label }) => html`<wa-option value=${value}>${label}</wa-option>`)}
    </wa-select>`;
  }

  private booleanField(control: BooleanControl) {
    return html`<div class="row" title=${control.description}>
      <wa-switch
        size="s"
        ?checked=${live(control.value)}
        @change=${(event: Event) => this.set((event.target as HTMLInputElement).checked)}
        >${control.label}</wa-switch
      >
    </div>`;
  }

  private colourField(control: ColourControl) {
    return html`<label class="row" title=${control.description}>
      <span>${control.label}</span>
      <input
        type="color"
        aria-label=${this.fullName}
        .value=${live(toHex(control.value))}
        @input=${(event: Event) => this.set(fromHex((event.target as HTMLInputElement).value))}
      />
    </label>`;
  }
}
