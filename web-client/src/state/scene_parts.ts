// Parts of a scene in the form that the view's mathematics takes.
import { SCENE_FIELDS, type Scene } from '../protocol/messages.ts';
import type { Camera } from '../view/camera.ts';
import { cameraProjection, type ViewProjection } from '../view/view_projection.ts';
import { shownSlice } from './slice_views.ts';
import type { ViewerState } from './viewer_state.ts';
import type { ViewName } from './views.ts';

export const DEFAULT_FIELD_OF_VIEW_DEGREES = SCENE_FIELDS['camera.vertical_fov_degrees'].default;

/** Nothing while the scene leaves the camera open. */
export function cameraOf(scene: Scene | undefined): Camera | undefined {
  const { eye_mm, target_mm, up, projection, view_height_mm, vertical_fov_degrees } =
    scene?.camera ?? {};
  if (!eye_mm || !target_mm || !up) return undefined;
  if (projection === 'orthographic' && view_height_mm !== undefined) {
    return { projection, view_height_mm, eye_mm, target_mm, up };
  }
  const fov_degrees = vertical_fov_degrees ?? DEFAULT_FIELD_OF_VIEW_DEGREES;
  return { projection: 'perspective', vertical_fov_degrees: fov_degrees, eye_mm, target_mm, up };
}

/** The camera that the user has set. */
export const viewCamera = (state: ViewerState): Camera | undefined => cameraOf(state.scene);

/** The camera that the picture on the screen shows. */
export const shownCamera = (state: ViewerState): Camera | undefined =>
  cameraOf(state.shown_scene ?? state.scene);

/** How a picture on the screen shows the patient; nothing while there is none. */
export function shownProjection(state: ViewerState, view: ViewName): ViewProjection | undefined {
  if (view !== '3d') return shownSlice(state, view);
  const { shown } = state;
  const camera = shownCamera(state);
  if (!shown || !camera) return undefined;
  const viewport = { width_px: shown.viewport_width_px, height_px: shown.viewport_height_px };
  return cameraProjection(camera, viewport);
}
