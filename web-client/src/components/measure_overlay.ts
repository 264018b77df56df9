// What was measured and is being measured, drawn over the picture; it turns with the patient.
import { html, nothing, svg } from 'lit';
import { customElement } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { styleMap } from 'lit/directives/style-map.js';
import { heldPoint } from '../interaction/held_point.ts';
import { ARROWS } from '../interaction/key_binding.ts';
import { picturePoint } from '../interaction/picture_point.ts';
import { measurementsOf } from '../state/measure_state.ts';
import { resultOf, type MeasuredPoint, type Measurement } from '../view/measurement.ts';
import { resultText } from '../state/measure_text.ts';
import { shownProjection } from '../state/scene_parts.ts';
import { shownSlice, viewportOf } from '../state/slice_views.ts';
import type { Point } from '../view/camera.ts';
import { drawMeasurement, type MeasurementDrawing } from '../view/measurement_drawing.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import { voxelStepMm } from '../view/slice_geometry.ts';
import type { ViewProjection } from '../view/view_projection.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { measure_overlay_styles } from './measure_overlay_styles.ts';
import { ViewElement } from './view_element.ts';

const STEP_CSS_PX = 8;

/** One that is whole, or the draft with the point that would be placed now. */
interface Drawn extends Pick<Measurement, 'kind' | 'points'> {
  readonly id?: number;
  readonly name: string;
}

@customElement('cutaway-measure-overlay')
export class MeasureOverlay extends ViewElement {
  protected override readonly draws = [
    'shown',
    'shown_scene',
    'scene',
    'viewport',
    'slice_views',
    'volume',
    'measure',
  ] as const;

  static override styles = [shared, overlay_styles, measure_overlay_styles];

  override render() {
    const view = shownProjection(this.state, this.view);
    const { measure, volume } = this.state;
    if (!view || !volume) return nothing;
    const all = [...measurementsOf(measure, volume), ...this.draft()].map((one) => ({
      one,
      drawing: drawMeasurement(
        one.kind,
        one.points.map(({ position_mm }) => position_mm),
        view,
      ),
      off: this.isOff(one),
    }));
    const near = all.filter(({ off }) => !off);
    const { width_px, height_px } = view.viewport;
    return html`
      <svg viewBox="0 0 ${width_px} ${height_px}" aria-hidden="true">
        ${all.map(({ one, drawing, off }) => this.lines(one, drawing, width_px, off))}
        ${this.cross(width_px)}
      </svg>
      ${near.map(({ one, drawing }) => this.label(one, drawing, view))}
      ${near.map(({ one, drawing }) => this.handles(one, drawing, view))}
    `;
  }

  /** In a slice: whether a point of it lies in none of the voxels that the plane goes through. */
  private isOff({ points }: Drawn): boolean {
    const { volume } = this.state;
    const view = this.view === '3d' ? undefined : shownSlice(this.state, this.view);
    if (!view || !volume) return false;
    const half_step_mm = voxelStepMm(volume, view.plane.normal) / 2;
    return points.some(({ position_mm }) => Math.abs(view.distanceMm(position_mm)) > half_step_mm);
  }

  private draft(): Drawn[] {
    const { draft, candidate } = this.state.measure;
    if (!draft) return [];
    const found: readonly MeasuredPoint[] = candidate?.found ? [candidate.found] : [];
    return [{ kind: draft.kind, name: '', points: [...draft.points, ...found] }];
  }

  private selected({ id }: Drawn): boolean {
    return id !== undefined && id === this.state.measure.selected;
  }

  /** `width_px` of the picture for as many CSS pixels as the element has. */
  private cssPixels(width_px: number): number {
    return width_px / Math.max(1, this.clientWidth);
  }

