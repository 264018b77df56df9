// One control of the panel, whatever its kind.
import '@awesome.me/webawesome/dist/components/option/option.js';
import '@awesome.me/webawesome/dist/components/select/select.js';
import '@awesome.me/webawesome/dist/components/slider/slider.js';
import '@awesome.me/webawesome/dist/components/switch/switch.js';
import { html, LitElement, nothing } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
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
import { control_styles } from '../styles/controls.ts';
import { shared } from '../styles/shared.ts';
import { control_field_styles } from './control_field_styles.ts';
import { words } from '../words/words.ts';

/** Digits after the point that a step asks for. */
function digitsOf(step: number): number {
  return Math.max(0, Math.min(6, Math.ceil(-Math.log10(step) - 1e-9)));
}

const unitText = (unit: string): string => words().served.units[unit] ?? unit;

/** A slider's value is a number, a field's its text. */
const inputValue = (event: Event): number | string =>
  (event.target as unknown as { value: number | string }).value;

@customElement('cutaway-control')
export class ControlField extends LitElement {
  @property({ attribute: false }) control!: Control;
  /** Says whose control it is, for a name that is unique on the page: 'Focus'. */
  @property({ attribute: false }) group = '';
  /** A number without its slider: what stands above it takes that place. */
  @property({ attribute: false }) bare = false;
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  /** A number on its way: what else changes on the page meanwhile leaves it alone. */
  @state() private typed: string | undefined;

  static override styles = [shared, control_styles, control_field_styles];

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

  /** A visible label need not say again whose it is, one that is read out must. */
  private spokenGroup() {
    return this.group ? html`<span class="visually-hidden">${this.group}: </span>` : nothing;
  }

  private set(value: Json): void {
    this.change(this.control.toPatch(value));
  }

  private setNumber(text: number | string, control: NumberControl): void {
    const { minimum, maximum } = control.accepts ?? control;
    const value = typeof text === 'string' ? Number.parseFloat(text) : text;
    this.typed = undefined;
    if (Number.isFinite(value)) this.set(Math.min(maximum, Math.max(minimum, value)));
    this.requestUpdate();
  }

  private valueText(value: number, { step, unit }: NumberControl): string {
    return `${words().number(value, digitsOf(step))} ${unitText(unit)}`.trim();
  }

  private numberField(control: NumberControl) {
    const shown = control.value.toFixed(digitsOf(control.step));
    const { minimum, maximum } = control.accepts ?? control;
    return html`
      <div class="head" title=${control.description}>
        <span aria-hidden="true">${control.label}</span>
        <span>
          <input
            class="number"
            type="number"
            aria-label=${words().controls.as_number(this.fullName)}
            min=${minimum}
            max=${maximum}
            step="any"
            .value=${live(this.typed ?? shown)}
            @input=${(event: Event) => (this.typed = String(inputValue(event)))}
            @change=${(event: Event) => this.setNumber(inputValue(event), control)}
            @blur=${() => (this.typed = undefined)}
          /><span class="unit">${unitText(control.unit)}</span>
        </span>
      </div>
      ${this.bare ? nothing : this.slider(control)}
    `;
  }

  private slider(control: NumberControl) {
    return html`<wa-slider
      label=${this.fullName}
      min=${control.minimum}
      max=${control.maximum}
      step=${control.step}
      .value=${live(control.value)}
      .valueFormatter=${(value: number) => this.valueText(value, control)}
      @input=${(event: Event) => this.setNumber(inputValue(event), control)}
    ></wa-slider>`;
  }

  private choiceField(control: ChoiceControl) {
    return html`<wa-select
      size="s"
      title=${control.description}
      .value=${live(control.value)}
      @change=${(event: Event) => this.set((event.target as HTMLSelectElement).value)}
    >
      <span slot="label">${this.spokenGroup()}${control.label}</span>
      ${control.choices.map(({ value, label }) => html`<wa-option value=${value}>${label}</wa-option>`)}
    </wa-select>`;
  }

  private booleanField(control: BooleanControl) {
    return html`<div class="row" title=${control.description}>
      <wa-switch
        size="s"
        ?checked=${live(control.value)}
        @change=${(event: Event) => this.set((event.target as HTMLInputElement).checked)}
        >${this.spokenGroup()}${control.label}</wa-switch
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
