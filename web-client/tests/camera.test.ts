import { describe, expect, it } from 'vitest';
import { cameraAxes, pixelSizeMm, projectPx, rayThrough, type Camera } from '../src/view/camera.ts';
import {
  lookFrom,
  orbit,
  orbitByPixels,
  panByPixels,
  roll,
  withProjection,
  zoom,
} from '../src/view/camera_motion.ts';
import { edgeLetters, STANDARD_VIEWS } from '../src/view/orientation.ts';
import { elementToPicture, pictureToElement } from '../src/view/picture_fit.ts';
import { add, cross, dot, length, scale, subtract, type Vector3 } from '../src/view/vector.ts';

const viewport = { width_px: 800, height_px: 600 };
const place = { eye_mm: [0, -600, 0], target_mm: [0, 0, 0], up: [0, 0, 1] } as const;
const front = { projection: 'perspective', vertical_fov_degrees: 30, ...place } as Camera;
const flat: Camera = { projection: 'orthographic', view_height_mm: 300, ...place };
const oblique: Camera = {
  ...front,
  eye_mm: [310, -420, 150],
  target_mm: [12, -8, 30],
  up: [0.2, 0.1, 1],
};
const cameras = { front, flat, oblique };

const expectVector = (actual: readonly number[], expected: readonly number[], digits = 9): void =>
  expected.forEach((part, axis) => expect(actual[axis]).toBeCloseTo(part, digits));

describe('projection', () => {
  it('puts the patient’s left on the right of a picture from the front', () => {
    const left_px = projectPx(front, viewport, [50, 0, 0]);
    expect(left_px?.[0]).toBeGreaterThan(400);
    expect(left_px?.[1]).toBeCloseTo(300);
  });

  it('puts superior up', () => {
    expect(projectPx(front, viewport, [0, 0, 50])?.[1]).toBeLessThan(300);
  });

  it('spans the viewport’s height with the vertical field of view', () => {
    const half_height_mm = 600 * Math.tan((15 * Math.PI) / 180);
    expectVector(projectPx(front, viewport, [0, 0, half_height_mm]) ?? [], [400, 0]);
    expectVector(projectPx(flat, viewport, [0, 0, 150]) ?? [], [400, 0]);
  });

  it('shows nothing of what is behind the eye', () => {
    expect(projectPx(front, viewport, [0, -601, 0])).toBeUndefined();
  });

  it.each(Object.entries(cameras))(
    'is undone by the ray through the pixel: %s',
    (_name, camera) => {
      for (const position_px of [
        [0, 0],
        [400, 300],
        [123.5, 540.25],
        [800, 600],
      ] as const) {
        const { origin_mm, direction } = rayThrough(camera, viewport, position_px);
        expect(length(direction)).toBeCloseTo(1);
        expectVector(
          projectPx(camera, viewport, add(origin_mm, scale(direction, 480))) ?? [],
          position_px,
          6,
        );
      }
    },
  );

  it('tells the size of a pixel', () => {
    const size_mm = pixelSizeMm(oblique, viewport, oblique.target_mm);
    const { right } = cameraAxes(oblique);
    const beside_px = projectPx(
      oblique,
      viewport,
      add(oblique.target_mm, scale(right, size_mm * 10)),
    );
    expectVector(beside_px ?? [], [410, 300], 6);
  });
});

