// Patient directions in the picture. LPS: +x is the patient's left, +y posterior, +z superior.
import type { CameraAxes } from './camera.ts';
import type { Vector3 } from './vector.ts';

const AXIS_LETTERS = [
  ['R', 'L'],
  ['A', 'P'],
  ['I', 'S'],
] as const;

const SMALLEST_SHARE = 0.25;

/**
 * The letters of the patient directions that a picture direction points to, the strongest first:
 * 'L', or 'LA' between two. A share below a quarter is left out.
 */
export function directionLetters(direction: Vector3): string {
  return direction
    .map((share, axis) => ({
      share: Math.abs(share),
      letter: AXIS_LETTERS[axis]?.[share < 0 ? 0 : 1] ?? '',
    }))
    .filter(({ share }) => share >= SMALLEST_SHARE)
    .sort((a, b) => b.share - a.share)
    .map(({ letter }) => letter)
    .join('');
}

export interface EdgeLetters {
  readonly top: string;
  readonly right: string;
  readonly bottom: string;
  readonly left: string;
}

/** Of a picture whose right and up those are. */
export function edgeLetters({ right, up }: Pick<CameraAxes, 'right' | 'up'>): EdgeLetters {
  const opposite = (v: Vector3): Vector3 => [-v[0], -v[1], -v[2]];
  return {
    top: directionLetters(up),
    right: directionLetters(right),
    bottom: directionLetters(opposite(up)),
    left: directionLetters(opposite(right)),
  };
}

export interface StandardView {
  readonly letter: 'A' | 'P' | 'R' | 'L' | 'S' | 'I';
  readonly towards_eye: Vector3;
  readonly up: Vector3;
}

export const STANDARD_VIEWS: readonly StandardView[] = [
  { letter: 'A', towards_eye: [0, -1, 0], up: [0, 0, 1] },
  { letter: 'P', towards_eye: [0, 1, 0], up: [0, 0, 1] },
  { letter: 'R', towards_eye: [-1, 0, 0], up: [0, 0, 1] },
  { letter: 'L', towards_eye: [1, 0, 0], up: [0, 0, 1] },
  { letter: 'S', towards_eye: [0, 0, 1], up: [0, -1, 0] },
  { letter: 'I', towards_eye: [0, 0, -1], up: [0, -1, 0] },
];

export interface SidedCoordinate {
  /** Of the patient's direction that the point lies to. */
  readonly letter: string;
  /** Never negative. */
  readonly distance_mm: number;
}

/** A patient position as distances to the right or left, anterior or posterior, and so on. */
export function sidedCoordinates(position_mm: Vector3): readonly SidedCoordinate[] {
  return position_mm.map((coordinate_mm, axis) => ({
    letter: AXIS_LETTERS[axis]?.[coordinate_mm < 0 ? 0 : 1] ?? '',
    distance_mm: Math.abs(coordinate_mm),
  }));
}
