import { describe, expect, it } from 'vitest';
import { measurementsCsv, measurementsJson } from '../src/state/measurement_export.ts';
import { resultText } from '../src/state/measure_text.ts';
import { angleDegrees, resultOf, type Measurement } from '../src/view/measurement.ts';
import {
  extended,
  freeName,
  isWhole,
  LONGEST_NAME,
  renamed,
  without,
  withPoint,
  type Draft,
} from '../src/state/measurement_list.ts';
import { sidedCoordinates } from '../src/view/orientation.ts';
import type { Vector3 } from '../src/view/vector.ts';

const at = (...position_mm: Vector3) => ({ position_mm, value: 40 });
const distance: Measurement = {
  id: 1,
  kind: 'distance',
  name: 'Distance 1',
  points: [at(0, 0, 0), at(3, 4, 12)],
};
const angle: Measurement = {
  id: 2,
  kind: 'angle',
  name: '=1+1, "half"',
  points: [at(10, 0, 0), at(0, 0, 0), at(0, 0, 5)],
};
const probe: Measurement = {
  id: 3,
  kind: 'probe',
  name: 'Probe 1',
  points: [{ position_mm: [-1.23456, 2, -3], value: -998.76543 }],
};
const list = [distance, angle, probe];

describe('what a measurement says', () => {
  it('is a length in millimetres, an angle at the second point, the value of the volume', () => {
    expect(resultOf(distance, 'HU')).toEqual({ value: 13, unit: 'mm' });
    expect(resultOf(angle, 'HU')?.value).toBeCloseTo(90);
    expect(resultOf(probe, 'HU')).toEqual({ value: -998.76543, unit: 'HU' });
    expect(resultOf(probe, 'none')?.unit).toBe('none');
  });

  it('shows values in whatever unit the volume has', () => {
    expect(resultText({ value: -998.7, unit: 'HU' })).toBe('-999 HU');
    expect(resultText({ value: 1234, unit: 'BQML' })).toBe('1,234 BQML');
    expect(resultText({ value: 0.25, unit: 'none' })).toBe('0.2500');
  });

  it('is nothing while points are missing', () => {
    expect(resultOf({ kind: 'distance', points: [at(0, 0, 0)] }, 'HU')).toBeUndefined();
    expect(resultOf({ kind: 'angle', points: distance.points }, 'HU')).toBeUndefined();
    expect(resultOf({ kind: 'probe', points: [] }, 'HU')).toBeUndefined();
  });

  it('has no angle without legs, and one of 0 and 180 degrees on a line', () => {
    expect(angleDegrees([1, 2, 3], [1, 2, 3], [4, 5, 6])).toBeUndefined();
    expect(angleDegrees([0.1, 0.2, 0.3], [0, 0, 0], [0.1, 0.2, 0.3])).toBeCloseTo(0, 4);
    expect(angleDegrees([-1, -1, -1], [0, 0, 0], [7, 7, 7])).toBeCloseTo(180, 4);
  });
});

describe('a patient position', () => {
  it('is told by the side it lies to', () => {
    expect(sidedCoordinates([-12, 3, 0])).toEqual([
      { letter: 'R', distance_mm: 12 },
      { letter: 'P', distance_mm: 3 },
      { letter: 'S', distance_mm: 0 },
    ]);
    expect(sidedCoordinates([1, -1, -1]).map(({ letter }) => letter)).toEqual(['L', 'A', 'I']);
  });
});

describe('the list', () => {
  it('finds the first free name', () => {
    expect(freeName('Distance', list)).toBe('Distance 2');
    expect(freeName('Angle', list)).toBe('Angle 1');
  });

  it('renames, shortens what is too long, and leaves the old name for an empty one', () => {
    expect(renamed(list, 2, '  Femoral neck ')[1]?.name).toBe('Femoral neck');
    expect(renamed(list, 2, ' ')).toBe(list);
    expect(renamed(list, 2, 'x'.repeat(200))[1]?.name).toHaveLength(LONGEST_NAME);
  });

  it('removes one and keeps the others', () => {
    expect(without(list, 2)).toEqual([distance, probe]);
  });

  it('moves a point, but not onto another of the same measurement', () => {
    expect(withPoint(list, 1, 1, at(0, 0, 2))[0]?.points).toEqual([at(0, 0, 0), at(0, 0, 2)]);
    expect(withPoint(list, 1, 1, at(0, 0, 0.001))).toEqual(list);
    expect(withPoint(list, 1, 7, at(1, 1, 1))).toEqual(list);
  });
});

describe('a draft', () => {
  it('is whole with its last point, and takes no point twice', () => {
    let draft: Draft = { kind: 'distance', points: [] };
    draft = extended(draft, at(1, 1, 1));
    draft = extended(draft, at(1, 1, 1.001));
    expect(isWhole(draft)).toBe(false);
    draft = extended(draft, at(1, 1, 2));
    expect(isWhole(draft)).toBe(true);
  });
});

describe('the files', () => {
  const volume = { id: 'phantom:head', title: 'Head, "CT"', modality: 'CT', units: 'HU' } as const;

  it('are JSON that says volume, space and units', () => {
    const document = JSON.parse(
      measurementsJson(list, volume, 'Not for diagnostic use'),
    ) as unknown;
    expect(document).toMatchObject({
      format: 'cutaway-measurements',
      version: 1,
      notice: 'Not for diagnostic use',
      volume: { id: 'phantom:head' },
      position_unit: 'mm',
      value_unit: 'HU',
      measurements: [
        { name: 'Distance 1', kind: 'distance', length_mm: 13 },
        { kind: 'angle', angle_degrees: 90 },
        { kind: 'probe', value: -998.765, points: [{ position_mm: [-1.235, 2, -3] }] },
      ],
    });
  });

  it('are CSV with as many fields in each row, quoted, and without formulas', () => {
    const csv = measurementsCsv(list, volume, 'Not for diagnostic use');
    expect(csv.startsWith('\uFEFFname,kind,result,unit,point1_left_mm,')).toBe(true);
    const [header, first, second, third, end] = csv.slice(1).split('\r\n');
    expect(first).toBe(
      'Distance 1,distance,13,mm,0,0,0,40,3,4,12,40,,,,,HU,"Head, ""CT""",Not for diagnostic use',
    );
    expect(second?.startsWith(`"'=1+1, ""half""",angle,90,degrees,`)).toBe(true);
    expect(third?.startsWith('Probe 1,probe,-998.765,HU,-1.235,2,-3,-998.765,,')).toBe(true);
    expect(end).toBe('');
    expect(first?.replaceAll(/"[^"]*"/g, '').split(',')).toHaveLength(
      header?.split(',').length ?? 0,
    );
  });
});