  private lines(
    one: Drawn,
    { lines, points_px }: MeasurementDrawing,
    width_px: number,
    off: boolean,
  ) {
    const pixel = this.cssPixels(width_px);
    const chosen = this.selected(one);
    const text = (line: readonly Point[]): string =>
      line.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');
    return svg`<g class=${classMap({ measured: true, chosen, draft: one.id === undefined, off })}>
      ${lines.map((line) => svg`<polyline class="halo" points=${text(line)} />`)}
      ${lines.map((line) => svg`<polyline points=${text(line)} />`)}
      ${points_px.map(
        (point) =>
          point && svg`<circle cx=${point[0]} cy=${point[1]} r=${(chosen ? 5 : 3.5) * pixel} />`,
      )}
    </g>`;
  }

  /** Where the keys have moved the point. */
  private cross(width_px: number) {
    const { candidate } = this.state.measure;
    if (!candidate?.by_keys || candidate.view !== this.view) return nothing;
    const [x, y] = candidate.position_px;
    const arm = 11 * this.cssPixels(width_px);
    const path = `M${x - arm} ${y}H${x + arm}M${x} ${y - arm}V${y + arm}`;
    return svg`<path class="halo" d=${path} /><path class="cross" d=${path} />`;
  }

  private place(position_px: Point, view: ViewProjection): { left: string; top: string } {
    const size = { width: this.clientWidth, height: this.clientHeight };
    const [left, top] = pictureToElement(position_px, view.viewport, size);
    return { left: `${left.toFixed(1)}px`, top: `${top.toFixed(1)}px` };
  }

  /** The panel has the same by keyboard. */
  private label(one: Drawn, { label_px, label_side }: MeasurementDrawing, view: ViewProjection) {
    const { volume, measure } = this.state;
    const result = volume && resultOf(one, volume.units);
    const is_probe_draft = one.id === undefined && one.kind === 'probe';
    if (!label_px || !result || is_probe_draft) return nothing;
    const text = resultText(result);
    const place = styleMap(this.place(label_px, view));
    const { id, name } = one;
    if (id === undefined)
      return html`<span class="label ${label_side}" style=${place} aria-hidden="true"
        >${text}</span
      >`;
    // With a tool in hand a press is meant for the surface behind the label.
    const classes = { label: true, pressable: !measure.draft, chosen: this.selected(one) };
    return html`<button
      class=${classMap({ ...classes, [label_side]: true })}
      style=${place}
      tabindex="-1"
      aria-hidden="true"
      title=${words().measure.measured(name, text)}
      data-measurement=${name}
      @click=${() => this.session.measuring.select(this.selected(one) ? undefined : id)}
    >
      ${this.selected(one) ? html`<span class="name">${name}</span>` : nothing}${text}
    </button>`;
  }

  private handles(one: Drawn, { points_px }: MeasurementDrawing, view: ViewProjection) {
    const { id, name } = one;
    const { draft } = this.state.measure;
    const placing = draft !== undefined && draft.points.length > 0;
    if (id === undefined || placing || !this.selected(one)) return nothing;
    return points_px.map((point_px, index) => {
      if (!point_px) return nothing;
      const moveTo = (to_px: Point): void =>
        this.session.measuring.movePoint(id, index, this.view, to_px);
      return html`<button
        class="handle"
        style=${styleMap(this.place(point_px, view))}
        aria-label=${words().measure.point(name, index + 1)}
        aria-description=${words().measure.point_hint}
        data-part="measure-handle"
        @keydown=${(event: KeyboardEvent) => this.onKey(event, point_px, moveTo)}
        ${heldPoint({
          pointOf: (event) => picturePoint(event, this, viewportOf(this.state, this.view)),
          start_px: point_px,
          moved: moveTo,
        })}
      ></button>`;
    });
  }

  private onKey(event: KeyboardEvent, [x, y]: Point, moveTo: (to_px: Point) => void): void {
    const direction = ARROWS[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step_px = (event.shiftKey ? 1 : STEP_CSS_PX) * devicePixelRatio;
    moveTo([x + direction[0] * step_px, y + direction[1] * step_px]);
  }
}
