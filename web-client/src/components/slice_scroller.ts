// Where a slice lies between the volume's first and last voxels.
import { css, html, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { offsetText } from '../state/slice_text.ts';
import { extentAlong, sliceNormal, voxelStepMm, type SliceName } from '../view/slice_geometry.ts';
import { dot } from '../view/vector.ts';
import { plane_colours } from '../styles/planes.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-slice-scroller')
export class SliceScroller extends SessionElement {
  protected override readonly draws = ['scene', 'volume'] as const;

  @property({ attribute: false }) slice!: SliceName;

  static override styles = [
    shared,
    plane_colours,
    css`
      :host {
        position: absolute;
        top: 48px;
        right: 6px;
        bottom: 48px;
        width: 24px;
        container-type: size;
      }
      /* Upright by a turn: WebKitGTK draws one of a vertical writing mode, but none can drag it. */
      input {
        position: absolute;
        top: 50%;
        left: 50%;
        width: 100cqh;
        height: 100cqw;
        margin: 0;
        transform: translate(-50%, -50%) rotate(-90deg);
        accent-color: var(--plane);
        opacity: 0.65;
        touch-action: none;
      }
      input:hover,
      input:focus-visible {
        opacity: 1;
      }
      @media (pointer: coarse) {
        :host {
          right: 0;
          width: 44px;
        }
      }
      @media (pointer: coarse) {
        @container (max-width: 340px) {
          :host {
            width: 30px;
          }
        }
      }
      @container (max-height: 150px) or (max-width: 170px) {
        :host {
          display: none;
        }
      }
    `,
  ];

  override render() {
    const { scene, volume } = this.state;
    const crosshair_mm = scene?.slices?.crosshair_mm;
    if (!scene?.slices || !crosshair_mm || !volume) return nothing;
    const normal = sliceNormal(scene.slices, this.slice);
    const { minimum, maximum } = extentAlong(volume, normal);
    const offset_mm = dot(crosshair_mm, normal);
    return html`<input
      type="range"
      class=${this.slice}
      aria-label=${words().slices.scroller(words().slices.names[this.slice])}
      aria-valuetext=${offsetText(normal, offset_mm)}
      aria-orientation="vertical"
      min=${minimum}
      max=${maximum}
      step=${voxelStepMm(volume, normal)}
      .value=${live(String(offset_mm))}
      data-part="slice-scroller"
      @input=${(event: Event) =>
        this.session.slicing.scrollTo(this.slice, (event.target as HTMLInputElement).valueAsNumber)}
    />`;
  }
}
