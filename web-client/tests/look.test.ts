import { describe, expect, it } from 'vitest';
import type { ModuleDescription, Scene } from '../src/protocol/messages.ts';
import { mergePatch, type JsonObject } from '../src/state/merge_patch.ts';
import { moduleModel } from '../src/state/module_model.ts';
import { tissuePresets } from '../src/state/tissue_presets.ts';
import { rampGradient, type ToneRamp } from '../src/state/tone_ramp.ts';
import { matchingVolumes, modalitiesOf } from '../src/state/volume_search.ts';
import { capabilities, sceneMessage, volume } from './capabilities.ts';

const { scene } = sceneMessage;

describe('tissue presets', () => {
  const preset = (tissue: string, branch: 'focus' | 'context' = 'focus', of: Scene = scene) =>
    tissuePresets(branch, of, volume).find((one) => one.tissue === tissue);

  it('are offered where values are Hounsfield’s, and nowhere else', () => {
    expect(tissuePresets('focus', scene, volume)).toHaveLength(4);
    expect(tissuePresets('focus', scene, { ...volume, modality: 'MR', units: 'none' })).toEqual([]);
    expect(tissuePresets('focus', scene, { ...volume, units: 'none' })).toEqual([]);
    expect(tissuePresets('focus', scene, { ...volume, modality: '' })).toEqual([]);
  });

  it('set the band of their branch, both ends', () => {
    expect(preset('muscle')?.patch).toEqual({
      focus: { surface: { iso_value: -29, upper_value: 150 } },
    });
    expect(preset('bone', 'context')?.patch).toEqual({
      context: { surface: { iso_value: 250, upper_value: null } },
    });
  });

  it('show which one the branch draws', () => {
    expect(preset('skin', 'context')?.chosen).toBe(true);
    expect(preset('skin', 'focus')?.chosen).toBe(false);
    const vessels = mergePatch(scene as JsonObject, preset('contrast_vessels')?.patch ?? {});
    expect(preset('contrast_vessels', 'focus', vessels as Scene)?.chosen).toBe(true);
    expect(preset('bone', 'focus', vessels as Scene)?.chosen).toBe(false);
  });

  it('say where no voxel has such a value', () => {
    const soft = { ...volume, value_range: [-50, 200] as [number, number] };
    const occurring = tissuePresets('focus', scene, soft).filter(({ occurs }) => occurs);
    expect(occurring.map(({ tissue }) => tissue)).toEqual(['skin', 'muscle', 'contrast_vessels']);
  });
});

describe('the ramp of a tone shading', () => {
  const [tone] = capabilities.modules.shading;
  const light = { ...tone?.parameters[1], name: 'light', default: [1, 1, 1] };
  const two_toned = {
    ...tone,
    parameters: [...(tone?.parameters ?? []), light],
  } as ModuleDescription;
  const { controls } = moduleModel('Shading', ['focus', 'shading'], [two_toned], scene);

  it('takes the two colours out of the list, and knows the detail', () => {
    expect(controls.ramp).toMatchObject({
      dark: { value: [0.1, 0.2, 0.3] },
      light: { value: [1, 1, 1] },
      detail: { value: 0.5 },
    });
    expect(controls.basic.map(({ label }) => label)).toEqual(['Detail']);
    expect(controls.ramp?.light.toPatch([0, 0, 1])).toEqual({
      focus: { shading: { light: [0, 0, 1] } },
    });
  });

  it('is two flat tones without detail, and one ramp with all of it', () => {
    const withDetail = (value: number): ToneRamp => {
      if (!controls.ramp?.detail) throw new Error('the module has a ramp');
      const [dark, bright] = [controls.ramp.dark, controls.ramp.light];
      return {
        dark: { ...dark, value: [0, 0, 0] },
        light: { ...bright, value: [1, 1, 1] },
        detail: { ...controls.ramp.detail, value },
      };
    };
    const stops = '#000000, %1 50%, %2 50%, #ffffff';
    const gradient = (first: string, second: string) =>
      `linear-gradient(to right, ${stops.replace('%1', first).replace('%2', second)})`;
    expect(rampGradient(withDetail(0))).toBe(gradient('#000000', '#ffffff'));
    expect(rampGradient(withDetail(0.5))).toBe(gradient('#404040', '#bfbfbf'));
    expect(rampGradient(withDetail(1))).toBe(gradient('#808080', '#808080'));
  });
});

describe('the search for a volume', () => {
  const entry = { format: 'DICOM', modality: 'CT' };
  const volumes = [
    { ...entry, id: 'a/1', title: 'Schädel mit Kontrast', size_voxels: [512, 512, 200] as never },
    { ...entry, id: 'b', title: 'Chest', format: 'NIfTI' },
    { ...entry, id: 'c', title: 'Head', modality: 'MR' },
    { ...entry, id: 'd', title: 'Stack', modality: '' },
  ];
  const found = (text: string, modality = '') =>
    matchingVolumes(volumes, { text, modality }).map(({ id }) => id);

  it('finds all words anywhere in what is known, whatever their case and accents', () => {
    expect(found('')).toHaveLength(4);
    expect(found('SCHADEL')).toEqual(['a/1']);
    expect(found('kontrast ct')).toEqual(['a/1']);
    expect(found('nifti')).toEqual(['b']);
    expect(found('512×512')).toEqual(['a/1']);
    expect(found('chest mr')).toEqual([]);
  });

  it('keeps to a modality', () => {
    expect(found('', 'MR')).toEqual(['c']);
    expect(found('head', 'CT')).toEqual([]);
    expect(modalitiesOf(volumes)).toEqual(['CT', 'MR']);
  });
});