describe('motion', () => {
  it.each(Object.entries(cameras))(
    'orbits at a constant distance with square axes: %s',
    (_name, camera) => {
      const turned = orbit(camera, 0.7, -1.9);
      expect(length(subtract(turned.eye_mm, turned.target_mm))).toBeCloseTo(
        length(subtract(camera.eye_mm, camera.target_mm)),
      );
      const { right, up, backward } = cameraAxes(turned);
      expect(dot(right, up)).toBeCloseTo(0);
      expectVector(cross(right, up), backward);
      expectVector(turned.up, up);
    },
  );

  it('carries the surface nearest to the viewer along with the pointer', () => {
    const nearest_mm: Vector3 = [0, -90, 0];
    const [x, y] = projectPx(orbitByPixels(front, viewport, 30, 20), viewport, nearest_mm) ?? [
      0, 0,
    ];
    expect(x).toBeGreaterThan(400);
    expect(y).toBeGreaterThan(300);
  });

  it('passes over the pole and comes around', () => {
    let camera: Camera = front;
    for (let step = 0; step < 8; step++) camera = orbit(camera, 0, Math.PI / 4);
    expectVector(camera.eye_mm, front.eye_mm, 6);
    expectVector(camera.up, front.up, 6);
  });

  it.each(Object.entries(cameras))(
    'pans so that the target’s depth follows the pointer: %s',
    (_name, camera) => {
      const before = camera.target_mm;
      const moved_px = projectPx(panByPixels(camera, viewport, 37, -21), viewport, before);
      expectVector(moved_px ?? [], [437, 279], 6);
    },
  );

  it('zooms by the magnification at the target', () => {
    for (const camera of [front, flat]) {
      const size_mm = pixelSizeMm(camera, viewport, camera.target_mm);
      expect(pixelSizeMm(zoom(camera, 2), viewport, camera.target_mm)).toBeCloseTo(size_mm / 2);
    }
  });

  it('never reaches the target', () => {
    let camera: Camera = front;
    for (let step = 0; step < 200; step++) camera = zoom(camera, 1.5);
    expect(length(subtract(camera.eye_mm, camera.target_mm))).toBeCloseTo(1);
  });

  it('comes nearer to what is only micrometres across', () => {
    let camera: Camera = { ...front, eye_mm: [0, -0.08, 0], target_mm: [0, 0, 0] };
    const distance_mm = () => length(subtract(camera.eye_mm, camera.target_mm));
    camera = zoom(camera, 1.5, 0.02);
    expect(distance_mm()).toBeCloseTo(0.08 / 1.5, 6);
    for (let step = 0; step < 200; step++) camera = zoom(camera, 1.5, 0.02);
    expect(distance_mm()).toBeCloseTo(0.0001, 6);
  });

  it('rolls clockwise', () => {
    expectVector(roll(front, Math.PI / 2).up, [-1, 0, 0]);
    const [x] = projectPx(roll(front, Math.PI / 2), viewport, [0, 0, 50]) ?? [0];
    expect(x).toBeGreaterThan(400);
  });

  it('keeps the size of things when the projection changes', () => {
    const size_mm = pixelSizeMm(oblique, viewport, oblique.target_mm);
    const orthographic = withProjection(oblique, 'orthographic', 30);
    expect(pixelSizeMm(orthographic, viewport, oblique.target_mm)).toBeCloseTo(size_mm);
    expectVector(withProjection(orthographic, 'perspective', 30).eye_mm, oblique.eye_mm, 6);
  });
});

describe('orientation', () => {
  it('has R on the left and L on the right from the front', () => {
    expect(edgeLetters(cameraAxes(front))).toEqual({
      top: 'S',
      right: 'L',
      bottom: 'I',
      left: 'R',
    });
  });

  it.each([
    ['P', { top: 'S', right: 'R', bottom: 'I', left: 'L' }],
    ['R', { top: 'S', right: 'A', bottom: 'I', left: 'P' }],
    ['L', { top: 'S', right: 'P', bottom: 'I', left: 'A' }],
    ['S', { top: 'A', right: 'R', bottom: 'P', left: 'L' }],
    ['I', { top: 'A', right: 'L', bottom: 'P', left: 'R' }],
  ])('from %s', (letter, letters) => {
    const view = STANDARD_VIEWS.find((candidate) => candidate.letter === letter);
    expect(view && edgeLetters(cameraAxes(lookFrom(front, view.towards_eye, view.up)))).toEqual(
      letters,
    );
  });

  it('names both directions between two axes, the stronger first', () => {
    expect(edgeLetters(cameraAxes(orbit(front, Math.PI / 6, 0))).right).toBe('LA');
  });
});

describe('the picture in its element', () => {
  it('is centred, and there and back is the same place', () => {
    const wide = { width: 1000, height: 300 };
    expect(pictureToElement([0, 0], viewport, wide)).toEqual([300, 0]);
    expect(pictureToElement([800, 600], viewport, wide)).toEqual([700, 300]);
    expectVector(
      elementToPicture(pictureToElement([12, 345], viewport, wide), viewport, wide),
      [12, 345],
    );
  });
});
