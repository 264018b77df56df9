// The traces of the other two planes in a slice, each in its plane's colour, with grips at their ends
// that tilt them. The keys , and . do the same, so that the grips are for the pointer alone.
import { css, html, nothing, svg } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import { shownSlice } from '../state/slice_views.ts';
import type { Point } from '../view/camera.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { plane_colours } from '../styles/planes.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

/** The planes that a slice's horizontal and vertical line are of. */
const TRACES: Readonly<Record<SliceName, readonly [SliceName, SliceName]>> = {
  axial: ['coronal', 'sagittal'],
  coronal: ['axial', 'sagittal'],
  sagittal: ['axial', 'coronal'],
};

/** Free around the point itself, CSS pixels. */
const GAP_CSS_PX = 12;
/** From the edges of the picture, as shares of it. */
const GRIP_INSET = 0.16;
/** Nearer to the point a grip would turn too fast. */
const NEAREST_GRIP_CSS_PX = 48;

interface Held {
  readonly pointer: number;
  angle_radians: number;
}

@customElement('cutaway-slice-crosshair')
export class SliceCrosshair extends SessionElement {
  protected override readonly draws = ['slice_views', 'scene', 'volume', 'measure'] as const;

  @property({ attribute: false }) slice!: SliceName;
  /** CSS pixels from the upper left corner of the picture, however it is turned just now. */
  @property({ attribute: false }) placeOf!: (event: PointerEvent) => Point;

  private held: Held | undefined;

  static override styles = [
    shared,
    overlay_styles,
    plane_colours,
    css`
      :host {
        overflow: hidden;
      }
      line {
        stroke: var(--plane);
        stroke-width: 1.25;
        stroke-opacity: 0.9;
        filter: drop-shadow(0 0 1px rgb(0 0 0 / 80%));
      }
      button {
        position: absolute;
        width: 32px;
        height: 32px;
        margin: -16px 0 0 -16px;
        padding: 0;
        border: 0;
        background: transparent;
        cursor: grab;
        pointer-events: auto;
        touch-action: none;
      }
      button::after {
        content: '';
        position: absolute;
        inset: 10px;
        border: 1.5px solid rgb(0 0 0 / 70%);
        border-radius: 50%;
        background: var(--plane);
        opacity: 0.85;
      }
      button:hover::after,
      button:active::after {
        inset: 7px;
        opacity: 1;
      }
      @media (pointer: coarse) {
        button {
          width: 44px;
          height: 44px;
          margin: -22px 0 0 -22px;
        }
        button::after {
          inset: 15px;
        }
      }
      @container (max-width: 340px) or (max-height: 200px) {
        button {
          display: none;
        }
      }
    `,
  ];

  /** CSS pixels; nothing while there is no picture. */
  private point(): Point | undefined {
    const view = shownSlice(this.state, this.slice);
    const crosshair_mm = this.state.scene?.slices?.crosshair_mm;
    if (!view || !crosshair_mm) return undefined;
    const css_pixel = this.clientWidth / view.viewport.width_px;
    const [x, y] = view.toPicture(crosshair_mm);
    return [x * css_pixel, y * css_pixel];
  }

  override render() {
    const point = this.point();
    if (!point) return nothing;
    const [x, y] = point;
    const [width, height] = [this.clientWidth, this.clientHeight];
    const [horizontal, vertical] = TRACES[this.slice];
    const line = (plane: SliceName, from: Point, to: Point) =>
      svg`<line class=${plane} x1=${from[0]} y1=${from[1]} x2=${to[0]} y2=${to[1]} />`;
    return html`<svg aria-hidden="true" data-part="crosshair" data-x=${x} data-y=${y}>
        ${line(horizontal, [0, y], [x - GAP_CSS_PX, y])}
        ${line(horizontal, [x + GAP_CSS_PX, y], [width, y])}
        ${line(vertical, [x, 0], [x, y - GAP_CSS_PX])}
        ${line(vertical, [x, y + GAP_CSS_PX], [x, height])}
      </svg>
      ${[GRIP_INSET, 1 - GRIP_INSET].map((share) => [
        this.grip(horizontal, [width * share, y], point),
        this.grip(vertical, [x, height * share], point),
      ])}`;
  }

  private grip(plane: SliceName, [x, y]: Point, point: Point) {
    if (Math.hypot(x - point[0], y - point[1]) < NEAREST_GRIP_CSS_PX) return nothing;
    return html`<button
      class=${plane}
      tabindex="-1"
      aria-hidden="true"
      title=${words().slices.tilt_handle(words().slices.names[plane])}
      data-part="tilt-grip"
      data-plane=${plane}
      style=${styleMap({ left: `${x}px`, top: `${y}px` })}
      @pointerdown=${this.grab}
      @pointermove=${this.turn}
      @pointerup=${this.release}
      @pointercancel=${this.release}
    ></button>`;
  }

  /** Of the pointer about the point, counter-clockwise. */
  private angleOf(event: PointerEvent): number {
    const [x, y] = this.placeOf(event);
    const [centre_x, centre_y] = this.point() ?? [0, 0];
    return Math.atan2(centre_y - y, x - centre_x);
  }

  private grab(event: PointerEvent): void {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    event.stopPropagation();
    this.held = { pointer: event.pointerId, angle_radians: this.angleOf(event) };
    this.session.slicing.holdTilt(this.slice);
  }

  private turn(event: PointerEvent): void {
    if (this.held?.pointer !== event.pointerId) return;
    const angle_radians = this.angleOf(event);
    const by = angle_radians - this.held.angle_radians;
    this.held.angle_radians = angle_radians;
    this.session.slicing.tilt(this.slice, Math.atan2(Math.sin(by), Math.cos(by)));
  }

  private release(): void {
    this.held = undefined;
    this.session.slicing.holdTilt(undefined);
  }
}
