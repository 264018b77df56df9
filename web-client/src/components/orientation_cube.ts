// A small cube that turns with the volume; a click on a face looks at the patient from there.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import { shownCamera } from '../state/scene_parts.ts';
import { cameraAxes, type CameraAxes } from '../view/camera.ts';
import { STANDARD_VIEWS, type StandardView } from '../view/orientation.ts';
import { cross, dot, scale, type Vector3 } from '../view/vector.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

const HALF_SIDE_CSS_PX = 19;

/** The face's place as CSS has it: x right, y down, z to the viewer. */
function faceTransform(axes: CameraAxes, face: StandardView): string {
  const onScreen = (v: Vector3): Vector3 => [
    dot(axes.right, v),
    -dot(axes.up, v),
    dot(axes.backward, v),
  ];
  const column = (v: Vector3): string =>
    onScreen(v)
      .map((part) => part.toFixed(5))
      .join(',');
  const right = cross(face.up, face.towards_eye);
  const place = onScreen(scale(face.towards_eye, HALF_SIDE_CSS_PX))
    .map((part) => part.toFixed(3))
    .join(',');
  return `matrix3d(${column(right)},0,${column(scale(face.up, -1))},0,${column(face.towards_eye)},0,${place},1)`;
}

@customElement('cutaway-orientation-cube')
export class OrientationCube extends SessionElement {
  protected override readonly draws = ['shown_scene', 'scene'] as const;

  static override styles = css`
    :host {
      position: absolute;
      top: 14px;
      right: var(--cube-inset, 14px);
      width: 72px;
      height: 72px;
      perspective: 260px;
      pointer-events: none;
    }
    @container (max-width: 260px) {
      :host {
        display: none;
      }
    }
    .cube {
      position: absolute;
      left: 50%;
      top: 50%;
      transform-style: preserve-3d;
    }
    button {
      position: absolute;
      left: -19px;
      top: -19px;
      width: 38px;
      height: 38px;
      padding: 0;
      border: 1px solid rgb(233 238 241 / 34%);
      background: rgb(26 33 38 / 88%);
      color: var(--on-picture-text);
      font: 600 14px var(--font);
      backface-visibility: hidden;
      cursor: pointer;
      pointer-events: auto;
    }
    button:hover {
      background: var(--on-picture-accent);
      color: var(--on-picture-on-accent);
    }
  `;

  override render() {
    const camera = shownCamera(this.state);
    if (!camera) return nothing;
    const axes = cameraAxes(camera);
    // The View tab has the same six directions for keyboard and screen reader.
    return html`<div class="cube" aria-hidden="true">
      ${STANDARD_VIEWS.map(
        (face) =>
          html`<button
            tabindex="-1"
            title=${words().page.directions[face.letter]}
            style=${styleMap({ transform: faceTransform(axes, face) })}
            @click=${() => this.session.commands.look(face)}
          >
            ${face.letter}
          </button>`,
      )}
    </div>`;
  }
}
