// The lens' outline over the picture, with a grip that moves it over the surface, one that resizes
// it, and one that turns it where its shape looks another way then.
import { css, html, nothing, svg } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import { picturePoint } from '../interaction/picture_point.ts';
import { toolInHand } from '../state/measure_state.ts';
import { cameraOf } from '../state/scene_parts.ts';
import { cameraAxes, projectPx, type Camera, type Point, type Viewport } from '../view/camera.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import { canTurn, lensBody, lensDirection, type LensBody } from '../view/lens_body.ts';
import { cornersOf, farthest, lensOutlinePx } from '../view/lens_outline.ts';
import { rotateAbout, type Vector3 } from '../view/vector.ts';
import { lens_styles } from '../styles/lens.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { shared } from '../styles/shared.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

const NUDGE_CSS_PX = 12;
const SIZE_STEP = 1.08;

interface LensInPicture {
  readonly camera: Camera;
  readonly viewport: Viewport;
  readonly body: LensBody;
  readonly centre_px: Point;
  readonly outline_px: readonly Point[];
}

/** Where a turn began: the pointer, and which way the lens pointed in the patient. */
interface RolledFrom {
  readonly at_px: Point;
  readonly ahead: Vector3;
}

@customElement('cutaway-lens-overlay')
export class LensOverlay extends SessionElement {
  protected override readonly draws = [
    'shown',
    'shown_scene',
    'scene',
    'viewport',
    'lens_follows',
    'measure',
    'capabilities',
  ] as const;

  private rolled_from: RolledFrom | undefined;

  /** While the lens is dragged: where the pointer is, device pixels. */
  @state() private drag_px: Point | undefined;

  static override styles = [
    shared,
    overlay_styles,
    lens_styles,
    css`
      polygon {
        fill: none;
        stroke: #fff;
        stroke-opacity: 0.6;
        stroke-width: 1.5;
        stroke-dasharray: 5 5;
        vector-effect: non-scaling-stroke;
      }
      .halo {
        stroke: #000;
        stroke-opacity: 0.35;
        stroke-width: 3.5;
        stroke-dasharray: none;
      }
      wa-icon {
        font-size: 16px;
      }
    `,
  ];

  private lensInPicture(): LensInPicture | undefined {
    const { shown, shown_scene, scene, capabilities } = this.state;
    const camera = cameraOf(shown_scene);
    const body = lensBody(shown_scene?.lens, capabilities?.modules.lens_shape);
    if (!shown || !camera || !body || scene?.lens?.mode === 'none') return undefined;
    const viewport = { width_px: shown.viewport_width_px, height_px: shown.viewport_height_px };
    const centre_px = projectPx(camera, viewport, body.centre_mm);
    const outline_px = lensOutlinePx(camera, viewport, body);
    return centre_px && outline_px && { camera, viewport, body, centre_px, outline_px };
  }

  override render() {
    const lens = this.lensInPicture();
    if (!lens) return nothing;
    const { width_px, height_px } = lens.viewport;
    const points = cornersOf(lens.outline_px);
    const free = !this.state.lens_follows && !toolInHand(this.state.measure);
    return html`
      <svg viewBox="0 0 ${width_px} ${height_px}" aria-hidden="true">
        ${svg`<polygon class="halo" points=${points} /><polygon points=${points} />`}
      </svg>
      ${free ? [this.moveGrip(lens), this.sizeGrip(lens), this.turnGrip(lens)] : nothing}
    `;
  }

  private moveGrip(lens: LensInPicture) {
    return html`<button
      class="move ${this.drag_px ? 'dragging' : ''}"
      style=${styleMap(this.place(this.drag_px ?? lens.centre_px, lens.viewport))}
      aria-label=${words().page.lens}
      aria-description=${words().page.lens_keys}
      data-part="lens-grip"
      @pointerdown=${this.grab}
      @pointermove=${(event: PointerEvent) => this.dragTo(event)}
      @pointerup=${this.release}
      @pointercancel=${this.release}
      @keydown=${this.onKey}
    >
      <span class="grip"><wa-icon name="move"></wa-icon></span>
    </button>`;
  }

