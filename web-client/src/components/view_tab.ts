// From where one looks, and what the connection and the renderer do.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { JsonObject } from '../state/merge_patch.ts';
import { fieldOfViewControl, projectionControl } from '../state/scene_controls.ts';
import { STANDARD_VIEWS } from '../view/orientation.ts';
import { shared } from '../styles/shared.ts';
import './control_field.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-view-tab')
export class ViewTab extends SessionElement {
  protected override readonly draws = ['scene', 'capabilities', 'shown', 'viewport'] as const;

  static override styles = [
    shared,
    css`
      .views {
        display: grid;
        grid-template-columns: repeat(3, 1fr);
        gap: 6px;
      }
      .row {
        display: flex;
        align-items: center;
        justify-content: center;
        gap: 6px;
      }
      dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: 4px 12px;
      }
      dd {
        text-align: right;
        font-variant-numeric: tabular-nums;
        overflow-wrap: anywhere;
      }
      .software {
        color: var(--warning);
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void => this.session.commands.change(patch);

  override render() {
    const { scene } = this.state;
    return html`
      <cutaway-section heading="Look from" open>
        <div class="views">
          ${STANDARD_VIEWS.map(
            (view) =>
              html`<button class="text-button" @click=${() => this.session.commands.look(view)}>
                ${view.name}
              </button>`,
          )}
        </div>
        <button class="text-button row" @click=${() => this.session.commands.resetView()}>
          <wa-icon name="reset"></wa-icon>Reset the view
        </button>
      </cutaway-section>
      ${scene?.camera ? this.camera() : nothing}
      <cutaway-section heading="Status" open>${this.status()}</cutaway-section>
    `;
  }

  private camera() {
    const scene = this.state.scene ?? {};
    const projection = projectionControl(scene);
    return html`<cutaway-section heading="Projection" open>
      <cutaway-control
        .control=${projection}
        .group=${'View'}
        .change=${this.change}
      ></cutaway-control>
      ${
        scene.camera?.projection === 'orthographic'
          ? nothing
          : html`<cutaway-control
              .control=${fieldOfViewControl(scene)}
              .group=${'View'}
              .change=${this.change}
            ></cutaway-control>`
      }
    </cutaway-section>`;
  }

  private status() {
    const { capabilities, shown, frames_per_second } = this.state;
    const milliseconds = (microseconds: number): string => `${(microseconds / 1000).toFixed(1)} ms`;
    const rows: [string, string][] = [];
    if (capabilities)
      rows.push(['Server', capabilities.server], ['Renderer', capabilities.renderer]);
    if (shown) {
      rows.push(
        [
          'Picture',
          `${shown.width_px}×${shown.height_px} of ${shown.viewport_width_px}×${shown.viewport_height_px}`,
        ],
        ['Quality', shown.still ? 'still' : 'in motion'],
        ['Size', `${(shown.bytes / 1024).toFixed(0)} KiB`],
        ['Render, encode', `${milliseconds(shown.render_us)}, ${milliseconds(shown.encode_us)}`],
        ['Input to picture', `${shown.latency_ms.toFixed(0)} ms`],
        ['Pictures in the last second', String(frames_per_second)],
      );
    }
    return html`
      ${
        capabilities?.software_renderer
          ? html`<p class="software small">
              The server has no graphics processor: pictures are made in software, and slowly.
            </p>`
          : nothing
      }
      <dl class="small">
        ${rows.map(
          ([term, value]) =>
            html`<dt class="quiet">${term}</dt>
              <dd>${value}</dd>`,
        )}
      </dl>
    `;
  }
}
