// What a user can do with the measuring tools. Points are found by the server.
import { extended, isWhole, withPoint } from '../state/measurement_list.ts';
import type { MeasurementKind } from '../state/measurement.ts';
import { toolInHand, type Found, type MeasureState } from '../state/measure_state.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { Point } from '../view/camera.ts';
import { PickFollower, type Pick, type Picker } from './picker.ts';
import { words } from '../words/words.ts';
import type { Measured } from './measured.ts';
import type { Toasts } from './toasts.ts';

export class Measuring {
  private readonly hover: PickFollower;
  private readonly drag: PickFollower;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly picker: Picker,
    private readonly toasts: Toasts,
    private readonly measured: Measured,
  ) {
    this.hover = new PickFollower(picker);
    this.drag = new PickFollower(picker);
    store.subscribe((state, before) => this.changed(state, before));
  }

  /** The tool that is in hand already is put away; the last measurement stays chosen then. */
  take(kind: MeasurementKind): void {
    const draft = toolInHand(this.measure) === kind ? undefined : { kind, points: [] };
    this.hover.stop();
    this.update({ draft, candidate: undefined, ...(draft && { selected: undefined }) });
    if (draft) this.store.update({ lens_follows: false });
  }

  /**
   * First the points of a measurement that is not whole, then the tool, then the choice of one.
   * Whether there was anything.
   */
  cancel(): boolean {
    const { draft, selected } = this.measure;
    if (draft && draft.points.length > 0) this.update({ draft: { ...draft, points: [] } });
    else if (draft) this.take(draft.kind);
    else this.update({ selected: undefined });
    return draft !== undefined || selected !== undefined;
  }

  /** Whether there was a tool in hand. */
  takeBackPoint(): boolean {
    const { draft } = this.measure;
    if (draft) this.update({ draft: { ...draft, points: draft.points.slice(0, -1) } });
    return draft !== undefined;
  }

  /** The pointer, or the cross that arrow keys move, is there. */
  point(position_px: Point, by_keys = false): void {
    if (!this.measure.draft) return;
    const { candidate } = this.measure;
    this.update({
      candidate: { position_px, found: candidate?.found, answered: false, by_keys },
    });
    this.hover.follow(position_px, (pick) => this.answered(position_px, pick));
  }

  /** Moves the candidate by a distance in the picture; the first time it is in the middle. */
  nudge(dx_px: number, dy_px: number): void {
    const { viewport } = this.store.state;
    if (!viewport) return;
    const { width_px, height_px } = viewport;
    const from_px = this.measure.candidate?.position_px;
    if (!from_px) return this.point([width_px / 2, height_px / 2], true);
    const within = (place: number, size: number): number => Math.min(size, Math.max(0, place));
    this.point([within(from_px[0] + dx_px, width_px), within(from_px[1] + dy_px, height_px)], true);
  }

  /** The pointer is no longer over the picture. */
  pointAway(): void {
    this.hover.stop();
    this.update({ candidate: undefined });
  }

  /** Without a position where the candidate is. Whether there is a tool in hand. */
  place(position_px = this.measure.candidate?.position_px): boolean {
    const { draft } = this.measure;
    if (!draft) return false;
    if (position_px) this.placeAt(position_px, draft.kind);
    else this.nudge(0, 0);
    return true;
  }

  private placeAt(position_px: Point, kind: MeasurementKind): void {
    this.picker.pick(position_px, (pick) => {
      if (toolInHand(this.measure) !== kind) return;
      if (pick) this.placed(pick);
      else if (this.store.state.link.phase === 'connected')
        this.toasts.note(words().measure.nothing_there);
    });
  }

  select(id: number | undefined): void {
    this.update({ selected: id });
  }

  /** Over the surface; where there is none, the point stays where it is. */
  movePoint(id: number, index: number, position_px: Point): void {
    this.drag.follow(position_px, (pick) => {
      if (pick) this.measured.change((list) => withPoint(list, id, index, pick));
    });
  }

  get has_tool(): boolean {
    return this.measure.draft !== undefined;
  }

  private get measure(): MeasureState {
    return this.store.state.measure;
  }

  private changed(state: ViewerState, before: ViewerState): void {
    const { draft, candidate } = state.measure;
    if (state.volume?.id !== before.volume?.id) {
      this.hover.stop();
      this.drag.stop();
      this.update({
        draft: draft && { ...draft, points: [] },
        candidate: undefined,
        selected: undefined,
      });
    } else if (candidate && state.shown?.still && state.shown !== before.shown) {
      // What lies there may be something else now.
      this.point(candidate.position_px, candidate.by_keys);
    }
  }

  private answered(position_px: Point, pick: Pick | undefined): void {
    const { candidate } = this.measure;
    if (!candidate) return;
    const found: Found | undefined = pick;
    const answered = candidate.position_px === position_px;
    this.update({ candidate: { ...candidate, found, answered } });
  }

  private placed({ position_mm, value }: Pick): void {
    const { draft } = this.measure;
    if (!draft) return;
    const more = extended(draft, { position_mm, value });
    if (!isWhole(more)) return this.update({ draft: more });
    const selected = this.measured.add(more);
    this.update({ draft: { ...more, points: [] }, selected });
  }

  private update(change: Partial<MeasureState>): void {
    this.store.update({ measure: { ...this.measure, ...change } });
  }
}