  private sizeGrip(lens: LensInPicture) {
    const right_px = farthest(lens.outline_px, [1, 0]);
    const reach_at_rim_px = reachPx(lens, right_px);
    const resize = (event: PointerEvent): void => {
      if (!this.holds(event)) return;
      const factor = reachPx(lens, this.devicePoint(event)) / reach_at_rim_px;
      this.session.commands.setLensRadius(factor * (this.state.shown_scene?.lens?.radius_mm ?? 0));
    };
    return html`<button
      class="size"
      tabindex="-1"
      aria-hidden="true"
      title=${words().page.lens_size}
      data-part="lens-size-grip"
      style=${styleMap(this.place(right_px, lens.viewport))}
      @pointerdown=${this.grab}
      @pointermove=${resize}
    >
      <span class="grip"></span>
    </button>`;
  }

  /** Held, it rolls the lens as a ball under the pointer. */
  private turnGrip(lens: LensInPicture) {
    const { capabilities, shown_scene } = this.state;
    const name = shown_scene?.lens?.shape?.name;
    if (!canTurn(capabilities?.modules.lens_shape.find((shape) => shape.name === name)))
      return nothing;
    const turn = (event: PointerEvent): void => {
      if (!this.holds(event) || !this.rolled_from) return;
      const direction = rolled(lens, this.rolled_from, this.devicePoint(event));
      this.session.commands.change({ lens: { shape: { ...lensDirection(direction) } } });
    };
    return html`<button
      class="turn"
      tabindex="-1"
      aria-hidden="true"
      title=${words().page.lens_turn}
      data-part="lens-turn-grip"
      style=${styleMap(this.place(farthest(lens.outline_px, [-1, 1]), lens.viewport))}
      @pointerdown=${(event: PointerEvent) => {
        this.rolled_from = { at_px: this.devicePoint(event), ahead: lens.body.half_edges_mm[2] };
        this.grab(event);
      }}
      @pointermove=${turn}
    >
      <span class="grip"><wa-icon name="reset"></wa-icon></span>
    </button>`;
  }

  private place(position_px: Point, viewport: Viewport): { left: string; top: string } {
    const size = { width: this.clientWidth, height: this.clientHeight };
    const [left, top] = pictureToElement(position_px, viewport, size);
    return { left: `${left}px`, top: `${top}px` };
  }

  private devicePoint(event: PointerEvent): Point {
    return picturePoint(event, this, this.state.viewport);
  }

  private holds(event: PointerEvent): boolean {
    return (event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId);
  }

  private grab(event: PointerEvent): void {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    event.stopPropagation();
  }

  private dragTo(event: PointerEvent): void {
    if (!this.holds(event)) return;
    this.drag_px = this.devicePoint(event);
    this.session.commands.dragLens(this.drag_px);
  }

  private release(): void {
    this.drag_px = undefined;
  }

  private onKey(event: KeyboardEvent): void {
    const { commands } = this.session;
    const step_px = NUDGE_CSS_PX * devicePixelRatio;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => commands.nudgeLens(-step_px, 0),
      ArrowRight: () => commands.nudgeLens(step_px, 0),
      ArrowUp: () => commands.nudgeLens(0, -step_px),
      ArrowDown: () => commands.nudgeLens(0, step_px),
      '+': () => commands.scaleLens(SIZE_STEP),
      '=': () => commands.scaleLens(SIZE_STEP),
      '-': () => commands.scaleLens(1 / SIZE_STEP),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }
}

const reachPx = ({ centre_px: [x, y] }: LensInPicture, [to_x, to_y]: Point): number =>
  Math.hypot(to_x - x, to_y - y);

/** Which way the lens points once the pointer has rolled it so far; patient space. */
function rolled({ camera, outline_px, centre_px }: LensInPicture, from: RolledFrom, to_px: Point) {
  const { right, up } = cameraAxes(camera);
  const radius_px = Math.max(1, ...outline_px.map(([x]) => Math.abs(x - centre_px[0])));
  const angle = (axis: 0 | 1): number => (to_px[axis] - from.at_px[axis]) / radius_px;
  return rotateAbout(rotateAbout(from.ahead, up, angle(0)), right, angle(1));
}
