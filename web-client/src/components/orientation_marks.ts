// The patient directions at the picture's edges.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { shownCamera } from '../state/scene_parts.ts';
import { edgeLetters } from '../view/orientation.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-orientation-marks')
export class OrientationMarks extends SessionElement {
  protected override readonly draws = ['shown_scene', 'scene'] as const;

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
    .right {
      right: 10px;
      top: 50%;
      transform: translateY(-50%);
    }
  `;

  override render() {
    const camera = shownCamera(this.state);
    if (!camera) return nothing;
    const letters = edgeLetters(camera);
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
