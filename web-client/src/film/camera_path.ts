// A film of what a user did: camera, lens and everything else of the scene over time.
import type { Scene } from '../protocol/messages.ts';
import { cameraOf } from '../state/scene_parts.ts';
import type { Camera } from '../view/camera.ts';
import { add, length, mix, normalize, scale, subtract } from '../view/vector.ts';
import { frameCount, type Film } from './film.ts';
import { wholeScene } from './whole_scene.ts';

type Lens = NonNullable<Scene['lens']>;

export interface PathSample {
  /** Since the recording began, ms. */
  readonly at_ms: number;
  /** From then on. */
  readonly scene: Scene;
}

export interface CameraPath {
  readonly duration_ms: number;
  /** In time's order; the first is at 0. */
  readonly samples: readonly PathSample[];
}

/** Samples farther apart are two motions with a rest between them. */
const REST_MS = 150;
/** Of a sum of two unit vectors, half; below, they point away from each other. */
const OPPOSITE = 0.2;

const mixNumbers = (a: number, b: number, share: number): number => a + (b - a) * share;

/** Between two cameras, on the arc between their eyes; the later one where there is no such arc. */
export function mixCameras(a: Camera, b: Camera, share: number): Camera {
  const [arm_a, arm_b] = [a, b].map(({ eye_mm, target_mm }) => subtract(eye_mm, target_mm));
  if (!arm_a || !arm_b) return b;
  const towards_eye = mix(normalize(arm_a), normalize(arm_b), share);
  const up = mix(normalize(a.up), normalize(b.up), share);
  if (length(towards_eye) < OPPOSITE || length(up) < OPPOSITE) return b;
  const distance_mm = mixNumbers(length(arm_a), length(arm_b), share);
  const target_mm = mix(a.target_mm, b.target_mm, share);
  const eye_mm = add(target_mm, scale(normalize(towards_eye), distance_mm));
  const place = { eye_mm, target_mm, up: normalize(up) };
  if (a.projection === 'orthographic' && b.projection === 'orthographic') {
    const view_height_mm = mixNumbers(a.view_height_mm, b.view_height_mm, share);
    return { ...b, ...place, view_height_mm };
  }
  return { ...(share < 1 ? a : b), ...place };
}

/** Where only one of them says a place or a radius, the first one's stay. */
function mixLenses(a: Lens, b: Lens, share: number): Lens {
  const lens = { ...a };
  if (a.centre_mm && b.centre_mm) {
    const [x, y, z] = mix(a.centre_mm, b.centre_mm, share);
    lens.centre_mm = [x, y, z];
  }
  if (a.radius_mm !== undefined && b.radius_mm !== undefined)
    lens.radius_mm = mixNumbers(a.radius_mm, b.radius_mm, share);
  return lens;
}

function mixScenes(before: Scene, after: Scene, share: number): Scene {
  const mixed = { ...before };
  if (before.lens && after.lens) mixed.lens = mixLenses(before.lens, after.lens, share);
  const [from, to] = [cameraOf(before), cameraOf(after)];
  if (from && to) mixed.camera = cameraFields(mixCameras(from, to, share));
  return mixed;
}

const cameraFields = ({
  eye_mm,
  target_mm,
  up,
  ...lens
}: Camera): NonNullable<Scene['camera']> => ({
  ...lens,
  eye_mm: [...eye_mm],
  target_mm: [...target_mm],
  up: [...up],
});

/** Camera and lens glide between two samples of one motion; all else steps. */
export function sceneAt({ samples }: CameraPath, at_ms: number): Scene | undefined {
  const index = samples.findLastIndex((sample) => sample.at_ms <= at_ms);
  const [before, after] = [samples[index], samples[index + 1]];
  const apart_ms = before && after ? after.at_ms - before.at_ms : Infinity;
  if (!before || !after || apart_ms > REST_MS) return before?.scene;
  return mixScenes(before.scene, after.scene, (at_ms - before.at_ms) / apart_ms);
}

export function pathFilm(path: CameraPath, frames_per_second: number): Film {
  return {
    frames: frameCount(path.duration_ms / 1000, frames_per_second),
    frames_per_second,
    sceneOf: (index) => wholeScene(sceneAt(path, (index * 1000) / frames_per_second) ?? {}),
  };
}
