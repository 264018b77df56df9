import { describe, expect, it } from 'vitest';
import type { Camera, Point } from '../src/view/camera.ts';
import { convexHull } from '../src/view/convex_hull.ts';
import { rayThrough } from '../src/view/camera.ts';
import { canTurn, gaugeOf, lensBody, lensDirection } from '../src/view/lens_body.ts';
import { farthest, lensCutPx, lensOutlinePx } from '../src/view/lens_outline.ts';
import { sliceProjection, slicePlane, type Slices } from '../src/view/slice_geometry.ts';
import { cross, length, subtract, type Vector3 } from '../src/view/vector.ts';
import { box, capabilities, sphere, volume } from './capabilities.ts';

const shapes = capabilities.modules.lens_shape;
const viewport = { width_px: 400, height_px: 300 };
const front: Camera = {
  projection: 'perspective',
  eye_mm: [0, -500, 0],
  target_mm: [0, 0, 0],
  up: [0, 0, 1],
  vertical_fov_degrees: 30,
};
const level: Camera = { ...front, projection: 'orthographic', view_height_mm: 300 };

interface Said {
  name: string;
  width?: number;
  height?: number;
  depth?: number;
  azimuth_degrees?: number;
  elevation_degrees?: number;
  roll_degrees?: number;
}

function bodyOf(shape: Said, centre_mm: Vector3 = [0, 0, 0]) {
  const lens = { centre_mm: [...centre_mm] as [number, number, number], radius_mm: 50, shape };
  const body = lensBody(lens as Parameters<typeof lensBody>[0], shapes);
  if (!body) throw new Error('there is no lens');
  return body;
}

const cube = { name: 'box', width: 1, height: 1, depth: 1 };

describe('the outline of a lens', () => {
  it('of a ball is touched by every ray of sight, within its corners', () => {
    const centre_mm: Vector3 = [40, -30, 25];
    for (const camera of [front, level]) {
      const outline_px = lensOutlinePx(camera, viewport, bodyOf({ name: 'sphere' }, centre_mm));
      expect(outline_px?.length).toBeGreaterThan(30);
      for (const point_px of outline_px ?? []) {
        const { origin_mm, direction } = rayThrough(camera, viewport, point_px);
        const beside_mm = length(cross(direction, subtract(centre_mm, origin_mm)));
        expect(Math.abs(beside_mm - 50)).toBeLessThan(0.3);
      }
    }
  });

  it('of a box from the front is its face, and a diamond once it is rolled', () => {
    const side_px = 50; // 50 mm at 300 mm in 300 px
    const face = lensOutlinePx(level, viewport, bodyOf(cube));
    expect(new Set(face?.map(([x, y]) => `${x.toFixed(3)} ${y.toFixed(3)}`))).toEqual(
      new Set(['150.000 100.000', '250.000 100.000', '250.000 200.000', '150.000 200.000']),
    );
    const diamond = lensOutlinePx(level, viewport, bodyOf({ ...cube, roll_degrees: 45 })) ?? [];
    expect(farthest(diamond, [1, 0])[0]).toBeCloseTo(200 + side_px * Math.SQRT2, 3);
    expect(farthest(diamond, [0, -1])[1]).toBeCloseTo(150 - side_px * Math.SQRT2, 3);
  });

  it('has the half sizes that its parameters say: width to the left, height to the head', () => {
    const bar = bodyOf({ name: 'box', width: 2, height: 0.5, depth: 0.1 });
    const corners = lensOutlinePx(level, viewport, bar) ?? [];
    expect(farthest(corners, [1, 0])[0]).toBeCloseTo(300, 3);
    expect(farthest(corners, [0, -1])[1]).toBeCloseTo(125, 3);
    const aside = bodyOf({ name: 'box', width: 2, height: 0.5, depth: 0.1, azimuth_degrees: 90 });
    const turned = lensOutlinePx(level, viewport, aside) ?? [];
    expect(farthest(turned, [1, 0])[0]).toBeCloseTo(205, 3);
  });

  it('is nothing where a part of it is behind the eye', () => {
    expect(lensOutlinePx(front, viewport, bodyOf(cube, [0, -500, 0]))).toBeUndefined();
  });
});

describe('a lens that a slice cuts', () => {
  const plane_mm = { centre_mm: [0, 0, 0] as [number, number, number], view_height_mm: 300 };
  const slices: Slices = { crosshair_mm: [0, 0, 30], axial: plane_mm };
  const plane = slicePlane(slices, 'axial');
  if (!plane) throw new Error('the plane is open');
  const view = sliceProjection(plane, volume, viewport);

  it('is a circle of a ball, as large as its distance leaves it', () => {
    for (const [x, y] of lensCutPx(view, bodyOf({ name: 'sphere' })) ?? [])
      expect(Math.abs(Math.hypot(x - 200, y - 150) - 40)).toBeLessThan(0.3);
    expect(lensCutPx(view, bodyOf({ name: 'sphere' }, [0, 0, -25]))).toBeUndefined();
  });

  it('is a square of a cube', () => {
    const corners = lensCutPx(view, bodyOf(cube)) ?? [];
    expect(farthest(corners, [1, 0])[0]).toBeCloseTo(250, 3);
    expect(farthest(corners, [0, 1])[1]).toBeCloseTo(200, 3);
  });
});

describe('a lens’ body', () => {
  it('says how much larger it had to be to reach a point', () => {
    expect(gaugeOf(bodyOf({ name: 'sphere' }), [30, 0, 40])).toBeCloseTo(1, 2);
    expect(gaugeOf(bodyOf(cube), [30, -100, 40])).toBeCloseTo(2, 9);
    expect(gaugeOf(bodyOf({ ...cube, azimuth_degrees: 45 }), [50, 50, 0])).toBeCloseTo(
      Math.SQRT2,
      9,
    );
  });

  it('is turned where its shape has angles, and points where they say', () => {
    expect([sphere, box].map(canTurn)).toEqual([false, true]);
    const angles = { azimuth_degrees: 70, elevation_degrees: -20 };
    const ahead = bodyOf({ ...cube, ...angles }).half_edges_mm[2];
    expect(lensDirection(ahead).azimuth_degrees).toBeCloseTo(70, 9);
    expect(lensDirection(ahead).elevation_degrees).toBeCloseTo(-20, 9);
  });
});

describe('a convex hull', () => {
  it('keeps the corners and drops what lies within or on a side', () => {
    const points: Point[] = [
      [0, 0],
      [2, 0],
      [1, 0],
      [2, 2],
      [1, 1],
      [0, 2],
    ];
    expect(convexHull(points)).toHaveLength(4);
  });
});
