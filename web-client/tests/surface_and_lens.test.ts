import { describe, expect, it } from 'vitest';
import type { Scene } from '../src/protocol/messages.ts';
import {
  lensCentreControls,
  lensModeControls,
  lensRadiusControl,
} from '../src/state/lens_controls.ts';
import { holdsNull } from '../src/state/merge_patch.ts';
import { bandModel } from '../src/state/surface_controls.ts';
import { sceneMessage, volume } from './capabilities.ts';

const { scene } = sceneMessage;
const withSurface = (surface: NonNullable<NonNullable<Scene['focus']>['surface']>): Scene => ({
  ...scene,
  focus: { surface },
});
const withLens = (lens: Scene['lens']): Scene => ({ ...scene, lens: { ...scene.lens, ...lens } });

describe('the band of a surface', () => {
  it('takes range and unit from the volume, and what is left out as the server chooses it', () => {
    const { lower, has_upper, upper, opacity } = bandModel('focus', scene, volume);
    expect(lower).toMatchObject({
      value: 300,
      minimum: -1000,
      maximum: 3000,
      step: 10,
      unit: 'HU',
    });
    expect([has_upper.value, upper]).toEqual([false, undefined]);
    expect(opacity).toMatchObject({ value: 1, minimum: 0, maximum: 1, unit: 'per mm' });
    expect(bandModel('context', {}, volume).lower.value).toBe(-200);
  });

  it('gets an upper end by a switch, and loses it with a null', () => {
    const { has_upper } = bandModel('focus', scene, volume);
    expect(has_upper.toPatch(true)).toEqual({ focus: { surface: { upper_value: 1650 } } });
    const patch = has_upper.toPatch(false);
    expect(patch).toEqual({ focus: { surface: { upper_value: null } } });
    expect(holdsNull(patch)).toBe(true);
  });

  it('never turns empty: neither end passes the other', () => {
    const { lower, upper } = bandModel(
      'focus',
      withSurface({ iso_value: 100, upper_value: 500 }),
      volume,
    );
    expect(upper?.value).toBe(500);
    expect(lower.toPatch(900)).toEqual({ focus: { surface: { iso_value: 490 } } });
    expect(lower.toPatch(200)).toEqual({ focus: { surface: { iso_value: 200 } } });
    expect(upper?.toPatch(-300)).toEqual({ focus: { surface: { upper_value: 110 } } });
  });

  it('has room for an upper end even where the lower one is the largest value', () => {
    const { has_upper } = bandModel('focus', withSurface({ iso_value: 3000 }), volume);
    expect(has_upper.toPatch(true)).toEqual({ focus: { surface: { upper_value: 3010 } } });
  });
});

describe('the lens', () => {
  const ids = (mode: 'none' | 'cutaway' | 'magic'): string[] =>
    lensModeControls(withLens({ mode })).map(({ id }) => id);

  it('offers what its mode reads', () => {
    expect(ids('none')).toEqual([]);
    expect(ids('cutaway')).toEqual(['lens-opening', 'lens-cap']);
    expect(ids('magic')).toEqual(['lens-strength', 'lens-softness', 'lens-strict']);
  });

  it('asks for a funnel’s angle only where there is a funnel', () => {
    const [opening, angle] = lensModeControls(withLens({ mode: 'cutaway', opening: 'funnel' }));
    expect(opening).toMatchObject({ value: 'funnel', choices: [{ value: 'closed' }, {}] });
    expect(angle).toMatchObject({ id: 'lens-funnel-degrees', value: 8, maximum: 60 });
    expect(angle?.toPatch(12)).toEqual({ lens: { funnel_degrees: 12 } });
  });

  it('has its ranges and defaults from the schema', () => {
    const [strength, , strict] = lensModeControls(withLens({ mode: 'magic', softness: 0 }));
    expect(strength).toMatchObject({ value: 0.85, minimum: 0, maximum: 1, step: 0.01 });
    expect(strict).toMatchObject({ kind: 'boolean', value: false });
    expect(strict?.toPatch(true)).toEqual({ lens: { strict: true } });
  });

  it('is bounded by the volume', () => {
    expect(lensRadiusControl(scene, volume)).toMatchObject({
      value: 30,
      minimum: 0,
      maximum: 45,
      unit: 'mm',
    });
  });

  it('lies in the patient: one number for each direction', () => {
    const controls = lensCentreControls(withLens({ centre_mm: [1, -80, 3] }));
    expect(controls.map(({ letter, value, unit }) => [letter, value, unit])).toEqual([
      ['L', 1, 'mm'],
      ['P', -80, 'mm'],
      ['S', 3, 'mm'],
    ]);
    expect(controls[1]?.toPatch(12.5)).toEqual({ lens: { centre_mm: [1, 12.5, 3] } });
    expect(lensCentreControls({})).toEqual([]);
  });
});
