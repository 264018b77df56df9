// The band of values that a branch draws, chosen on the volume's histogram: handles at its ends,
// numbers, and on CT the tissues by name.
import { html, LitElement, nothing } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import type { NumberControl } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { valueText } from '../state/measure_text.ts';
import type { BandModel } from '../state/surface_controls.ts';
import type { TissuePreset } from '../state/tissue_presets.ts';
import { chip_styles } from '../styles/chips.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { nearestEnd, shareOf, steppedValue, valueAtShare } from '../state/band_handles.ts';
import './control_field.ts';
import './histogram.ts';
import { band_editor_styles } from './band_editor_styles.ts';

@customElement('cutaway-band-editor')
export class BandEditor extends LitElement {
  @property({ attribute: false }) model!: BandModel;
  @property({ attribute: false }) counts: readonly number[] = [];
  @property({ attribute: false }) tissues: readonly TissuePreset[] = [];
  /** Says whose band it is, for names that are unique on the page. */
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;
  @query('.plot') private plot!: HTMLElement;

  /** The end that is being dragged, by its control's id. */
  private dragged: string | undefined;

  static override styles = [shared, chip_styles, band_editor_styles];

  override render() {
    const { lower, upper, has_upper } = this.model;
    const band = { lower: shareOf(lower), upper: upper && shareOf(upper) };
    return html`
      ${this.tissues.length > 0 ? this.presets() : nothing}
      <div
        class="plot"
        title=${words().look.histogram}
        data-part="histogram"
        @pointerdown=${this.grab}
        @pointermove=${this.drag}
        @pointerup=${this.release}
        @pointercancel=${this.release}
      >
        <cutaway-histogram .counts=${this.counts} .band=${band}></cutaway-histogram>
        ${this.handle(lower)} ${upper ? this.handle(upper) : nothing}
      </div>
      <div class="range" aria-hidden="true">
        <span>${this.text(lower.minimum)}</span><span>${this.text(lower.maximum)}</span>
      </div>
      ${this.field(lower)} ${this.field(has_upper)} ${upper ? this.field(upper) : nothing}
    `;
  }

  private presets() {
    const label = `${this.group}: ${words().look.tissue_presets}`;
    return html`<div class="tissues" role="group" aria-label=${label}>
      ${this.tissues.map((preset) => this.preset(preset))}
    </div>`;
  }

  private preset({ tissue, lower, upper, chosen, occurs, patch }: TissuePreset) {
    const { look } = words();
    const range =
      upper === undefined
        ? look.from(valueText(lower, 'HU'))
        : look.between(valueText(lower, 'none'), valueText(upper, 'HU'));
    return html`<button
      class="chip"
      aria-pressed=${chosen ? 'true' : 'false'}
      ?disabled=${!occurs}
      title=${occurs ? range : look.not_in_volume}
      data-tissue=${tissue}
      @click=${() => this.change(patch)}
    >
      ${look.tissues[tissue]}
    </button>`;
  }

  private text(value: number): string {
    return valueText(value, this.model.lower.unit || 'none');
  }

  private handle(control: NumberControl) {
    return html`<button
      class="handle"
      role="slider"
      aria-label="${this.group}: ${control.label}"
      aria-valuemin=${control.minimum}
      aria-valuemax=${control.maximum}
      aria-valuenow=${control.value}
      aria-valuetext=${this.text(control.value)}
      style=${styleMap({ left: `${(shareOf(control) * 100).toFixed(3)}%` })}
      data-end=${control.id}
      @keydown=${(event: KeyboardEvent) => this.onKey(event, control)}
    ></button>`;
  }

  private field(control: BandModel['lower' | 'has_upper']) {
    return html`<cutaway-control
      .control=${control}
      .group=${this.group}
      .change=${this.change}
      .bare=${true}
    ></cutaway-control>`;
  }

  private onKey(event: KeyboardEvent, control: NumberControl): void {
    const value = steppedValue(control, event.key, event.shiftKey);
    if (value === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.change(control.toPatch(value));
  }

  private share(event: PointerEvent): number {
    const { left, width } = this.plot.getBoundingClientRect();
    return (event.clientX - left) / Math.max(1, width);
  }

  private grab(event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    this.plot.setPointerCapture(event.pointerId);
    const end = nearestEnd(this.model, this.share(event));
    this.dragged = end.id;
    this.renderRoot.querySelector<HTMLElement>(`[data-end=${end.id}]`)?.focus();
    this.drag(event);
  }

  private drag(event: PointerEvent): void {
    const { lower, upper } = this.model;
    const control = [lower, upper].find((end) => end?.id === this.dragged);
    if (control) this.change(control.toPatch(valueAtShare(control, this.share(event))));
  }

  private release(): void {
    this.dragged = undefined;
  }
}
