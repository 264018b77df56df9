// The patient directions at the picture's edges.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shownCamera } from '../state/scene_parts.ts';
import { shownSlice } from '../state/slice_views.ts';
import { cameraAxes, type CameraAxes } from '../view/camera.ts';
import { edgeLetters } from '../view/orientation.ts';
import { ViewElement } from './view_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-orientation-marks')
export class OrientationMarks extends ViewElement {
  protected override readonly draws = ['shown_scene', 'scene', 'slice_views', 'volume'] as const;

  static override styles = css`
    :host {
      position: absolute;
      inset: 0;
      pointer-events: none;
    }
    span {
      position: absolute;
      min-width: 22px;
      padding: 1px 5px;
      border-radius: 5px;
      background: var(--on-picture-surface);
      color: var(--on-picture-text);
      font-size: 12px;
      font-weight: 600;
      letter-spacing: 0.04em;
      text-align: center;
    }
    .top {
      top: 10px;
      left: 50%;
      transform: translateX(-50%);
    }
    @container (max-width: 340px) {
      .top {
        top: var(--top-letter-inset, 10px);
      }
    }
    .bottom {
      bottom: 10px;
      left: 50%;
      transform: translateX(-50%);
    }
    .left {
      left: 10px;
      top: 50%;
      transform: translateY(-50%);
    }
    /* Beside the tools, where they reach down to it. */
    @container (max-height: 334px) {
      .left {
        left: var(--left-letter-inset, 10px);
      }
    }
    .right {
      right: var(--right-letter-inset, 10px);
      top: 50%;
      transform: translateY(-50%);
    }
    @container (max-width: 340px) {
      .right {
        right: min(36px, var(--right-letter-inset, 10px));
      }
    }
    @container (max-width: 170px) {
      span {
        min-width: 0;
        padding: 0 4px;
        font-size: 11px;
      }
      .right {
        right: 10px;
      }
    }
  `;

  private axes(): Pick<CameraAxes, 'right' | 'up'> | undefined {
    if (this.view !== '3d') return shownSlice(this.state, this.view)?.plane;
    const camera = shownCamera(this.state);
    return camera && cameraAxes(camera);
  }

  override render() {
    const axes = this.axes();
    if (!axes) return nothing;
    const letters = edgeLetters(axes);
    const edges = ['top', 'right', 'bottom', 'left'] as const;
    return edges.map(
      (edge) =>
        html`<span
          class=${edge}
          aria-label="${words().page.edges[edge]}: ${letters[edge]}"
          role="img"
          >${letters[edge]}</span
        >`,
    );
  }
}
