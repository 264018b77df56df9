// From where one looks, and what the connection and the renderer do.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { JsonObject } from '../state/merge_patch.ts';
import { fieldOfViewControl, projectionControl } from '../state/scene_controls.ts';
import { STANDARD_VIEWS } from '../view/orientation.ts';
import { shared } from '../styles/shared.ts';
import './control_field.ts';
import './page_settings.ts';
import './section.ts';
import './slices_section.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

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
    const texts = words().panel.view;
    return html`
      <cutaway-section heading=${texts.look_from} open>
        <div class="views">
          ${STANDARD_VIEWS.map(
            (view) =>
              html`<button class="text-button" @click=${() => this.session.commands.look(view)}>
                ${words().page.directions[view.letter]}
              </button>`,
          )}
        </div>
        <button class="text-button row" @click=${() => this.session.commands.resetView()}>
          <wa-icon name="reset"></wa-icon>${texts.reset}
        </button>
      </cutaway-section>
      <cutaway-slices-section .session=${this.session}></cutaway-slices-section>
      ${scene?.camera ? this.camera() : nothing}
      <cutaway-page-settings .session=${this.session}></cutaway-page-settings>
      <cutaway-section heading=${texts.status} open>${this.status()}</cutaway-section>
    `;
  }

  private camera() {
    const scene = this.state.scene ?? {};
    const projection = projectionControl(scene);
    const texts = words().panel.view;
    return html`<cutaway-section heading=${texts.projection} open>
      <cutaway-control
        .control=${projection}
        .group=${texts.view}
        .change=${this.change}
      ></cutaway-control>
      ${
        scene.camera?.projection === 'orthographic'
          ? nothing
          : html`<cutaway-control
              .control=${fieldOfViewControl(scene)}
              .group=${texts.view}
              .change=${this.change}
            ></cutaway-control>`
      }
    </cutaway-section>`;
  }

  private status() {
    const { capabilities, shown, frames_per_second } = this.state;
    const { number } = words();
    const texts = words().panel.view;
    const milliseconds = (microseconds: number): string => `${number(microseconds / 1000, 1)} ms`;
    const rows: [string, string][] = [];
    if (capabilities)
      rows.push([texts.server, capabilities.server], [texts.renderer, capabilities.renderer]);
    if (shown) {
      rows.push(
        [
          texts.picture,
          texts.picture_size(
            `${shown.width_px}×${shown.height_px}`,
            `${shown.viewport_width_px}×${shown.viewport_height_px}`,
          ),
        ],
        [texts.quality, shown.still ? texts.still : texts.in_motion],
        [texts.size, `${number(shown.bytes / 1024)} KiB`],
        [texts.render_encode, `${milliseconds(shown.render_us)}, ${milliseconds(shown.encode_us)}`],
        [texts.latency, `${number(shown.latency_ms)} ms`],
        [texts.frames_per_second, number(frames_per_second)],
      );
    }
    return html`
      ${
        capabilities?.software_renderer
          ? html`<p class="software small">${texts.software}</p>`
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
