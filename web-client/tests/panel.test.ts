import { describe, expect, it } from 'vitest';
import type { Scene } from '../src/protocol/messages.ts';
import { readable, roundStep } from '../src/state/controls.ts';
import { filterListModel } from '../src/state/filter_model.ts';
import { moduleModel } from '../src/state/module_model.ts';
import {
  lightControls,
  projectionControl,
  sceneChoiceControl,
} from '../src/state/scene_controls.ts';
import { KEY_BINDINGS } from '../src/interaction/keyboard.ts';
import { deviceSize } from '../src/interaction/viewport_size.ts';
import { withinLimits } from '../src/session/viewport_fit.ts';
import { capabilities, sceneMessage } from './capabilities.ts';

const { scene } = sceneMessage;
const { shading, filter } = capabilities.modules;
/** Filters that this test's registry has. */
const filtered = {
  focus: { filters: [{ name: 'blur', radius: 5 }, { name: 'lines' }] },
} as unknown as Scene;

describe('a place for a module', () => {
  const model = moduleModel('Shading', ['focus', 'shading'], shading, scene);

  it('offers what the registry has', () => {
    expect(model.choice).toMatchObject({
      value: 'tone',
      choices: [
        { value: 'tone', label: 'Tone' },
        { value: 'phong', label: 'Phong' },
      ],
    });
    expect(model.choice.toPatch('phong')).toEqual({ focus: { shading: { name: 'phong' } } });
  });

  it('has the chosen module’s parameters, by level, with the scene’s values or the defaults', () => {
    const [detail, dark] = model.controls.basic;
    expect(detail).toMatchObject({
      kind: 'number',
      value: 0.5,
      minimum: 0,
      maximum: 1,
      step: 0.01,
    });
    expect(dark).toMatchObject({ kind: 'colour', value: [0.1, 0.2, 0.3] });
    expect(model.controls.advanced).toMatchObject([
      { kind: 'choice', value: 'half', choices: [{ label: 'Half' }, { label: 'Clamped' }] },
    ]);
    expect(detail?.toPatch(0.25)).toEqual({ focus: { shading: { detail: 0.25 } } });
  });

  it('shows a length in the unit in which the scene says it', () => {
    const relative = {
      name: 'width_per_mille',
      minimum: 0,
      maximum: 20,
      step: 0.1,
      unit: 'per mille of the height',
    };
    const width = { name: 'width', title: 'Width', description: '', default: 2 };
    const lined: (typeof shading)[number] = {
      name: 'lined',
      title: 'Lined',
      description: '',
      parameters: [{ ...width, type: 'integer', unit: 'px', level: 'basic', relative }],
    };
    const shown = (module: object) =>
      moduleModel('Shading', ['focus', 'shading'], [lined], {
        focus: { shading: { name: 'lined', ...module } },
      } as unknown as Scene).controls.basic[0];
    expect(shown({ width: 3 })).toMatchObject({ value: 3, unit: 'px', label: 'Width' });
    const said = shown({ width_per_mille: 4.5 });
    expect(said).toMatchObject({ value: 4.5, maximum: 20, step: 0.1, label: 'Width' });
    expect(said?.toPatch(5)).toEqual({ focus: { shading: { width_per_mille: 5 } } });
  });

  it('shows a switch for a boolean', () => {
    const phong = moduleModel('Shading', ['focus', 'shading'], shading, {
      focus: { shading: { name: 'phong' } },
    });
    expect(phong.controls.basic).toMatchObject([{ kind: 'boolean', value: true }]);
  });

  it('survives a module that the server does not describe', () => {
    const unknown = moduleModel('Shading', ['focus', 'shading'], [], scene);
    expect(unknown.controls).toEqual({ basic: [], advanced: [] });
  });
});

