// A film in which the camera goes around what it looks at.
import type { Scene } from '../protocol/messages.ts';
import { cameraAxes, type Camera } from '../view/camera.ts';
import { add, rotateAbout, subtract, type Vector3 } from '../view/vector.ts';
import { frameCount, type Film } from './film.ts';
import { wholeScene } from './whole_scene.ts';

export interface Turntable {
  /** Head to feet in patient space, or upright in the picture. */
  readonly axis: 'superior' | 'view_up';
  readonly degrees: number;
  readonly seconds: number;
  /** Where the front of the volume goes. */
  readonly direction: 'right' | 'left';
}

const SUPERIOR: Vector3 = [0, 0, 1];
const FULL_TURN_DEGREES = 360;

/** Turns eye and up about an axis of unit length through the target. */
function turned(camera: Camera, axis: Vector3, radians: number): Camera {
  const turn = (vector: Vector3): Vector3 => rotateAbout(vector, axis, radians);
  const arm_mm = turn(subtract(camera.eye_mm, camera.target_mm));
  return { ...camera, eye_mm: add(camera.target_mm, arm_mm), up: turn(camera.up) };
}

/** A whole turn ends one step before it began, so that the film goes on without a halt when repeated. */
function degreesAt(index: number, frames: number, degrees: number): number {
  const closes = degrees % FULL_TURN_DEGREES === 0;
  const steps = closes ? frames : Math.max(1, frames - 1);
  return (degrees * index) / steps;
}

/** `camera` is the scene's. */
export function turntableFilm(
  scene: Scene,
  camera: Camera,
  { axis, degrees, seconds, direction }: Turntable,
  frames_per_second: number,
): Film {
  const frames = frameCount(seconds, frames_per_second);
  const about = axis === 'superior' ? SUPERIOR : cameraAxes(camera).up;
  const sign = direction === 'right' ? -1 : 1;
  const scene_patch = wholeScene(scene);
  return {
    frames,
    frames_per_second,
    sceneOf: (index) => {
      const radians = (sign * degreesAt(index, frames, degrees) * Math.PI) / 180;
      return { ...scene_patch, camera: { ...turned(camera, about, radians) } };
    },
  };
}
