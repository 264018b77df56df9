// A slice and what lies over it. Loaded when slices are shown first.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { styleMap } from 'lit/directives/style-map.js';
import { applyKey } from '../interaction/keyboard.ts';
import { placeWithPointer } from '../interaction/placing.ts';
import { PointerGestures } from '../interaction/pointer_gestures.ts';
import { sliceGestures } from '../interaction/slice_gestures.ts';
import { isSameSize, observeViewport } from '../interaction/viewport_size.ts';
import { listenToSliceWheel } from '../interaction/wheel.ts';
import { toolInHand } from '../state/measure_state.ts';
import { isSettled } from '../state/slice_views.ts';
import type { Point, Viewport } from '../view/camera.ts';
import { elementToPicture } from '../view/picture_fit.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { dot } from '../view/vector.ts';
import { canvas_styles } from '../styles/canvas.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';
import './slice_crosshair.ts';
import './slice_labels.ts';
import './slice_lens.ts';
import './slice_scroller.ts';

@customElement('cutaway-slice-view')
export class SliceView extends SessionElement {
  protected override readonly draws = [
    'link',
    'scene',
    'volume',
    'slice_views',
    'capabilities',
    'measure',
    'tilting',
    'drags_window',
  ] as const;

  @property({ attribute: false }) slice!: SliceName;
  @property({ attribute: false }) canvas!: HTMLCanvasElement;
  @query('.stage') private stage!: HTMLElement;

  private observer: ResizeObserver | undefined;
  /** Of the place for the picture, which may be larger than the server's pictures. */
  private place: Viewport | undefined;

  static override styles = [
    shared,
    canvas_styles,
    css`
      :host {
        background: #000;
        --right-letter-inset: 34px;
        --top-letter-inset: 36px;
      }
      @media (pointer: coarse) {
        :host {
          --right-letter-inset: 48px;
        }
      }
      .picture {
        position: absolute;
        inset: 0;
      }
      .stage {
        cursor: crosshair;
      }
      .stage.windows {
        cursor: ns-resize;
      }
    `,
  ];

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    this.dataset['settled'] = String(isSettled(this.state, this.slice));
  }

  override focus(): void {
    this.stage.focus();
  }

  override firstUpdated(): void {
    const { slice, stage } = this;
    const { commands, measuring, slicing } = this.session;
    const measures = (): boolean => toolInHand(this.state.measure) !== undefined;
    const device_pixels = (): number =>
      (this.viewport()?.width_px ?? 1) / Math.max(1, this.stage.clientWidth);
    const pointOf = ({ clientX, clientY }: MouseEvent): Point =>
      this.pointAt({ x: clientX, y: clientY });
    const gestures = sliceGestures(slicing, {
      slice,
      measures,
      device_pixels,
      pointAt: (place) => this.pointAt(place),
      drags_window: () => this.state.drags_window,
    });
    new PointerGestures(stage, gestures);
    placeWithPointer(stage, {
      active: measures,
      hovered: (event) => measuring.point(slice, pointOf(event)),
      left: () => measuring.pointAway(),
      pressed: (event) => measuring.place(slice, pointOf(event)),
    });
    stage.addEventListener('pointermove', (event) => {
      if (measures()) slicing.readout.pointAway();
      else if (event.pointerType !== 'touch') slicing.readout.point(slice, pointOf(event));
    });
    stage.addEventListener('pointerleave', () => slicing.readout.pointAway());
    stage.addEventListener('keydown', (event) =>
      applyKey(event, this.session, { view: slice, device_pixels: device_pixels() }),
    );
    listenToSliceWheel(this, {
      scroll: (steps) => slicing.scroll(slice, steps),
      zoom: (magnification, event) => slicing.zoom(slice, magnification, pointOf(event)),
      scaleLens: (factor) => commands.scaleLens(factor),
    });
    this.observe();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.observe();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer?.disconnect();
    this.place = undefined;
    this.session.layout.close(this.slice);
  }

  /** The server's limits may come after the element has its size. */
  override updated(): void {
    if (this.place) this.resized(this.place);
  }

  private observe(): void {
    this.observer = observeViewport(this.canvas, (size) => this.resized(size));
  }

  private viewport(): Viewport | undefined {
    return this.state.slice_views[this.slice].viewport;
  }

  private resized(place: Viewport): void {
    this.place = place;
    const wanted = this.session.viewport_fit.within(place);
    if (!isSameSize(this.viewport(), wanted)) this.session.layout.resize(this.slice, wanted);
  }

  private pointAt({ x, y }: { readonly x: number; readonly y: number }): Point {
    const box = this.getBoundingClientRect();
    const place: Point = [x - box.left, y - box.top];
    const viewport = this.viewport();
    return viewport ? elementToPicture(place, viewport, box) : place;
  }

  private readonly placeOf = ({ clientX, clientY }: PointerEvent): Point => {
    const { left, top } = this.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };

  /**
   * While a plane is tilted by this slice's crosshair, its picture's axes turn with it. Turned back by
   * as much, the patient stands still, and the lines go with the pointer.
   */
  private turnRadians(): number {
    const { tilting, slice_views } = this.state;
    const plane = slice_views[this.slice].picture?.plane;
    if (tilting?.slice !== this.slice || !plane) return 0;
    return Math.atan2(dot(tilting.right, plane.up), dot(tilting.right, plane.right));
  }

  override render() {
    const { link, slice_views, measure, drags_window } = this.state;
    const { shown } = slice_views[this.slice];
    const { names, picture, keys_in_short } = words().slices;
    const turn = this.turnRadians();
    const tilts = this.state.tilting?.slice === this.slice;
    const classes = {
      offline: link.phase !== 'connected' && shown !== undefined,
      windows: drags_window && !toolInHand(measure),
    };
    return html`
      <div class="picture" style=${styleMap(turn ? { transform: `rotate(${turn}rad)` } : {})}>
        <div
          class="stage ${classMap(classes)}"
          tabindex="0"
          role="application"
          aria-label=${picture(names[this.slice])}
          aria-description=${keys_in_short}
          data-part="slice-stage"
          @dblclick=${() => this.session.layout.enlarge(this.slice)}
        >
          ${this.canvas}
        </div>
        <cutaway-slice-crosshair
          .session=${this.session}
          .slice=${this.slice}
          .placeOf=${this.placeOf}
        ></cutaway-slice-crosshair>
        <cutaway-slice-lens .session=${this.session} .slice=${this.slice}></cutaway-slice-lens>
        <cutaway-measure-overlay
          .session=${this.session}
          .view=${this.slice}
        ></cutaway-measure-overlay>
      </div>
      ${tilts ? nothing : html`<cutaway-orientation-marks .session=${this.session} .view=${this.slice}></cutaway-orientation-marks>`}
      <cutaway-slice-labels .session=${this.session} .slice=${this.slice}></cutaway-slice-labels>
      <cutaway-picture-notices
        .session=${this.session}
        .view=${this.slice}
      ></cutaway-picture-notices>
      <cutaway-scale-bar .session=${this.session} .view=${this.slice}></cutaway-scale-bar>
      <cutaway-slice-scroller
        .session=${this.session}
        .slice=${this.slice}
      ></cutaway-slice-scroller>
      <cutaway-enlarge-button .session=${this.session} .view=${this.slice}></cutaway-enlarge-button>
    `;
  }
}
