// A point in the patient: millimetres along each of the patient's directions.
import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { CoordinateControl } from '../state/lens_controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { control_styles } from '../styles/controls.ts';
import { shared } from '../styles/shared.ts';

const DIGITS = 1;

@customElement('cutaway-coordinate-fields')
export class CoordinateFields extends LitElement {
  @property({ attribute: false }) controls: readonly CoordinateControl[] = [];
  @property({ attribute: false }) heading = '';
  /** Says whose point it is, for names that are unique on the page. */
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  static override styles = [
    shared,
    control_styles,
    css`
      .fields {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
      }
      label {
        display: flex;
        align-items: center;
        border: 1px solid var(--line-strong);
        border-radius: 6px;
        background: var(--surface-raised);
      }
      label:focus-within {
        outline: 2px solid var(--accent);
        outline-offset: 1px;
      }
      .letter {
        padding: 0 2px 0 9px;
        color: var(--text-quiet);
        font-weight: 600;
      }
      input {
        width: 100%;
        min-width: 0;
        min-height: 30px;
        padding: 2px 9px 2px 0;
        border: 0;
        outline: 0;
      }
      @media (pointer: coarse) {
        input {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    const [first] = this.controls;
    return html`<div class="head" title=${first?.description ?? ''}>
        <span>${this.heading}</span><span class="quiet small">${first?.unit ?? ''}</span>
      </div>
      <div class="fields">${this.controls.map((control) => this.field(control))}</div>`;
  }

  private field(control: CoordinateControl) {
    const { letter, label, unit, value, minimum, maximum } = control;
    return html`<label title=${label}>
      <span class="letter" aria-hidden="true">${letter}</span>
      <input
        type="number"
        aria-label="${this.group}: ${label}, ${unit}"
        min=${minimum}
        max=${maximum}
        step="any"
        .value=${live(value.toFixed(DIGITS))}
        @change=${(event: Event) => this.set((event.target as HTMLInputElement).value, control)}
      />
    </label>`;
  }

  /** What is no number leaves the point where it is. */
  private set(text: string, { minimum, maximum, toPatch }: CoordinateControl): void {
    const value = Number.parseFloat(text);
    if (Number.isFinite(value)) this.change(toPatch(Math.min(maximum, Math.max(minimum, value))));
    this.requestUpdate();
  }
}
