// What stands in a slice: which it is, where it lies, its window, and what the pointer is over. It is
// said of the picture on the screen, which is behind the scene, and stays when the connection is lost.
import { css, html, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { positionText, valueText } from '../state/measure_text.ts';
import type { SlicePicture } from '../state/slice_views.ts';
import { planeOffsetText, windowText } from '../state/slice_text.ts';
import { shownPlanes, type SliceName, type SlicePlane } from '../view/slice_geometry.ts';
import { isTilted } from '../view/slice_motion.ts';
import { plane_colours } from '../styles/planes.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-slice-labels')
export class SliceLabels extends SessionElement {
  protected override readonly draws = [
    'scene',
    'volume',
    'slice_views',
    'slice_hover',
    'drags_window',
  ] as const;

  @property({ attribute: false }) slice!: SliceName;

  static override styles = [
    shared,
    plane_colours,
    css`
      :host {
        position: absolute;
        inset: 0;
        color: var(--on-picture-text);
        font-size: 12px;
        font-variant-numeric: tabular-nums;
        pointer-events: none;
      }
      .corner {
        position: absolute;
        top: 8px;
        right: 44px;
        display: grid;
        justify-items: end;
        gap: 3px;
        max-width: calc(100% - 52px);
      }
      .chip {
        padding: 2px 7px;
        border: 0;
        border-radius: 5px;
        background: var(--on-picture-surface);
        font: inherit;
        white-space: nowrap;
      }
      .name::before {
        content: '';
        display: inline-block;
        width: 9px;
        height: 9px;
        margin-right: 6px;
        border-radius: 2px;
        background: var(--plane);
      }
      .name b {
        font-weight: 600;
      }
      .window {
        pointer-events: auto;
      }
      .window:hover {
        background: #33414a;
      }
      .window[aria-pressed='true'] {
        background: var(--on-picture-accent);
        color: var(--on-picture-on-accent);
      }
      .hover {
        max-width: 100%;
        overflow: hidden;
        text-overflow: ellipsis;
      }
      /* A finger finds it around itself, too. */
      @media (pointer: coarse) {
        .window {
          position: relative;
        }
        .window::after {
          content: '';
          position: absolute;
          inset: -12px -4px;
        }
      }
      @container (max-width: 340px) {
        :host {
          font-size: 11px;
        }
        .corner {
          right: 39px;
          max-width: calc(100% - 42px);
        }
        .convention {
          display: none;
        }
      }
      @container (max-width: 220px) or (max-height: 200px) {
        .hover,
        .window {
          display: none;
        }
      }
      @container (max-width: 190px) {
        .position {
          display: none;
        }
      }
    `,
  ];

  override render() {
    const { slice_views, volume } = this.state;
    const { picture } = slice_views[this.slice];
    if (!volume) return nothing;
    const plane = picture?.plane;
    return html`<div class="corner">
      <span class="chip name ${this.slice}" data-part="slice-name">
        <b>${words().slices.names[this.slice]}</b> ${plane ? this.position(plane) : nothing}
      </span>
      ${picture ? this.window(picture) : nothing} ${plane ? this.convention(plane) : nothing}
      ${this.hover()}
    </div>`;
  }

  private position(plane: SlicePlane) {
    const text = planeOffsetText(plane);
    return html`<span class="position" data-part="slice-position">${text}</span>`;
  }

  private convention(plane: SlicePlane) {
    const { conventions, tilted } = words().slices;
    const shown = shownPlanes(plane, this.slice);
    const wanted = this.state.scene?.slices?.convention ?? 'radiological';
    const convention = conventions[shown.convention ?? wanted];
    return html`<span class="chip convention" data-part="convention">
      ${isTilted(shown) ? `${convention} · ${tilted}` : convention}
    </span>`;
  }

  /** A button: by touch it is how a drag comes to change the window. */
  private window({ window }: SlicePicture) {
    const { volume, drags_window } = this.state;
    if (window?.centre === undefined || window.width === undefined || !volume) return nothing;
    const text = windowText({ centre: window.centre, width: window.width }, volume.units);
    return html`<button
      class="chip window"
      aria-pressed=${drags_window ? 'true' : 'false'}
      aria-label="${words().slices.names[this.slice]}: ${text}. ${words().slices.window_drag}"
      title=${words().slices.window_drag}
      data-part="slice-window"
      @click=${() => this.session.slicing.toggleWindowDrag()}
    >
      ${text}
    </button>`;
  }

  private hover() {
    const { slice_hover, volume } = this.state;
    if (slice_hover?.slice !== this.slice || !slice_hover.found || !volume) return nothing;
    const { value, position_mm } = slice_hover.found;
    return html`<span class="chip hover" data-part="slice-hover">
      ${valueText(value, volume.units)} · ${positionText(position_mm)}
    </span>`;
  }
}
