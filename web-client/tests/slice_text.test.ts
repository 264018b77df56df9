import { describe, expect, it } from 'vitest';
import { positionText } from '../src/state/measure_text.ts';
import { offsetText, planeOffsetText } from '../src/state/slice_text.ts';

describe('where something lies', () => {
  it('is told by its side', () => {
    expect(offsetText([0, 0, 1], 34.5)).toBe('S 34.5 mm');
    expect(offsetText([0, 0, 1], -34.5)).toBe('I 34.5 mm');
    expect(positionText([12.3, 40.1, -8.8])).toBe('L 12.3 · P 40.1 · I 8.8 mm');
  });

  it('is where the plane of the picture lies', () => {
    const plane = {
      right: [1, 0, 0],
      up: [0, 0, 1],
      normal: [0, -1, 0],
      centre_mm: [7, 12, 9],
      view_height_mm: undefined,
    } as const;
    expect(planeOffsetText(plane)).toBe('P 12.0 mm');
  });

  it('is on neither side where it rounds to nothing', () => {
    for (const offset_mm of [0, -0, 0.04, -0.04])
      expect(offsetText([0, 0, 1], offset_mm)).toBe('0.0 mm');
    expect(offsetText([0, 0, 1], -0.06)).toBe('I 0.1 mm');
    expect(positionText([-0.01, 5, 0.02])).toBe('0.0 · P 5.0 · 0.0 mm');
  });
});
