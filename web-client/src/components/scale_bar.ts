// How long a centimetre is in the picture.
import { css, html, nothing } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { shownProjection } from '../state/scene_parts.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import { scaleBar, scaleText } from '../view/scale_bar.ts';
import { words } from '../words/words.ts';
import { ViewElement } from './view_element.ts';

const LONGEST_CSS_PX = 140;
const SHARE_OF_WIDTH = 0.25;

@customElement('cutaway-scale-bar')
export class ScaleBarView extends ViewElement {
  protected override readonly draws = [
    'shown',
    'shown_scene',
    'scene',
    'viewport',
    'slice_views',
  ] as const;

  @state() private size = { width: 0, height: 0 };
  private observer: ResizeObserver | undefined;

  static override styles = css`
    :host {
      position: absolute;
      inset: 0;
      pointer-events: none;
    }
    .scale {
      position: absolute;
      right: 12px;
      bottom: 10px;
      padding: 3px 8px 6px;
      border-radius: 5px;
      background: rgb(10 13 15 / 66%);
      color: #e9eef1;
      font-size: 12px;
      font-variant-numeric: tabular-nums;
      text-align: center;
      pointer-events: auto;
    }
    @container (max-width: 170px) {
      .scale {
        display: none;
      }
    }
    .bar {
      display: flex;
      box-sizing: border-box;
      height: 6px;
      border: solid currentcolor;
      border-width: 0 1.5px 1.5px;
    }
    .bar span {
      flex: 1;
      height: 4px;
      margin-top: auto;
    }
    .bar span + span {
      border-left: 1px solid rgb(233 238 241 / 70%);
    }
  `;

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer = new ResizeObserver(() => {
      this.size = { width: this.clientWidth, height: this.clientHeight };
    });
    this.observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer?.disconnect();
  }

  override render() {
    const view = shownProjection(this.state, this.view);
    if (!view || this.size.width === 0) return nothing;
    const [left] = pictureToElement([0, 0], view.viewport, this.size);
    const [right] = pictureToElement([view.viewport.width_px, 0], view.viewport, this.size);
    const css_px_per_px = (right - left) / view.viewport.width_px;
    const longest_css_px = Math.min(LONGEST_CSS_PX, this.size.width * SHARE_OF_WIDTH);
    const bar = scaleBar(view.pixelSizeMm(view.scale_at_mm) / css_px_per_px, longest_css_px);
    if (!bar) return nothing;
    const text = scaleText(bar.length_mm);
    const where = view.foreshortens ? words().measure.at_target_depth : words().measure.everywhere;
    return html`<div
      class="scale"
      role="img"
      aria-label="${words().measure.scale(text)}. ${where}"
      title=${where}
      data-part="scale"
      data-length-mm=${bar.length_mm}
    >
      ${text}
      <div class="bar" style="width: ${bar.width_css_px.toFixed(2)}px">
        ${Array.from({ length: bar.parts }, () => html`<span></span>`)}
      </div>
    </div>`;
  }
}
