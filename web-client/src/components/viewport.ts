// The 3-D picture and what lies over it.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { styleMap } from 'lit/directives/style-map.js';
import { applyKey } from '../interaction/keyboard.ts';
import { followWithLens } from '../interaction/lens_follow.ts';
import { placeWithPointer, SLIP_CSS_PX } from '../interaction/placing.ts';
import { picturePoint } from '../interaction/picture_point.ts';
import { PointerGestures } from '../interaction/pointer_gestures.ts';
import { volumeGestures } from '../interaction/volume_gestures.ts';
import { isSameSize, observeViewport } from '../interaction/viewport_size.ts';
import { listenToWheel } from '../interaction/wheel.ts';
import { toHex } from '../state/colour.ts';
import { toolInHand } from '../state/measure_state.ts';
import { viewChoice } from '../state/slice_views.ts';
import { showsSlices } from '../state/views.ts';
import type { Point, Viewport } from '../view/camera.ts';
import { canvas_styles } from '../styles/canvas.ts';
import { shared } from '../styles/shared.ts';
import './crosshair_mark.ts';
import './enlarge_button.ts';
import { LatePart } from './late_part.ts';
import './lens_overlay.ts';
import './measure_overlay.ts';
import './orientation_cube.ts';
import './orientation_marks.ts';
import './picture_notices.ts';
import './scale_bar.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-viewport')
export class CutawayViewport extends SessionElement {
  protected override readonly draws = [
    'link',
    'shown',
    'shown_scene',
    'capabilities',
    'viewport',
    'lens_follows',
    'measure',
  ] as const;

  @property({ attribute: false }) canvas!: HTMLCanvasElement;
  @query('.stage') private stage!: HTMLElement;

  private readonly hints = new LatePart(this, () => import('./hints.ts'));
  private observer: ResizeObserver | undefined;
  /** Of the place for the picture, which may be larger than the server's pictures. */
  private place: Viewport | undefined;

  static override styles = [
    shared,
    canvas_styles,
    css`
      .stage {
        cursor: grab;
      }
      .stage.follows,
      .stage.measures {
        cursor: crosshair;
      }
      .stage:active {
        cursor: grabbing;
      }
    `,
  ];

  override focus(): void {
    this.stage.focus();
  }

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { commands, toasts } = this.session;
    const give_up = (): void => commands.prefer({ hints_seen: true });
    if (!this.state.preferences.hints_seen) void this.hints.ask(toasts, give_up);
  }

  override firstUpdated(): void {
    const { commands, measuring, slicing } = this.session;
    const measures = (): boolean => toolInHand(this.state.measure) !== undefined;
    const pressable = (): boolean => measures() || showsSlices(viewChoice(this.state));
    const device_pixels = (): number =>
      (this.state.viewport?.width_px ?? 1) / Math.max(1, this.stage.clientWidth);
    const slip_css_px = (): number => (pressable() ? SLIP_CSS_PX : 0);
    new PointerGestures(this.stage, volumeGestures(commands, device_pixels, slip_css_px));
    placeWithPointer(this.stage, {
      active: pressable,
      hovered: (event) => measuring.point('3d', this.picturePoint(event)),
      left: () => measuring.pointAway(),
      pressed: (event) => {
        const point_px = this.picturePoint(event);
        if (!measuring.place('3d', point_px)) slicing.pickCrosshair(point_px);
      },
    });
    listenToWheel(this, commands);
    followWithLens(this, this.stage, {
      follows: () => this.state.lens_follows && this.state.scene?.lens?.mode !== 'none',
      moved: (event) => commands.dragLens(this.picturePoint(event)),
      ended: () => commands.followPointer(false),
    });
    this.stage.addEventListener('keydown', (event) =>
      applyKey(event, this.session, { view: '3d', device_pixels: device_pixels() }),
    );
    this.observer = observeViewport(this.canvas, (size) => this.resized(size));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer?.disconnect();
  }

  /** The server's limits may come after the element has its size, or change with a new server. */
  override updated(): void {
    if (this.place) this.resized(this.place);
  }

  private picturePoint(event: MouseEvent): Point {
    return picturePoint(event, this, this.state.viewport);
  }

  private resized(place: Viewport): void {
    this.place = place;
    const wanted = this.session.viewport_fit.within(place);
    const { viewport } = this.state;
    if (!isSameSize(viewport, wanted)) this.session.commands.resize(wanted);
  }

  /** Where the picture does not fill its place, or is dimmed, what is behind it is its own ground. */
  private ground(): { background?: string } {
    const colour = this.state.shown_scene?.background?.colour;
    return colour ? { background: toHex(colour) } : {};
  }

  override render() {
    const { link, shown, lens_follows, measure } = this.state;
    const offline = link.phase !== 'connected' && shown !== undefined;
    return html`
      <div
        class="stage ${classMap({ offline, follows: lens_follows, measures: toolInHand(measure) !== undefined })}"
        style=${styleMap(this.ground())}
        tabindex="0"
        role="application"
        aria-label=${words().page.picture}
        aria-description=${words().page.keys_in_short}
        data-part="stage"
        @dblclick=${() => this.session.layout.enlarge('3d')}
      >
        ${this.canvas}
      </div>
      <cutaway-crosshair-mark .session=${this.session}></cutaway-crosshair-mark>
      <cutaway-lens-overlay .session=${this.session}></cutaway-lens-overlay>
      <cutaway-measure-overlay .session=${this.session}></cutaway-measure-overlay>
      <cutaway-orientation-marks .session=${this.session}></cutaway-orientation-marks>
      <cutaway-orientation-cube .session=${this.session}></cutaway-orientation-cube>
      ${this.hints.is_there ? html`<cutaway-hints .session=${this.session}></cutaway-hints>` : nothing}
      <cutaway-picture-notices .session=${this.session}></cutaway-picture-notices>
      <cutaway-scale-bar .session=${this.session}></cutaway-scale-bar>
      <cutaway-enlarge-button .session=${this.session}></cutaway-enlarge-button>
    `;
  }
}
