// The controls of one module: the basic ones, and behind a fold the advanced ones.
import { css, html, LitElement, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { JsonObject } from '../state/merge_patch.ts';
import type { ControlLevels } from '../state/module_model.ts';
import type { ToneRamp } from '../state/tone_ramp.ts';
import type { Control } from '../state/controls.ts';
import { shared } from '../styles/shared.ts';
import './control_field.ts';
import './tone_ramp.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-module-fields')
export class ModuleFields extends LitElement {
  @property({ attribute: false }) controls!: ControlLevels;
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  static override styles = [
    shared,
    css`
      :host,
      .list {
        display: grid;
        gap: 6px;
      }
      summary {
        padding: 6px 0;
        color: var(--text-quiet);
        font-size: 12px;
        cursor: pointer;
      }
      @media (pointer: coarse) {
        summary {
          padding: 13px 0;
        }
      }
    `,
  ];

  override render() {
    const { ramp, basic, advanced } = this.controls;
    return html`
      ${ramp ? this.tones(ramp) : nothing} ${basic.map((control) => this.field(control))}
      ${
        advanced.length === 0
          ? nothing
          : html`<details>
              <summary>${words().panel.advanced}</summary>
              <div class="list">${advanced.map((control) => this.field(control))}</div>
            </details>`
      }
    `;
  }

  private tones(ramp: ToneRamp) {
    return html`<cutaway-tone-ramp
      .ramp=${ramp}
      .group=${this.group}
      .change=${this.change}
    ></cutaway-tone-ramp>`;
  }

  private field(control: Control) {
    return html`<cutaway-control
      .control=${control}
      .group=${this.group}
      .change=${this.change}
    ></cutaway-control>`;
  }
}
