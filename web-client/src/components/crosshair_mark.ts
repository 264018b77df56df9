// Where the slices meet, in the 3-D picture.
import { css, html, nothing, svg } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shownProjection } from '../state/scene_parts.ts';
import { viewChoice } from '../state/slice_views.ts';
import { showsSlices } from '../state/views.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { SessionElement } from './session_element.ts';

const ARM_CSS_PX = 9;
const GAP_CSS_PX = 3;

@customElement('cutaway-crosshair-mark')
export class CrosshairMark extends SessionElement {
  protected override readonly draws = [
    'shown',
    'shown_scene',
    'scene',
    'preferences',
    'maximised',
  ] as const;

  static override styles = [
    overlay_styles,
    css`
      path {
        fill: none;
        stroke: #fff;
        stroke-width: 1.75;
        vector-effect: non-scaling-stroke;
      }
      .halo {
        stroke: rgb(0 0 0 / 65%);
        stroke-width: 4;
      }
    `,
  ];

  override render() {
    const view = shownProjection(this.state, '3d');
    const crosshair_mm = this.state.scene?.slices?.crosshair_mm;
    const point_px = crosshair_mm && view?.toPicture(crosshair_mm);
    if (!view || !point_px || !showsSlices(viewChoice(this.state))) return nothing;
    const { width_px, height_px } = view.viewport;
    const pixel = width_px / Math.max(1, this.clientWidth);
    const [[x, y], arm, gap] = [point_px, ARM_CSS_PX * pixel, GAP_CSS_PX * pixel];
    const path =
      `M${x - arm} ${y}H${x - gap}M${x + gap} ${y}H${x + arm}` +
      `M${x} ${y - arm}V${y - gap}M${x} ${y + gap}V${y + arm}`;
    return html`<svg
      viewBox="0 0 ${width_px} ${height_px}"
      aria-hidden="true"
      data-part="crosshair-mark"
    >
      ${svg`<path class="halo" d=${path} /><path d=${path} />`}
    </svg>`;
  }
}