describe('the list of filters', () => {
  const model = filterListModel('focus', filter, filtered);
  const [blur, lines] = model.filters;

  it('changes one parameter and keeps the rest of the list', () => {
    const [radius] = blur?.controls.basic ?? [];
    expect(radius).toMatchObject({ kind: 'number', value: 5, step: 1, unit: 'px' });
    expect(radius?.toPatch(7)).toEqual({
      focus: { filters: [{ name: 'blur', radius: 7 }, { name: 'lines' }] },
    });
  });

  it('removes, reorders and adds', () => {
    expect(blur?.removed).toEqual({ focus: { filters: [{ name: 'lines' }] } });
    expect(blur?.earlier).toBeUndefined();
    expect(blur?.later).toEqual({
      focus: { filters: [{ name: 'lines' }, { name: 'blur', radius: 5 }] },
    });
    expect(lines?.later).toBeUndefined();
  });

  it('offers what is not there yet, for the server refuses a filter twice', () => {
    expect(model.additions).toEqual([]);
    const one = { focus: { filters: [{ name: 'lines' }] } } as unknown as Scene;
    const { additions } = filterListModel('focus', filter, one);
    expect(additions.map(({ title }) => title)).toEqual(['Blur']);
    expect(additions[0]?.patch).toEqual({
      focus: { filters: [{ name: 'lines' }, { name: 'blur' }] },
    });
  });

  it('offers nothing more once it is full', () => {
    const full = {
      focus: { filters: Array.from({ length: 8 }, () => ({ name: 'lines' })) },
    } as unknown as Scene;
    expect(filterListModel('focus', filter, full).additions).toEqual([]);
  });
});

describe('the scene’s own controls', () => {
  it('take choices from the schema', () => {
    const control = sceneChoiceControl('lens.cap', 'Cut surfaces', scene);
    expect(control.choices.map(({ value }) => value)).toEqual([
      'flat',
      'gradient',
      'open',
      'section',
    ]);
    expect(control.toPatch('open')).toEqual({ lens: { cap: 'open' } });
  });

  it('turn the light by one angle and keep the other', () => {
    const [azimuth] = lightControls({ light: { direction: [0, 0.6, 0.8] } });
    const patch = azimuth?.toPatch(90) as { light: { direction: number[] } };
    [0.8, 0.6, 0].forEach((part, axis) => expect(patch.light.direction[axis]).toBeCloseTo(part));
  });

  it('change the projection together with its height of view', () => {
    const patch = projectionControl(scene).toPatch('orthographic');
    expect(patch).toMatchObject({
      camera: { projection: 'orthographic', view_height_mm: expect.closeTo(321.5, 1) as number },
    });
  });
});

describe('small rules', () => {
  it('make names readable', () => expect(readable('half_vector-mode')).toBe('Half vector mode'));

  it('choose round steps', () => {
    expect(roundStep(0, 1)).toBe(0.001);
    expect(roundStep(-1000, 3000)).toBe(10);
    expect(roundStep(5, 5)).toBeGreaterThan(0);
  });

  it('count device pixels exactly where the browser can, and never CSS pixels instead', () => {
    const css = { width: 100.3, height: 50.2 };
    const exact = { width_px: 151, height_px: 75 };
    expect(deviceSize(css, exact, 1.5)).toBe(exact);
    expect(deviceSize(css, undefined, 1.5)).toEqual({ width_px: 150, height_px: 75 });
    const emulated = { width_px: 100, height_px: 50 };
    expect(deviceSize(css, emulated, 2)).toEqual({ width_px: 201, height_px: 100 });
  });

  it('keep a viewport’s shape within the server’s limits', () => {
    const limits = (viewport_side_px: number, viewport_pixels: number) => ({
      viewport_side_px,
      viewport_pixels,
    });
    expect(withinLimits({ width_px: 800, height_px: 600 }, limits(4096, 8e6))).toEqual({
      width_px: 800,
      height_px: 600,
    });
    expect(withinLimits({ width_px: 8000, height_px: 4000 }, limits(4000, 1e9))).toEqual({
      width_px: 4000,
      height_px: 2000,
    });
    expect(withinLimits({ width_px: 4000, height_px: 4000 }, limits(9000, 4e6))).toEqual({
      width_px: 2000,
      height_px: 2000,
    });
  });

  it.each([
    ['in 3-D', ['slices']],
    ['in a slice', ['view', 'lens']],
  ])('bind no key twice %s', (_where, meaningless) => {
    const keys = KEY_BINDINGS.filter(({ group }) => !meaningless.includes(group)).map(
      (binding) => binding.keys,
    );
    expect(new Set(keys).size).toBe(keys.length);
  });
});
