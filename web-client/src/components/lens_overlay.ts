// The lens' outline over the picture, with a grip that moves it over the surface and one that
// resizes it.
import { css, html, nothing, svg } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import { picturePoint } from '../interaction/picture_point.ts';
import { toolInHand } from '../state/measure_state.ts';
import { cameraOf } from '../state/scene_parts.ts';
import { pixelSizeMm, projectPx, type Camera, type Point, type Viewport } from '../view/camera.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import { sphereOutlinePx } from '../view/sphere_outline.ts';
import type { Vector3 } from '../view/vector.ts';
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
  readonly centre_mm: Vector3;
  readonly centre_px: Point;
  readonly outline_px: readonly Point[];
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
  ] as const;

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
    const { shown, shown_scene, scene } = this.state;
    const camera = cameraOf(shown_scene);
    const { centre_mm, radius_mm, mode } = shown_scene?.lens ?? {};
    if (
      !shown ||
      !camera ||
      !centre_mm ||
      !radius_mm ||
      mode === 'none' ||
      scene?.lens?.mode === 'none'
    )
      return undefined;
    const viewport = { width_px: shown.viewport_width_px, height_px: shown.viewport_height_px };
    const centre_px = projectPx(camera, viewport, centre_mm);
    const outline_px = sphereOutlinePx(camera, viewport, centre_mm, radius_mm);
    return centre_px && outline_px && { camera, viewport, centre_mm, centre_px, outline_px };
  }

  override render() {
    const lens = this.lensInPicture();
    if (!lens) return nothing;
    const { width_px, height_px } = lens.viewport;
    const points = lens.outline_px
      .map((point) => point.map((part) => part.toFixed(1)).join(','))
      .join(' ');
    const right_px = lens.outline_px.reduce((most, point) => (point[0] > most[0] ? point : most));
    return html`
      <svg viewBox="0 0 ${width_px} ${height_px}" aria-hidden="true">
        ${svg`<polygon class="halo" points=${points} /><polygon points=${points} />`}
      </svg>
      ${this.state.lens_follows || toolInHand(this.state.measure) ? nothing : [this.moveGrip(lens), this.sizeGrip(lens, right_px)]}
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

  private sizeGrip(lens: LensInPicture, position_px: Point) {
    const resize = (event: PointerEvent): void => {
      if (!this.holds(event)) return;
      const [x, y] = this.devicePoint(event);
      const reach_px = Math.hypot(x - lens.centre_px[0], y - lens.centre_px[1]);
      this.session.commands.setLensRadius(
        reach_px * pixelSizeMm(lens.camera, lens.viewport, lens.centre_mm),
      );
    };
    return html`<button
      class="size"
      tabindex="-1"
      aria-hidden="true"
      title=${words().page.lens_size}
      data-part="lens-size-grip"
      style=${styleMap(this.place(position_px, lens.viewport))}
      @pointerdown=${this.grab}
      @pointermove=${resize}
    >
      <span class="grip"></span>
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
