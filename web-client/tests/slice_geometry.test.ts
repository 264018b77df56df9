import { describe, expect, it } from 'vitest';
import {
  extentAlong,
  shownPlanes,
  slicePlane,
  sliceProjection,
  voxelStepMm,
  type SliceName,
  type Slices,
} from '../src/view/slice_geometry.ts';
import {
  isTilted,
  panned,
  scrolledBy,
  scrolledTo,
  tilted,
  zoomed,
} from '../src/view/slice_motion.ts';
import { edgeLetters } from '../src/view/orientation.ts';
import { cross, dot, length, type Vector3 } from '../src/view/vector.ts';
import { volume as head } from './capabilities.ts';

/** 100 x 80 x 60 voxels of 1, 2 and 3 mm, the first one's centre at the origin of patient space. */
const volume = {
  ...head,
  size_voxels: [100, 80, 60] as [number, number, number],
  spacing_mm: [1, 2, 3] as [number, number, number],
  origin_mm: [0, 0, 0] as [number, number, number],
};
const viewport = { width_px: 400, height_px: 200 };
const middle = { centre_mm: [10, 20, 30] as [number, number, number], view_height_mm: 100 };
const slices: Slices = {
  crosshair_mm: [1, 2, 3],
  superior: [0, 0, 1],
  anterior: [0, -1, 0],
  convention: 'radiological',
  axial: middle,
  coronal: middle,
  sagittal: middle,
};

const planeOf = (name: SliceName, said: Slices = slices) => {
  const plane = slicePlane(said, name);
  if (!plane) throw new Error('the plane is open');
  return plane;
};
const viewOf = (name: SliceName, said: Slices = slices) =>
  sliceProjection(planeOf(name, said), volume, viewport);

function expectPoint(point: readonly number[] | undefined, wanted: readonly number[]): void {
  expect(point).toHaveLength(wanted.length);
  wanted.forEach((part, index) => expect(point?.[index]).toBeCloseTo(part, 6));
}

describe('a slice’s plane', () => {
  it.each([
    ['axial', 'radiological', 'A L P R'],
    ['coronal', 'radiological', 'S L I R'],
    ['sagittal', 'radiological', 'S P I A'],
    ['axial', 'neurological', 'A R P L'],
    ['coronal', 'neurological', 'S R I L'],
    ['sagittal', 'neurological', 'S P I A'],
  ] as const)('%s, %s, has the patient’s sides where they belong', (name, convention, letters) => {
    const edges = edgeLetters(planeOf(name, { ...slices, convention }));
    expect([edges.top, edges.right, edges.bottom, edges.left].join(' ')).toBe(letters);
  });

  it('goes through the crosshair, seen from over its own centre', () => {
    expectPoint(planeOf('axial').centre_mm, [10, 20, 3]);
    expectPoint(planeOf('coronal').centre_mm, [10, 2, 30]);
    expectPoint(planeOf('sagittal').centre_mm, [1, 20, 30]);
  });

  it('is open while the scene leaves it open', () => {
    expect(slicePlane(undefined, 'axial')).toBeUndefined();
    expect(slicePlane({}, 'axial')).toBeUndefined();
    expect(slicePlane({ ...slices, coronal: {} }, 'coronal')).toBeUndefined();
  });

  it.each(['axial', 'coronal', 'sagittal'] as const)(
    '%s, oblique, has orthonormal axes through the crosshair',
    (name) => {
      const plane = planeOf(name, {
        ...slices,
        superior: [0.3, -0.2, 2],
        anterior: [0.4, -1, 0.7],
      });
      const { right, up, normal } = plane;
      for (const axis of [right, up, normal]) expect(length(axis)).toBeCloseTo(1, 9);
      expect(dot(right, up)).toBeCloseTo(0, 9);
      expect(Math.abs(dot(cross(right, up), normal))).toBeCloseTo(1, 9);
      const view = sliceProjection(plane, volume, viewport);
      expect(view.distanceMm([1, 2, 3])).toBeCloseTo(0, 9);
    },
  );

  it('between the patient’s directions has letters of both', () => {
    const oblique = { ...slices, anterior: [0.5, -1, 0] as [number, number, number] };
    expect(edgeLetters(planeOf('axial', oblique)).top).toBe('AL');
    expect(edgeLetters(planeOf('axial', oblique)).right).toBe('LP');
  });
});

describe('a slice’s picture', () => {
  it('has the centre in its middle and the height that it is to span', () => {
    const view = viewOf('axial');
    expectPoint(view.toPicture([10, 20, 3]), [200, 100]);
    expect(view.mm_per_pixel).toBe(0.5);
    // 5 mm to the patient's left, 10 mm to anterior.
    expectPoint(view.toPicture([15, 10, 99]), [210, 80]);
  });

  it.each(['axial', 'coronal', 'sagittal'] as const)('%s goes to the patient and back', (name) => {
    for (const convention of ['radiological', 'neurological'] as const) {
      const view = viewOf(name, { ...slices, convention, superior: [0.2, 0.1, 1] });
      const point_mm = view.toPatient([37, 151]);
      expectPoint(view.toPicture(point_mm), [37, 151]);
      expect(view.distanceMm(point_mm)).toBeCloseTo(0, 9);
    }
  });

  it('of the whole volume holds its width and its height, with a margin', () => {
    const whole = { ...slices, axial: { centre_mm: middle.centre_mm } };
    // 100 mm wide and 160 mm high in a picture of 2 : 1, and of 1 : 4.
    expect(viewOf('axial', whole).mm_per_pixel * 200).toBeCloseTo(160 * 1.02, 6);
    const narrow = { width_px: 100, height_px: 400 };
    const view = sliceProjection(planeOf('axial', whole), volume, narrow);
    expect(view.mm_per_pixel * 400).toBeCloseTo(400 * 1.02, 6);
  });
});

