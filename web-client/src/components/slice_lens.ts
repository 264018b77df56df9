// The lens where a slice cuts it: its outline and a grip move it in the slice's plane, another grip
// resizes it.
import { css, html, nothing, svg } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import { heldPoint, type HeldPoint } from '../interaction/held_point.ts';
import { ARROWS } from '../interaction/key_binding.ts';
import { picturePoint } from '../interaction/picture_point.ts';
import { toolInHand } from '../state/measure_state.ts';
import { shownSlice, viewportOf } from '../state/slice_views.ts';
import type { Point } from '../view/camera.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import type { SliceName, SliceProjection } from '../view/slice_geometry.ts';
import { lensBody } from '../view/lens_body.ts';
import { cornersOf, farthest, lensCutPx } from '../view/lens_outline.ts';
import { lens_styles } from '../styles/lens.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

const STEP_CSS_PX = 8;
const SIZE_STEP = 1.08;
/** Directions in the picture: the outline's farthest point of the first that lies within it. */
const MOVE_GRIP_AT: Directions = [
  [0, -1],
  [0, 1],
  [-1, 0],
];
const SIZE_GRIP_AT: Directions = [
  [1, 0],
  [1, 1],
  [-1, 1],
];

type Directions = readonly [Point, ...Point[]];

interface CutLens {
  /** Of the lens itself, along the slice's normal. */
  readonly centre_px: Point;
  readonly outline_px: readonly Point[];
}

@customElement('cutaway-slice-lens')
export class SliceLens extends SessionElement {
  protected override readonly draws = [
    'slice_views',
    'scene',
    'volume',
    'measure',
    'capabilities',
  ] as const;

  @property({ attribute: false }) slice!: SliceName;

  static override styles = [
    shared,
    overlay_styles,
    lens_styles,
    css`
      :host {
        overflow: hidden;
      }
      polygon {
        fill: none;
        stroke: #fff;
        stroke-opacity: 0.7;
        stroke-width: 1.5;
        stroke-dasharray: 5 5;
        vector-effect: non-scaling-stroke;
      }
      .halo {
        stroke: #000;
        stroke-opacity: 0.4;
        stroke-width: 3.5;
        stroke-dasharray: none;
      }
      .handle {
        stroke-opacity: 0;
        stroke-width: 16;
        stroke-dasharray: none;
        cursor: grab;
        touch-action: none;
        pointer-events: stroke;
      }
      .grip {
        width: 22px;
        height: 22px;
      }
      wa-icon {
        font-size: 13px;
      }
      @container (max-width: 260px) or (max-height: 200px) {
        button {
          display: none;
        }
      }
    `,
  ];

  override render() {
    const view = shownSlice(this.state, this.slice);
    const cut = view && this.cutBy(view);
    if (!view || !cut) return nothing;
    const { width_px, height_px } = view.viewport;
    const outline = (kind: string) =>
      svg`<polygon class=${kind} points=${cornersOf(cut.outline_px)} />`;
    const free = toolInHand(this.state.measure) === undefined;
    return html`<svg viewBox="0 0 ${width_px} ${height_px}" aria-hidden="true" data-part="lens-cut">
        ${outline('halo')} ${outline('')} ${free ? this.handle(cut) : nothing}
      </svg>
      ${free ? [this.moveGrip(cut, view), this.sizeGrip(cut, view)] : nothing}`;
  }

  private cutBy(view: SliceProjection): CutLens | undefined {
    const { scene, capabilities } = this.state;
    const body = lensBody(scene?.lens, capabilities?.modules.lens_shape);
    const outline_px = body && lensCutPx(view, body);
    return outline_px && { centre_px: view.toPicture(body.centre_mm), outline_px };
  }

  private readonly pointOf = (event: PointerEvent): Point =>
    picturePoint(event, this, viewportOf(this.state, this.slice));

  private moving({ centre_px }: CutLens): HeldPoint {
    const moved = (to_px: Point): void => this.session.slicing.moveLensTo(this.slice, to_px);
    return { pointOf: this.pointOf, start_px: centre_px, moved };
  }

  /** Thicker than the outline, so that a hand finds it. */
  private handle(cut: CutLens) {
    return svg`<polygon class="handle" points=${cornersOf(cut.outline_px)}
      ${heldPoint(this.moving(cut))} />`;
  }

  private moveGrip(cut: CutLens, view: SliceProjection) {
    return html`<button
      class="move"
      style=${styleMap(this.place(gripAt(cut, MOVE_GRIP_AT, view), view))}
      aria-label=${words().slices.move_lens}
      aria-description=${words().slices.lens_keys}
      data-part="slice-lens-grip"
      @keydown=${(event: KeyboardEvent) => this.onKey(event, cut)}
      ${heldPoint(this.moving(cut))}
    >
      <span class="grip"><wa-icon name="move"></wa-icon></span>
    </button>`;
  }

  private sizeGrip(cut: CutLens, view: SliceProjection) {
    const at_px = gripAt(cut, SIZE_GRIP_AT, view);
    const held: HeldPoint = {
      pointOf: this.pointOf,
      start_px: at_px,
      moved: (to_px) => this.session.slicing.setLensCut(this.slice, to_px),
    };
    return html`<button
      class="size"
      tabindex="-1"
      aria-hidden="true"
      title=${words().page.lens_size}
      data-part="slice-lens-size-grip"
      style=${styleMap(this.place(at_px, view))}
      ${heldPoint(held)}
    >
      <span class="grip"></span>
    </button>`;
  }

  private place(at_px: Point, { viewport }: SliceProjection) {
    const size = { width: this.clientWidth, height: this.clientHeight };
    const [left, top] = pictureToElement(at_px, viewport, size);
    return { left: `${left}px`, top: `${top}px` };
  }

  private onKey(event: KeyboardEvent, { centre_px: [x, y] }: CutLens): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const direction = ARROWS[event.key];
    const { commands, slicing } = this.session;
    const step_px = STEP_CSS_PX * devicePixelRatio;
    if (direction)
      slicing.moveLensTo(this.slice, [x + direction[0] * step_px, y + direction[1] * step_px]);
    else if (event.key === '+' || event.key === '=') commands.scaleLens(SIZE_STEP);
    else if (event.key === '-') commands.scaleLens(1 / SIZE_STEP);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

function gripAt(
  { outline_px }: CutLens,
  directions: Directions,
  { viewport: { width_px, height_px } }: SliceProjection,
): Point {
  const places = directions.map((direction) => farthest(outline_px, direction));
  const visible = places.find(([x, y]) => x > 0 && y > 0 && x < width_px && y < height_px);
  return visible ?? farthest(outline_px, directions[0]);
}
