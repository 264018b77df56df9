// What is written on an exported picture: how it shows the patient, and what it is not for.
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import { cameraOf } from '../state/scene_parts.ts';
import { planeOffsetText, windowText } from '../state/slice_text.ts';
import type { ViewName } from '../state/views.ts';
import { cameraAxes, type CameraAxes, type Viewport } from '../view/camera.ts';
import { edgeLetters, type EdgeLetters } from '../view/orientation.ts';
import {
  slicePlane,
  sliceProjection,
  type SliceName,
  type Slices,
} from '../view/slice_geometry.ts';
import { isTilted } from '../view/slice_motion.ts';
import { cameraProjection, type ViewProjection } from '../view/view_projection.ts';
import { words } from '../words/words.ts';

/** What all frames of a film have in common; the scene is each frame's own. */
export interface LabelSubject {
  readonly volume: VolumeSummary;
  readonly view: ViewName;
  /** Of the exported picture, not of the view on the screen. */
  readonly size: Viewport;
  readonly notice: string;
}

export interface PictureScale {
  readonly mm_per_pixel: number;
  /** Whether it holds at one depth only, since what is farther away is smaller. */
  readonly foreshortens: boolean;
}

export interface PictureLabels {
  /** What the picture is not for. */
  readonly notice: string;
  readonly title?: string;
  /** Lines, the most important first. */
  readonly facts?: readonly string[];
  readonly letters?: EdgeLetters;
  readonly scale?: PictureScale;
}

type PictureAxes = Pick<CameraAxes, 'right' | 'up'>;

function shown(projection: ViewProjection, axes: PictureAxes) {
  const { foreshortens, scale_at_mm } = projection;
  const scale = { mm_per_pixel: projection.pixelSizeMm(scale_at_mm), foreshortens };
  return { letters: edgeLetters(axes), scale };
}

/** Without letters and scale while the scene leaves the camera open. */
function volumeLabels(scene: Scene, { size }: LabelSubject): Partial<PictureLabels> {
  const camera = cameraOf(scene);
  return camera ? shown(cameraProjection(camera, size), cameraAxes(camera)) : {};
}

function windowFact({ window }: Slices, { units }: VolumeSummary): readonly string[] {
  const { centre, width } = window ?? {};
  if (centre === undefined || width === undefined) return [];
  return [windowText({ centre, width }, units)];
}

function conventionFact(slices: Slices): string {
  const { conventions, tilted } = words().slices;
  const convention = conventions[slices.convention ?? 'radiological'];
  return isTilted(slices) ? `${convention} · ${tilted}` : convention;
}

/** The slice alone while the scene leaves its plane open. */
function sliceLabels(
  { slices }: Scene,
  name: SliceName,
  { volume, size }: LabelSubject,
): Partial<PictureLabels> {
  const plane = slicePlane(slices, name);
  const title = words().slices.names[name];
  if (!slices || !plane) return { facts: [title] };
  const where = `${title} · ${planeOffsetText(plane)}`;
  return {
    ...shown(sliceProjection(plane, volume, size), plane),
    facts: [where, conventionFact(slices), ...windowFact(slices, volume)],
  };
}

/** Of a picture that shows `scene`, in words of the page's language. */
export function pictureLabels(subject: LabelSubject, scene: Scene): PictureLabels {
  const { view, volume, notice } = subject;
  const of_view = view === '3d' ? volumeLabels(scene, subject) : sliceLabels(scene, view, subject);
  return { notice, title: volume.title, ...of_view };
}
