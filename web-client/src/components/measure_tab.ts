// What was measured in this volume: named, deleted, saved as a file. The tools once more, for those
// who come by keyboard.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { measurementsOf, toolInHand } from '../state/measure_state.ts';
import { LONGEST_NAME } from '../state/measurement_list.ts';
import { MEASUREMENT_KINDS, resultOf, type Measurement } from '../view/measurement.ts';
import { positionText, resultText } from '../state/measure_text.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-measure-tab')
export class MeasureTab extends SessionElement {
  protected override readonly draws = ['measure', 'volume', 'capabilities'] as const;

  static override styles = [
    shared,
    css`
      .tools {
        display: grid;
        grid-template-columns: repeat(3, 1fr);
        gap: 6px;
        margin: 8px 0 14px;
      }
      .tools button {
        display: grid;
        justify-items: center;
        gap: 3px;
        padding: 8px 4px;
        font-size: 13px;
      }
      .tools [aria-pressed='true'] {
        border-color: var(--accent);
        background: var(--accent);
        color: var(--on-accent);
      }
      h2 {
        margin: 0 2px 8px;
        font-size: 14px;
        font-weight: 600;
      }
      ul {
        display: grid;
        gap: 6px;
      }
      li {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) auto auto;
        align-items: center;
        padding-left: 2px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
      }
      li.chosen {
        border-color: var(--accent);
        box-shadow: inset 3px 0 0 var(--accent);
      }
      input {
        min-width: 0;
        padding: 5px 6px;
        border: 1px solid transparent;
        border-radius: 6px;
        background: transparent;
        color: var(--text);
        font: inherit;
      }
      input:hover,
      input:focus {
        border-color: var(--line-strong);
        background: var(--surface);
      }
      .result {
        padding-left: 8px;
        font-weight: 600;
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
      }
      .where {
        grid-column: 2 / -1;
        padding: 0 7px 7px;
        font-variant-numeric: tabular-nums;
      }
      .files {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
        margin-top: 14px;
      }
      .files button {
        display: inline-flex;
        align-items: center;
        gap: 5px;
        padding-inline: 10px;
      }
      .files button:last-child {
        margin-left: auto;
      }
      .how {
        margin: 0 2px;
      }
      .notice {
        margin: 12px 2px 0;
        color: var(--warning);
      }
      @media (pointer: coarse) {
        input {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    const { measure, volume, capabilities } = this.state;
    const list = measurementsOf(measure, volume);
    return html`
      <div class="tools" role="group" aria-label=${words().measure.tools}>
        ${MEASUREMENT_KINDS.map((kind) => this.tool(kind))}
      </div>
      ${
        list.length === 0
          ? html`<p class="quiet how">${words().measure.none} ${words().measure.how}</p>`
          : html`<h2 id="list">${words().measure.list}</h2>
              <ul aria-labelledby="list">
                ${list.map((one) => this.entry(one))}
              </ul>
              ${this.files(capabilities?.notice ?? '')}`
      }
    `;
  }

  private tool(kind: (typeof MEASUREMENT_KINDS)[number]) {
    const { measure, volume } = this.state;
    return html`<button
      class="text-button"
      aria-pressed=${toolInHand(measure) === kind ? 'true' : 'false'}
      title=${words().measure.tool_titles[kind]}
      ?disabled=${!volume}
      @click=${() => this.session.measuring.take(kind)}
    >
      <wa-icon name=${kind}></wa-icon>${words().measure.kinds[kind]}
    </button>`;
  }

  private entry(one: Measurement) {
    const { measuring, measured } = this.session;
    const { id, kind, name, points } = one;
    const chosen = this.state.measure.selected === id;
    const result = resultOf(one, this.state.volume?.units ?? 'none');
    const [first] = points;
    return html`<li class=${chosen ? 'chosen' : ''} data-measurement=${name}>
      <button
        class="icon-button"
        aria-label=${words().measure.show(name)}
        title=${words().measure.show(name)}
        aria-pressed=${chosen ? 'true' : 'false'}
        @click=${() => measuring.select(chosen ? undefined : id)}
      >
        <wa-icon name=${kind}></wa-icon>
      </button>
      <input
        aria-label=${words().measure.rename(name)}
        maxlength=${LONGEST_NAME}
        .value=${live(name)}
        @change=${(event: Event) => this.rename(id, event.target as HTMLInputElement)}
      />
      <span class="result">${result ? resultText(result) : ''}</span>
      <button
        class="icon-button"
        aria-label=${words().measure.remove(name)}
        title=${words().measure.remove(name)}
        @click=${() => measured.remove(id)}
      >
        <wa-icon name="remove"></wa-icon>
      </button>
      ${
        kind === 'probe' && first
          ? html`<span class="where quiet small">${positionText(first.position_mm)}</span>`
          : nothing
      }
    </li>`;
  }

  private rename(id: number, input: HTMLInputElement): void {
    this.session.measured.rename(id, input.value);
    this.requestUpdate();
  }

  private files(notice: string) {
    const { measured } = this.session;
    const { as_csv, as_json, remove_all } = words().measure;
    const file = (format: 'csv' | 'json', label: string) =>
      html`<button
        class="text-button"
        aria-label=${label}
        title=${label}
        @click=${() => measured.exportAs(format, notice)}
      >
        <wa-icon name="save"></wa-icon>${format.toUpperCase()}
      </button>`;
    return html`<div class="files">
        ${file('csv', as_csv)} ${file('json', as_json)}
        <button class="text-button" @click=${() => measured.removeAll()}>
          <wa-icon name="remove"></wa-icon>${remove_all}
        </button>
      </div>
      <p class="small notice">${notice}</p>`;
  }
}
