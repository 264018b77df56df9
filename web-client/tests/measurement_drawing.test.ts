import { describe, expect, it } from 'vitest';
import type { Camera } from '../src/view/camera.ts';
import { drawMeasurement } from '../src/view/measurement_drawing.ts';
import { scaleBar, scaleText } from '../src/view/scale_bar.ts';
import { cameraProjection } from '../src/view/view_projection.ts';

const viewport = { width_px: 400, height_px: 300 };
/** From the front, one pixel a millimetre: left is right in the picture. */
const flat: Camera = {
  projection: 'orthographic',
  view_height_mm: 300,
  eye_mm: [0, -500, 0],
  target_mm: [0, 0, 0],
  up: [0, 0, 1],
};
const near: Camera = { ...flat, projection: 'perspective', vertical_fov_degrees: 60 };

describe('a view of the patient', () => {
  const view = cameraProjection(flat, viewport);

  it('says where a point is and what a pixel spans', () => {
    expect(view.toPicture([20, 7, 50])).toEqual([220, 100]);
    expect(view.pixelSizeMm([0, 0, 0])).toBeCloseTo(1);
    expect(view.foreshortens).toBe(false);
    expect(cameraProjection(near, viewport).foreshortens).toBe(true);
  });

  it('shows of a line what is in front of the eye', () => {
    const perspective = cameraProjection(near, viewport);
    const [from, to] = perspective.lineToPicture([0, -900, 10], [0, 0, 10]) ?? [];
    expect(to?.[0]).toBeCloseTo(200);
    expect(to?.[1]).toBeGreaterThan(140);
    // Cut a millimetre before the eye, where 10 mm are far above the picture.
    expect(from?.[1]).toBeLessThan(-1000);
    const [back, ahead] = perspective.lineToPicture([0, 0, 10], [0, -900, 10]) ?? [];
    expect(ahead?.[1]).toBeCloseTo(from?.[1] ?? 0);
    expect(back).toEqual(to);
    expect(perspective.lineToPicture([0, -900, 0], [0, -600, 0])).toBeUndefined();
  });
});

describe('a measurement in the picture', () => {
  const view = cameraProjection(flat, viewport);

  it('is a line with its label in the middle', () => {
    const drawing = drawMeasurement(
      'distance',
      [
        [-20, 0, 0],
        [20, 90, 40],
      ],
      view,
    );
    expect(drawing.lines).toEqual([
      [
        [180, 150],
        [220, 110],
      ],
    ]);
    expect(drawing).toMatchObject({ label_px: [200, 130], label_side: 'above' });
    const steep = drawMeasurement(
      'distance',
      [
        [0, 0, -50],
        [10, 0, 50],
      ],
      view,
    );
    expect(steep.label_side).toBe('beside');
  });

  it('is two legs and an arc between them, bent about the vertex', () => {
    const { lines, label_px } = drawMeasurement(
      'angle',
      [
        [100, 0, 0],
        [0, 0, 0],
        [0, 0, 40],
      ],
      view,
    );
    expect(lines).toHaveLength(3);
    const arc = lines[2] ?? [];
    for (const [x, y] of arc) expect(Math.hypot(x - 200, y - 150)).toBeCloseTo(14);
    expect(arc[0]?.[0]).toBeCloseTo(214);
    expect(arc.at(-1)?.[1]).toBeCloseTo(136);
    expect(label_px?.[0]).toBeCloseTo(200 + 1.7 * 14 * Math.SQRT1_2);
  });

  it('has no arc where the legs lie on one line, and its label at the vertex', () => {
    const { lines, label_px } = drawMeasurement(
      'angle',
      [
        [-50, 0, 0],
        [0, 0, 0],
        [50, 0, 0],
      ],
      view,
    );
    expect(lines).toHaveLength(2);
    expect(label_px).toEqual([200, 150]);
  });

  it('is as much as there is of it', () => {
    expect(drawMeasurement('distance', [], view)).toEqual({
      lines: [],
      points_px: [],
      label_px: undefined,
      label_side: 'above',
    });
    expect(drawMeasurement('probe', [[0, 0, 0]], view).label_px).toEqual([200, 150]);
    const behind = drawMeasurement('probe', [[0, -600, 0]], cameraProjection(near, viewport));
    expect(behind.points_px).toEqual([undefined]);
  });
});

describe('the scale bar', () => {
  it('is the longest round length that fits', () => {
    expect(scaleBar(1, 120)).toEqual({ length_mm: 100, width_css_px: 100, parts: 5 });
    expect(scaleBar(0.5, 120)).toEqual({ length_mm: 50, width_css_px: 100, parts: 5 });
    expect(scaleBar(0.2, 119)).toEqual({ length_mm: 20, width_css_px: 100, parts: 2 });
    expect(scaleBar(0.003, 100)?.length_mm).toBe(0.2);
  });

  it('is none where nothing is known', () => {
    expect(scaleBar(0, 120)).toBeUndefined();
    expect(scaleBar(NaN, 120)).toBeUndefined();
    expect(scaleBar(Infinity, 120)).toBeUndefined();
  });

  it('speaks of centimetres from one on', () => {
    expect([500, 10, 5, 0.2, 0.0005].map(scaleText)).toEqual([
      '50 cm',
      '1 cm',
      '5 mm',
      '200 µm',
      '0.5 µm',
    ]);
  });
});
