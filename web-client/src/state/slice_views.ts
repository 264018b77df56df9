// The slices' pictures on the screen, and how they show the patient.
import type { Scene } from '../protocol/messages.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import type { Viewport } from '../view/camera.ts';
import {
  slicePlane,
  sliceProjection,
  type SliceName,
  type SlicePlane,
  type SliceProjection,
} from '../view/slice_geometry.ts';
import type { JsonObject } from './merge_patch.ts';
import { sameScene } from './scene_diff.ts';
import type { ViewerState } from './viewer_state.ts';
import { VIEW_NAMES, type ViewChoice, type ViewName } from './views.ts';

/** What a slice's picture depends on: it gets a new frame when this becomes another. */
export interface SlicePicture {
  readonly volume: string | undefined;
  readonly plane: SlicePlane | undefined;
  readonly window: NonNullable<Scene['slices']>['window'];
}

export interface SliceView {
  /** Its size in device pixels; nothing while the slice is not shown. */
  readonly viewport: Viewport | undefined;
  readonly shown: ShownFrame | undefined;
  /** What that frame shows; behind the scene by its latency. */
  readonly picture: SlicePicture | undefined;
}

export type SliceViews = Readonly<Record<SliceName, SliceView>>;

export const CLOSED_VIEW: SliceView = {
  viewport: undefined,
  shown: undefined,
  picture: undefined,
};

export const NO_SLICES: SliceViews = {
  axial: CLOSED_VIEW,
  coronal: CLOSED_VIEW,
  sagittal: CLOSED_VIEW,
};

export const slicePicture = (scene: Scene, name: SliceName): SlicePicture => ({
  volume: scene.volume,
  plane: slicePlane(scene.slices, name),
  window: scene.slices?.window,
});

export const samePicture = (a: SlicePicture, b: SlicePicture): boolean =>
  sameScene(a as unknown as JsonObject, b as unknown as JsonObject);

/** Whether the picture on the screen is refined and shows what the scene says. */
export function isSettled({ scene, slice_views }: ViewerState, name: SliceName): boolean {
  const { shown, picture } = slice_views[name];
  if (!scene || !shown?.still || !picture) return false;
  return samePicture(picture, slicePicture(scene, name));
}

/** How the picture on the screen shows the patient; nothing while there is none. */
export function shownSlice(state: ViewerState, name: SliceName): SliceProjection | undefined {
  const { shown, picture } = state.slice_views[name];
  const { volume } = state;
  if (!shown || !picture?.plane || !volume) return undefined;
  const viewport = { width_px: shown.viewport_width_px, height_px: shown.viewport_height_px };
  return sliceProjection(picture.plane, volume, viewport);
}

/** How the slice will be shown as the scene is now: what a gesture goes on from. */
export function wantedSlice(state: ViewerState, name: SliceName): SliceProjection | undefined {
  const plane = slicePlane(state.scene?.slices, name);
  const { viewport } = state.slice_views[name];
  return plane && state.volume && viewport && sliceProjection(plane, state.volume, viewport);
}

/** The size of any of the session's pictures. */
export const viewportOf = (state: ViewerState, view: ViewName): Viewport | undefined =>
  view === '3d' ? state.viewport : state.slice_views[view].viewport;

/** Those that the server makes pictures of. */
export const openViews = (state: ViewerState): readonly ViewName[] =>
  VIEW_NAMES.filter((view) => viewportOf(state, view));

/** The frame that any of the session's pictures shows. */
export const shownIn = (state: ViewerState, view: ViewName): ShownFrame | undefined =>
  view === '3d' ? state.shown : state.slice_views[view].shown;

export const viewChoice = ({ preferences, maximised }: ViewerState): ViewChoice => ({
  layout: preferences.layout,
  main_view: preferences.main_view,
  maximised,
});
