// What a user can do with the slices. Distances in a picture are device pixels of that slice.
import type { JsonObject } from '../state/merge_patch.ts';
import { wantedSlice } from '../state/slice_views.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import {
  draggedWindow,
  hasPresets,
  windowPreset,
  type ValueWindow,
  type WindowPresetName,
} from '../state/value_window.ts';
import type { Convention } from '../preferences/preferences.ts';
import type { Point } from '../view/camera.ts';
import {
  SLICE_NAMES,
  type SliceName,
  type SliceProjection,
  type Slices,
} from '../view/slice_geometry.ts';
import { gaugeOf, lensBody } from '../view/lens_body.ts';
import {
  panned,
  scrolledBy,
  scrolledTo,
  tilted,
  zoomed,
  type SlicePart,
} from '../view/slice_motion.ts';
import { add, scale, type Vector3 } from '../view/vector.ts';
import { words } from '../words/words.ts';
import type { Commands } from './commands.ts';
import type { Picker } from './picker.ts';
import { SliceReadout } from './slice_readout.ts';
import type { Toasts } from './toasts.ts';

export class Slicing {
  /** What the pointer is over. */
  readonly readout: SliceReadout;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly commands: Commands,
    private readonly picker: Picker,
    private readonly toasts: Toasts,
  ) {
    this.readout = new SliceReadout(store, picker);
  }

  /** Patient space, mm. A lens that is to follow goes along. */
  placeCrosshair(crosshair_mm: Vector3 | undefined): void {
    if (!crosshair_mm) return;
    const { lens_at_crosshair, scene } = this.state;
    const follows = lens_at_crosshair && scene?.lens?.mode !== 'none';
    const place: JsonObject = { slices: { crosshair_mm } };
    this.commands.change(follows ? { ...place, lens: { centre_mm: crosshair_mm } } : place);
  }

  /** Where the pointer is in a slice. */
  pointCrosshair(name: SliceName, position_px: Point): void {
    this.placeCrosshair(wantedSlice(this.state, name)?.toPatient(position_px));
  }

  /** On the surface under a point of the 3-D picture; where there is none it stays. */
  pickCrosshair(position_px: Point): void {
    this.picker.pick('3d', position_px, (pick) => this.placeCrosshair(pick?.position_mm));
  }

  /** In the slice's plane, by a distance in its picture. */
  nudgeCrosshair(name: SliceName, dx_px: number, dy_px: number): void {
    const { crosshair_mm } = this.slices;
    const view = wantedSlice(this.state, name);
    if (crosshair_mm && view) this.placeCrosshair(movedInPlane(view, crosshair_mm, dx_px, dy_px));
  }

  /** Along the normal; positive is superior, anterior, left. */
  scroll(name: SliceName, steps: number): void {
    const { volume } = this.state;
    if (volume) this.placeCrosshair(scrolledBy(this.slices, name, steps, volume));
  }

  /** `offset_mm` from the patient's origin along the normal. */
  scrollTo(name: SliceName, offset_mm: number): void {
    const { volume } = this.state;
    if (volume) this.placeCrosshair(scrolledTo(this.slices, name, offset_mm, volume));
  }

  pan(name: SliceName, dx_px: number, dy_px: number): void {
    this.move(name, (view) => panned(view, dx_px, dy_px));
  }

  zoom(name: SliceName, magnification: number, about_px?: Point): void {
    const diagonal_mm = this.state.volume?.diagonal_mm;
    this.move(name, (view) => zoomed(view, magnification, about_px ?? middleOf(view), diagonal_mm));
  }

  /** The whole volume again. */
  resetView(name: SliceName): void {
    this.change({ [name]: null });
  }

  setWindow(window: ValueWindow): void {
    this.change({ window: { ...window } });
  }

  usePreset(name: WindowPresetName): void {
    const { volume } = this.state;
    if (hasPresets(volume)) this.setWindow(windowPreset(name));
    else if (volume) this.toasts.note(words().slices.presets_need_hu);
  }

  /** By a drag: to the right wider, down darker. CSS pixels. */
  dragWindow(dx: number, dy: number): void {
    const { window } = this.slices;
    const { volume } = this.state;
    if (volume && window?.centre !== undefined && window.width !== undefined)
      this.setWindow(draggedWindow({ centre: window.centre, width: window.width }, dx, dy, volume));
  }

  toggleWindowDrag(drags_window = !this.state.drags_window): void {
    this.store.update({ drags_window });
  }

  /** The other two planes about this one's normal; counter-clockwise in its picture. */
  tilt(name: SliceName, angle_radians: number): void {
    const view = wantedSlice(this.state, name);
    if (!view) return;
    this.change({ ...this.heights(), ...tilted(this.slices, view.plane, angle_radians) });
  }

  /** The pointer holds the end of a crosshair line: the slice's picture is to stay as it is. */
  holdTilt(name: SliceName | undefined): void {
    const plane = name && wantedSlice(this.state, name)?.plane;
    this.store.update({ tilting: plane && { slice: name, right: plane.right } });
  }

  resetTilt(): void {
    this.change({ superior: null, anterior: null });
  }

  setConvention(convention: Convention): void {
    this.change({ convention });
    this.commands.prefer({ convention });
  }

  /** A lens that is off comes on, or nothing would be seen to follow. */
  toggleLensAtCrosshair(lens_at_crosshair = !this.state.lens_at_crosshair): void {
    this.store.update({ lens_at_crosshair });
    if (!lens_at_crosshair) return;
    if (this.state.scene?.lens?.mode === 'none') this.commands.toggleLens();
    this.placeCrosshair(this.slices.crosshair_mm);
  }

  /** In parallel to the slice's plane, until its centre is at that point of the picture. */
  moveLensTo(name: SliceName, [x, y]: Point): void {
    const view = wantedSlice(this.state, name);
    const centre_mm = this.state.scene?.lens?.centre_mm;
    if (!view || !centre_mm) return;
    const [from_x, from_y] = view.toPicture(centre_mm);
    const moved_mm = movedInPlane(view, centre_mm, x - from_x, y - from_y);
    this.commands.set(['lens', 'centre_mm'], moved_mm);
  }

  /** As large as makes its outline in the slice reach that point of the picture. */
  setLensCut(name: SliceName, position_px: Point): void {
    const { scene, capabilities } = this.state;
    const view = wantedSlice(this.state, name);
    const body = lensBody(scene?.lens, capabilities?.modules.lens_shape);
    const radius_mm = scene?.lens?.radius_mm;
    if (view && body && radius_mm)
      this.commands.setLensRadius(radius_mm * gaugeOf(body, view.toPatient(position_px)));
  }

  /** As the slices are shown: the whole volume is larger or smaller from another side. */
  private heights(): JsonObject {
    const heights = SLICE_NAMES.flatMap((name) => {
      const view = wantedSlice(this.state, name);
      if (!view || view.plane.view_height_mm !== undefined) return [];
      return [[name, { view_height_mm: view.mm_per_pixel * view.viewport.height_px }] as const];
    });
    return Object.fromEntries(heights);
  }

  private get state(): ViewerState {
    return this.store.state;
  }

  private get slices(): Slices {
    return this.state.scene?.slices ?? {};
  }

  private change(slices: JsonObject): void {
    this.commands.change({ slices });
  }

  private move(name: SliceName, motion: (view: SliceProjection) => SlicePart): void {
    const view = wantedSlice(this.state, name);
    if (view) this.change({ [name]: { ...motion(view) } });
  }
}

const middleOf = ({ viewport }: SliceProjection): Point => [
  viewport.width_px / 2,
  viewport.height_px / 2,
];

function movedInPlane(
  { plane, mm_per_pixel }: SliceProjection,
  point_mm: Vector3,
  dx_px: number,
  dy_px: number,
): Vector3 {
  const across_mm = scale(plane.right, dx_px * mm_per_pixel);
  return add(point_mm, add(across_mm, scale(plane.up, -dy_px * mm_per_pixel)));
}
