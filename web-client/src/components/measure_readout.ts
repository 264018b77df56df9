// What the tool in hand waits for, and what lies under the pointer.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { resultOf } from '../view/measurement.ts';
import { measurementsOf, type Candidate } from '../state/measure_state.ts';
import type { Draft } from '../state/measurement_list.ts';
import { positionText, resultText, valueText } from '../state/measure_text.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-measure-readout')
export class MeasureReadout extends SessionElement {
  protected override readonly draws = ['measure', 'volume'] as const;

  static override styles = [
    shared,
    css`
      :host {
        position: absolute;
        left: 50%;
        /* Above the notices, which stay visible. */
        bottom: 78px;
        transform: translateX(-50%);
        width: max-content;
        max-width: calc(100% - 24px);
      }
      .card {
        display: flex;
        align-items: center;
        gap: 10px;
        padding: 4px 4px 4px 14px;
        border: 1px solid rgb(255 255 255 / 14%);
        border-radius: 11px;
        background: rgb(16 21 25 / 92%);
        color: #e9eef1;
        font-size: 13px;
      }
      .texts {
        display: grid;
        min-width: 208px;
      }
      .step {
        color: #ffbe7d;
        font-weight: 550;
      }
      .found {
        min-height: 1.45em;
        color: #cfd8dd;
        font-variant-numeric: tabular-nums;
      }
      .value {
        color: #fff;
        font-weight: 600;
      }
      .icon-button {
        color: #cfd8dd;
      }
    `,
  ];

  override render() {
    const { draft, candidate } = this.state.measure;
    if (!draft) return nothing;
    const spoken = candidate?.by_keys === true;
    return html`<div class="card" data-part="measure-readout">
      <div class="texts">
        <span class="step" role="status">${this.lastResult(draft)}${this.step(draft)}</span>
        <span class="found" aria-live=${spoken ? 'polite' : 'off'}
          >${this.found(draft, candidate)}</span
        >
      </div>
      <div>
        ${
          draft.points.length > 0
            ? this.button('take-back', words().measure.take_back, () =>
                this.session.measuring.takeBackPoint(),
              )
            : nothing
        }
        ${this.button('close', words().measure.put_away, () =>
          this.session.measuring.take(draft.kind),
        )}
      </div>
    </div>`;
  }

  private step({ kind, points }: Draft): string {
    return words().measure.steps[kind][points.length] ?? '';
  }

  /** Of the measurement that was finished just now, for those who do not see it in the picture. */
  private lastResult({ points }: Draft) {
    const { measure, volume } = this.state;
    const last = measurementsOf(measure, volume).find(({ id }) => id === measure.selected);
    const result = last && volume && resultOf(last, volume.units);
    if (!result || points.length > 0) return nothing;
    const text = words().measure.measured(last.name, resultText(result));
    return html`<span class="visually-hidden">${text}. </span>`;
  }

  private found({ kind, points }: Draft, candidate: Candidate | undefined) {
    const { volume } = this.state;
    if (!candidate || !volume) return words().measure.surface_hint;
    const { view, found, answered } = candidate;
    const nothing_there = words().measure.nothing_there[view === '3d' ? 'volume' : 'slice'];
    if (!found) return answered ? nothing_there : '…';
    const value = valueText(found.value, volume.units);
    const result = resultOf({ kind, points: [...points, found] }, volume.units);
    const so_far = kind !== 'probe' && result ? `${resultText(result)} · ` : '';
    const where = positionText(found.position_mm);
    return html`<span class="value">${so_far}${value}</span> · ${where}`;
  }

  private button(icon: string, label: string, action: () => void) {
    return html`<button class="icon-button" aria-label=${label} title=${label} @click=${action}>
      <wa-icon name=${icon}></wa-icon>
    </button>`;
  }
}
