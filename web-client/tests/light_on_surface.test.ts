import { describe, expect, it } from 'vitest';
import type { Scene } from '../src/protocol/messages.ts';
import type { Control, NumberControl } from '../src/state/controls.ts';
import { isTranslucent, lightOnSurface } from '../src/state/light_on_surface.ts';
import type { ControlLevels } from '../src/state/module_model.ts';
import { islandsControls, preparationSwitches } from '../src/state/preparation_controls.ts';
import { wallControls } from '../src/state/wall_controls.ts';
import { volume } from './capabilities.ts';

type Part<Name extends keyof Scene> = NonNullable<Scene[Name]>;

const ids = (controls: readonly Control[]): string[] => controls.map(({ id }) => id);
const idsOf = ({ basic, advanced }: ControlLevels): string[][] => [ids(basic), ids(advanced)];
const focus = (branch: Part<'focus'>) => lightOnSurface('focus', { focus: branch }, volume);

describe('the light on a surface', () => {
  it('shows no more than what does something', () => {
    expect(idsOf(focus({}))).toEqual([
      ['focus-smoothing', 'focus-occlusion-strength', 'focus-shadow-strength'],
      ['focus-normals-reconstruction', 'preparation-focus-islands-ml'],
    ]);
    const lit = focus({ occlusion: { strength: 0.5 }, shadow: { strength: 0.2 } });
    expect(idsOf(lit)[1]).toEqual([
      'focus-normals-reconstruction',
      'focus-occlusion-near-share',
      'focus-occlusion-colour',
      'focus-shadow-softness-degrees',
      'preparation-focus-islands-ml',
    ]);
  });

  it('has its ranges, units and defaults from the schema', () => {
    const { basic, advanced } = focus({ shadow: { strength: 0.2 } });
    expect(basic[2]).toMatchObject({ value: 0.2, minimum: 0, maximum: 1, step: 0.01, unit: '' });
    expect(advanced[1]).toMatchObject({ value: 5, maximum: 20, step: 0.5, unit: 'degrees' });
    expect(basic[1]?.toPatch(0.6)).toEqual({ focus: { occlusion: { strength: 0.6 } } });
  });

  it('says the smoothing in one choice of three', () => {
    const choice = (normals: Part<'focus'>['normals']) =>
      focus(normals ? { normals } : {}).basic[0] as Control;
    expect(choice(undefined).value).toBe('off');
    expect(choice({ scale: 'auto', scale_mm: 2 }).value).toBe('auto');
    expect(choice({ scale: 'fixed', scale_mm: 2 }).value).toBe('mm');
    const patches = ['off', 'auto', 'mm'].map((value) => choice(undefined).toPatch(value));
    expect(patches).toEqual([
      { focus: { normals: { scale: 'fixed', scale_mm: 0 } } },
      { focus: { normals: { scale: 'auto' } } },
      { focus: { normals: { scale: 'fixed', scale_mm: 3 } } },
    ]);
  });

  it('never smooths by nothing while the width is being set', () => {
    const [, width] = focus({ normals: { scale: 'fixed', scale_mm: 2 } }).basic;
    expect(width).toMatchObject({
      value: 2,
      minimum: 0.1,
      maximum: 10,
      accepts: { minimum: 0.1, maximum: 20 },
      unit: 'mm',
    });
  });

  it('begins with a width that fine and coarse voxels allow', () => {
    const first = (spacing_mm: [number, number, number]) =>
      lightOnSurface('context', {}, { ...volume, spacing_mm }).basic[0]?.toPatch('mm');
    const width = (scale_mm: number) => ({ context: { normals: { scale: 'fixed', scale_mm } } });
    expect(first([0.01, 0.01, 0.01])).toEqual(width(0.1));
    expect(first([1, 1, 40])).toEqual(width(10));
  });

  it('is drawn on opaque surfaces only', () => {
    const surface = { opacity: 0.5 };
    expect([{}, { focus: { surface } }, { context: { surface } }].map(isTranslucent)).toEqual([
      false,
      true,
      true,
    ]);
  });
});

describe('the preparation of a volume', () => {
  it('has two switches, off where nothing is said', () => {
    const [couch, fill] = preparationSwitches({ preparation: { fill_context: true } });
    expect([couch?.value, fill?.value]).toEqual([false, true]);
    expect(couch?.toPatch(true)).toEqual({ preparation: { hide_couch: true } });
  });

  it('leaves small parts out by branch, unless the band has an upper end', () => {
    const [islands] = islandsControls('context', { preparation: { context_islands_ml: 2.5 } });
    expect(islands).toMatchObject({ value: 2.5, unit: 'ml', accepts: { maximum: 1000 } });
    expect(islands?.toPatch(4)).toEqual({ preparation: { context_islands_ml: 4 } });
    const banded = { focus: { surface: { upper_value: 300 } } };
    expect(islandsControls('focus', banded)).toEqual([]);
    expect(islandsControls('context', banded)).toHaveLength(1);
  });
});

describe('the wall of the cavity', () => {
  const wall = (lens: Part<'lens'>) => idsOf(wallControls({ lens }));

  it('shows no more than what does something', () => {
    expect(wall({})).toEqual([
      ['lens-wall-strength'],
      ['lens-wall-deepening', 'lens-wall-edge-mm'],
    ]);
    expect(wall({ wall: { strength: 0.8, edge_mm: 2 } })).toEqual([
      ['lens-wall-strength', 'lens-wall-colour'],
      ['lens-wall-deepening', 'lens-wall-edge-mm', 'lens-wall-edge-colour'],
    ]);
    expect(wall({ cap: 'open', wall: { edge_mm: 2 } })[1]).toEqual(['lens-wall-deepening']);
  });

  it('changes its own part of the lens', () => {
    const { basic, advanced } = wallControls({ lens: { wall: { strength: 1 } } });
    expect(basic[1]).toMatchObject({ kind: 'colour', value: [0.58, 0.31, 0.29] });
    expect(basic[1]?.toPatch([1, 0, 0])).toEqual({ lens: { wall: { colour: [1, 0, 0] } } });
    const edge = advanced[1] as NumberControl;
    expect([edge.maximum, edge.accepts?.maximum]).toEqual([10, 50]);
  });
});
