import { describe, expect, it } from 'vitest';
import { nearestEnd, shareOf, steppedValue, valueAtShare } from '../src/state/band_handles.ts';
import { bandModel } from '../src/state/surface_controls.ts';
import { sceneMessage, volume } from './capabilities.ts';

/** -1000..3000 in steps of 10. */
const bandOf = (surface: { iso_value: number; upper_value?: number }) =>
  bandModel('focus', { ...sceneMessage.scene, focus: { surface } }, volume);

describe('the ends of a band on the histogram', () => {
  const open = bandOf({ iso_value: 0 });
  const closed = bandOf({ iso_value: 0, upper_value: 1000 });

  it('lie where their values are, and never beside it', () => {
    expect(shareOf(open.lower)).toBe(0.25);
    expect(shareOf({ ...open.lower, value: 9000 })).toBe(1);
    expect(shareOf({ ...open.lower, value: -9000 })).toBe(0);
    expect(shareOf({ ...open.lower, maximum: -1000 })).toBe(0);
  });

  it('take the value of a place, on a step of the control', () => {
    expect(valueAtShare(open.lower, 0.5)).toBe(1000);
    expect(valueAtShare(open.lower, 0.5009)).toBe(1000);
    expect(valueAtShare(open.lower, -1)).toBe(-1000);
    expect(valueAtShare(open.lower, 2)).toBe(3000);
    expect(valueAtShare({ ...open.lower, minimum: -1024 }, 0)).toBe(-1024);
    expect(valueAtShare({ ...open.lower, minimum: 0, maximum: 1, step: 0.1 }, 0.3)).toBe(0.3);
  });

  it('are taken by the nearer one', () => {
    expect(nearestEnd(open, 0.9).id).toBe('focus-iso-value');
    expect(nearestEnd(closed, 0.3).id).toBe('focus-iso-value');
    expect(nearestEnd(closed, 0.9).id).toBe('focus-upper-value');
    const narrow = bandOf({ iso_value: 5000, upper_value: 5010 });
    expect(nearestEnd(narrow, 1).id).toBe('focus-iso-value');
    expect(nearestEnd(narrow, 2).id).toBe('focus-upper-value');
  });

  it('move by keys as a slider does', () => {
    const by = (key: string, shift = false) => steppedValue(closed.lower, key, shift);
    expect([by('ArrowLeft'), by('ArrowUp'), by('ArrowRight', true)]).toEqual([-10, 10, 100]);
    expect([by('PageUp'), by('Home'), by('End'), by('Tab')]).toEqual([200, -1000, 3000, undefined]);
  });

  it('never pass each other', () => {
    expect(closed.lower.toPatch(2000)).toEqual({ focus: { surface: { iso_value: 990 } } });
  });
});
