// What a user can do with the measuring tools. Points are found by the server.
import { extended, isWhole, withPoint } from '../state/measurement_list.ts';
import type { MeasurementKind } from '../view/measurement.ts';
import { measurementsOf, toolInHand, type MeasureState } from '../state/measure_state.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { shownIn, viewportOf } from '../state/slice_views.ts';
import type { ViewName } from '../state/views.ts';
import { isSameVolume } from '../state/volume_identity.ts';
import type { Point } from '../view/camera.ts';
import { PickFollower, type Pick, type Picker } from './picker.ts';
import { words } from '../words/words.ts';
import type { Commands } from './commands.ts';
import type { Measured } from './measured.ts';
import type { Toasts } from './toasts.ts';

const isListed = (wanted: number, { measure, volume }: ViewerState): boolean =>
  measurementsOf(measure, volume).some(({ id }) => id === wanted);

export class Measuring {
  private readonly hover: PickFollower;
  private readonly drag: PickFollower;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly picker: Picker,
    private readonly toasts: Toasts,
    private readonly measured: Measured,
    private readonly commands: Commands,
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

  /** Takes back a point of what is not whole yet, else the last step. */
  undo(): void {
    if (this.measure.draft?.points.length) this.takeBackPoint();
    else this.commands.undo();
  }

  /** The pointer, or the cross that arrow keys move, is there. */
  point(view: ViewName, position_px: Point, by_keys = false): void {
    if (!this.measure.draft) return;
    const { candidate } = this.measure;
    const found = candidate?.view === view ? candidate.found : undefined;
    this.update({ candidate: { view, position_px, found, answered: false, by_keys } });
    this.hover.follow(view, position_px, (pick) => this.answered(position_px, pick));
  }

  /** Moves the candidate by a distance in the picture; the first time it is in the middle. */
  nudge(view: ViewName, dx_px: number, dy_px: number): void {
    const viewport = viewportOf(this.store.state, view);
    if (!viewport) return;
    const { width_px, height_px } = viewport;
    const { candidate } = this.measure;
    if (candidate?.view !== view) return this.point(view, [width_px / 2, height_px / 2], true);
    const [x, y] = candidate.position_px;
    const within = (place: number, size: number): number => Math.min(size, Math.max(0, place));
    this.point(view, [within(x + dx_px, width_px), within(y + dy_px, height_px)], true);
  }

  /** The pointer is no longer over the picture. */
  pointAway(): void {
    this.hover.stop();
    this.update({ candidate: undefined });
  }

  /** Without a position where the candidate is. Whether there is a tool in hand. */
  place(view: ViewName, position_px = this.candidateIn(view)): boolean {
    const { draft } = this.measure;
    if (!draft) return false;
    if (position_px) this.placeAt(view, position_px, draft.kind);
    else this.nudge(view, 0, 0);
    return true;
  }

  private candidateIn(view: ViewName): Point | undefined {
    const { candidate } = this.measure;
    return candidate?.view === view ? candidate.position_px : undefined;
  }

  private placeAt(view: ViewName, position_px: Point, kind: MeasurementKind): void {
    this.picker.pick(view, position_px, (pick) => {
      if (toolInHand(this.measure) !== kind) return;
      if (pick) this.placed(pick);
      else if (this.store.state.link.phase === 'connected')
        this.toasts.note(words().measure.nothing_there[view === '3d' ? 'volume' : 'slice']);
    });
  }

  select(id: number | undefined): void {
    this.update({ selected: id });
  }

  /** Over the surface, or in the slice's plane; where nothing is, the point stays where it is. */
  movePoint(id: number, index: number, view: ViewName, position_px: Point): void {
    this.drag.follow(view, position_px, (pick) => {
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
    const { draft, candidate, selected } = state.measure;
    if (!isSameVolume(state.volume, before.volume)) {
      this.hover.stop();
      this.drag.stop();
      this.update({
        draft: draft && { ...draft, points: [] },
        candidate: undefined,
        selected: undefined,
      });
    } else if (selected !== undefined && !isListed(selected, state)) {
      this.update({ selected: undefined });
    } else if (candidate && this.isAnother(candidate.view, state, before)) {
      // What lies there may be something else now.
      this.point(candidate.view, candidate.position_px, candidate.by_keys);
    }
  }

  private isAnother(view: ViewName, state: ViewerState, before: ViewerState): boolean {
    const shown = shownIn(state, view);
    return shown?.still === true && shown !== shownIn(before, view);
  }

  private answered(position_px: Point, pick: Pick | undefined): void {
    const { candidate } = this.measure;
    if (!candidate) return;
    const answered = candidate.position_px === position_px;
    this.update({ candidate: { ...candidate, found: pick, answered } });
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