describe('scrolling', () => {
  it('steps by the spacing along the normal', () => {
    expect(voxelStepMm(volume, [0, 0, 1])).toBe(3);
    expect(voxelStepMm(volume, [0, -1, 0])).toBe(2);
    expectPoint(scrolledBy(slices, 'axial', 2, volume), [1, 2, 9]);
    expectPoint(scrolledBy(slices, 'coronal', 1, volume), [1, 0, 3]);
    expectPoint(scrolledBy(slices, 'sagittal', 1, volume), [2, 2, 3]);
  });

  it('goes to a slice of the volume from between two', () => {
    const between: Slices = { ...slices, crosshair_mm: [1, 2, 4] };
    expectPoint(scrolledBy(between, 'axial', 1, volume), [1, 2, 6]);
    expectPoint(scrolledBy(between, 'axial', -1, volume), [1, 2, 3]);
    expectPoint(scrolledBy(between, 'axial', -2, volume), [1, 2, 0]);
    const nearly: Slices = { ...slices, crosshair_mm: [1, 2, 3.0001] };
    expectPoint(scrolledBy(nearly, 'axial', 1, volume), [1, 2, 6]);
    expectPoint(scrolledBy(nearly, 'axial', -1, volume), [1, 2, 0]);
  });

  it('is a voxel’s size across an oblique plane, from wherever it begins', () => {
    const tilt: Pick<Slices, 'superior' | 'anterior'> = {
      superior: [0, -0.6, 0.8],
      anterior: [0, -0.8, -0.6],
    };
    const oblique: Slices = { ...slices, ...tilt, crosshair_mm: [1, 20, 40] };
    const moved = scrolledBy(oblique, 'axial', 1, volume);
    const step_mm = voxelStepMm(volume, [0, -0.6, 0.8]);
    expectPoint(moved, [1, 20 - 0.6 * step_mm, 40 + 0.8 * step_mm]);
  });

  it('ends with the voxels', () => {
    expect(extentAlong(volume, [0, 0, 1])).toEqual({ minimum: 0, maximum: 177 });
    expectPoint(scrolledBy(slices, 'axial', -5, volume), [1, 2, 0]);
    expectPoint(scrolledTo(slices, 'axial', 1000, volume), [1, 2, 177]);
  });
});

describe('a gesture in a slice', () => {
  const after = (part: { centre_mm: Vector3; view_height_mm: number }) =>
    viewOf('axial', {
      ...slices,
      axial: { ...part, centre_mm: [...part.centre_mm] as [number, number, number] },
    });

  it('pans so that the patient follows the pointer', () => {
    const under_mm = viewOf('axial').toPatient([120, 60]);
    expectPoint(after(panned(viewOf('axial'), 30, -12)).toPicture(under_mm), [150, 48]);
  });

  it('zooms about the pointer', () => {
    const under_mm = viewOf('axial').toPatient([120, 60]);
    const view = after(zoomed(viewOf('axial'), 2, [120, 60]));
    expect(view.mm_per_pixel).toBe(0.25);
    expectPoint(view.toPicture(under_mm), [120, 60]);
  });

  it.each(['axial', 'coronal', 'sagittal'] as const)('is read from the %s picture', (name) => {
    const turned = tilted(slices, planeOf('coronal'), 0.3);
    for (const convention of ['radiological', 'neurological'] as const) {
      const said = { ...slices, ...turned, convention } as Slices;
      const shown = shownPlanes(planeOf(name, said), name);
      expectPoint(shown.superior, turned.superior);
      expectPoint(shown.anterior, turned.anterior);
      expect(shown.convention).toBe(name === 'sagittal' ? undefined : convention);
    }
  });

  it('tilts the other two planes about its normal', () => {
    const turned = tilted(slices, planeOf('coronal'), Math.PI / 6);
    expect(isTilted(slices)).toBe(false);
    const oblique: Slices = {
      ...slices,
      superior: [...turned.superior] as [number, number, number],
      anterior: [...turned.anterior] as [number, number, number],
    };
    expect(isTilted(oblique)).toBe(true);
    expectPoint(planeOf('coronal', oblique).normal, planeOf('coronal').normal);
    // Counter-clockwise in the picture, in which left is right: superior turns to the patient's right.
    expectPoint(planeOf('axial', oblique).normal, [
      -Math.sin(Math.PI / 6),
      0,
      Math.cos(Math.PI / 6),
    ]);
  });
});
