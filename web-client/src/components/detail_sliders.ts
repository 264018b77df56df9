// From toon to smooth, for each branch whose shading can be either.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { BranchName } from '../state/filter_model.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { moduleModel } from '../state/module_model.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

const BRANCHES: readonly BranchName[] = ['focus', 'context'];

@customElement('cutaway-detail-sliders')
export class DetailSliders extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene'] as const;

  static override styles = [
    shared,
    css`
      .sliders {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 0 14px;
        margin: 0 0 14px;
        padding: 8px 10px 6px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
      }
      /* As high as it will be: the styles below stay where they are when it comes. */
      cutaway-control:not(:defined) {
        display: block;
        min-height: 40px;
      }
      @media (pointer: coarse) {
        cutaway-control:not(:defined) {
          min-height: 66px;
        }
      }
      h2 {
        grid-column: 1 / -1;
        color: var(--text-quiet);
        font-size: 12px;
        font-weight: 400;
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  override render() {
    const sliders = BRANCHES.map((branch) => this.slider(branch)).filter(Boolean);
    return sliders.length === 0
      ? nothing
      : html`<div class="sliders">
          <h2>${words().look.detail_range}</h2>
          ${sliders}
        </div>`;
  }

  private slider(branch: BranchName) {
    const { capabilities, scene } = this.state;
    if (!capabilities || !scene) return undefined;
    const { shading } = capabilities.modules;
    const { ramp } = moduleModel('', [branch, 'shading'], shading, scene).controls;
    if (!ramp?.detail) return undefined;
    const group = words().look.detail;
    const control = { ...ramp.detail, label: words().panel.adjust[branch] };
    return html`<cutaway-control
      .control=${control}
      .group=${group}
      .change=${this.change}
    ></cutaway-control>`;
  }
}
