// Controls of the lens: what it does, what that has to be told, and where it lies in the patient.
import { SCENE_FIELDS, type Scene, type VolumeSummary } from '../protocol/messages.ts';
import type { BooleanControl, Control, NumberControl } from './controls.ts';
import { nestedPatch } from './merge_patch.ts';
import { sceneChoiceControl } from './scene_controls.ts';
import { words } from '../words/words.ts';

export function lensRadiusControl(scene: Scene, volume: VolumeSummary): NumberControl {
  const field = SCENE_FIELDS['lens.radius_mm'];
  return {
    ...field,
    kind: 'number',
    id: 'lens-radius-mm',
    label: words().controls.radius,
    description: words().controls.description('lens.radius_mm'),
    value: scene.lens?.radius_mm ?? 0,
    maximum: Math.min(field.maximum, Math.ceil(volume.diagonal_mm / 2)),
    toPatch: (value) => nestedPatch(['lens', 'radius_mm'], value),
  };
}

function shareControl(name: 'strength' | 'softness', label: string, scene: Scene): NumberControl {
  const field = SCENE_FIELDS[`lens.${name}`];
  const description = words().controls.description(`lens.${name}`);
  return {
    ...field,
    kind: 'number',
    id: `lens-${name}`,
    label,
    description,
    unit: '',
    value: scene.lens?.[name] ?? field.default,
    toPatch: (value) => nestedPatch(['lens', name], value),
  };
}

function strictControl(scene: Scene): BooleanControl {
  const field = SCENE_FIELDS['lens.strict'];
  return {
    kind: 'boolean',
    id: 'lens-strict',
    label: words().controls.fade_everywhere,
    description: words().controls.description('lens.strict'),
    value: scene.lens?.strict ?? field.default,
    toPatch: (value) => nestedPatch(['lens', 'strict'], value),
  };
}

/** What the lens' present mode reads. */
export function lensModeControls(scene: Scene): readonly Control[] {
  const { cut_surfaces, strength, soft_rim } = words().controls;
  switch (scene.lens?.mode ?? SCENE_FIELDS['lens.mode'].default) {
    case 'cutaway':
      return [sceneChoiceControl('lens.cap', cut_surfaces, scene)];
    case 'magic':
      return [
        shareControl('strength', strength, scene),
        shareControl('softness', soft_rim, scene),
        strictControl(scene),
      ];
    case 'none':
      return [];
  }
}

/** The patient's directions along which millimetres count up. */
const AXES = ['L', 'P', 'S'] as const;

export interface CoordinateControl extends NumberControl {
  /** Of the patient's direction. */
  readonly letter: string;
}

/** Nothing while the scene leaves the centre open. */
export function lensCentreControls(scene: Scene): readonly CoordinateControl[] {
  const field = SCENE_FIELDS['lens.centre_mm'];
  const { centre_towards, description } = words().controls;
  const centre_mm = scene.lens?.centre_mm;
  if (!centre_mm) return [];
  return AXES.map((letter, axis) => ({
    ...field,
    description: description('lens.centre_mm'),
    kind: 'number',
    id: `lens-centre-${letter.toLowerCase()}`,
    label: centre_towards[letter],
    letter,
    value: centre_mm[axis] ?? 0,
    step: 0.1,
    toPatch: (value) => nestedPatch(['lens', 'centre_mm'], centre_mm.with(axis, Number(value))),
  }));
}
