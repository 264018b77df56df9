// Controls of the lens: what it does, what that has to be told, and where it lies in the patient.
import { SCENE_FIELDS, type Scene, type VolumeSummary } from '../protocol/messages.ts';
import type { BooleanControl, Control, NumberControl } from './controls.ts';
import { nestedPatch } from './merge_patch.ts';
import { sceneChoiceControl } from './scene_controls.ts';

export function lensRadiusControl(scene: Scene, volume: VolumeSummary): NumberControl {
  const field = SCENE_FIELDS['lens.radius_mm'];
  return {
    ...field,
    kind: 'number',
    id: 'lens-radius-mm',
    label: 'Radius',
    value: scene.lens?.radius_mm ?? 0,
    maximum: Math.min(field.maximum, Math.ceil(volume.diagonal_mm / 2)),
    toPatch: (value) => nestedPatch(['lens', 'radius_mm'], value),
  };
}

function shareControl(name: 'strength' | 'softness', label: string, scene: Scene): NumberControl {
  const field = SCENE_FIELDS[`lens.${name}`];
  return {
    ...field,
    kind: 'number',
    id: `lens-${name}`,
    label,
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
    label: 'Fade the context everywhere',
    description: field.description,
    value: scene.lens?.strict ?? field.default,
    toPatch: (value) => nestedPatch(['lens', 'strict'], value),
  };
}

/** What the lens' present mode reads. */
export function lensModeControls(scene: Scene): readonly Control[] {
  switch (scene.lens?.mode ?? SCENE_FIELDS['lens.mode'].default) {
    case 'cutaway':
      return [sceneChoiceControl('lens.cap', 'Cut surfaces', scene)];
    case 'magic':
      return [
        shareControl('strength', 'Strength', scene),
        shareControl('softness', 'Soft rim', scene),
        strictControl(scene),
      ];
    case 'none':
      return [];
  }
}

/** The patient's directions along which millimetres count up. */
const AXES = [
  { letter: 'L', name: 'left' },
  { letter: 'P', name: 'posterior' },
  { letter: 'S', name: 'superior' },
] as const;

export interface CoordinateControl extends NumberControl {
  /** Of the patient's direction. */
  readonly letter: string;
}

/** Nothing while the scene leaves the centre open. */
export function lensCentreControls(scene: Scene): readonly CoordinateControl[] {
  const field = SCENE_FIELDS['lens.centre_mm'];
  const centre_mm = scene.lens?.centre_mm;
  if (!centre_mm) return [];
  return AXES.map(({ letter, name }, axis) => ({
    ...field,
    kind: 'number',
    id: `lens-centre-${letter.toLowerCase()}`,
    label: `Centre towards ${name} (${letter})`,
    letter,
    value: centre_mm[axis] ?? 0,
    step: 0.1,
    toPatch: (value) => nestedPatch(['lens', 'centre_mm'], centre_mm.with(axis, Number(value))),
  }));
}
