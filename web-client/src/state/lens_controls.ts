// Controls of the lens: what it does, what that has to be told, and where it lies in the patient.
import { SCENE_FIELDS, type Scene, type VolumeSummary } from '../protocol/messages.ts';
import type { Control, NumberControl } from './controls.ts';
import { booleanField, numberField } from './field_controls.ts';
import { nestedPatch } from './merge_patch.ts';
import { sceneChoiceControl } from './scene_controls.ts';
import { words } from '../words/words.ts';

export const lensMode = ({ lens }: Scene) => lens?.mode ?? SCENE_FIELDS['lens.mode'].default;

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
  return numberField({ field: `lens.${name}`, path: ['lens', name], label }, scene);
}

function magicControls(scene: Scene): readonly Control[] {
  const { strength, soft_rim, fade_everywhere: label } = words().controls;
  return [
    shareControl('strength', strength, scene),
    shareControl('softness', soft_rim, scene),
    booleanField({ field: 'lens.strict', path: ['lens', 'strict'], label }, scene),
  ];
}

function cutawayControls(scene: Scene): readonly Control[] {
  const { cut_surfaces, opening, funnel_angle: label } = words().controls;
  const opens = sceneChoiceControl('lens.opening', opening, scene);
  const path = ['lens', 'funnel_degrees'];
  const funnel = numberField({ field: 'lens.funnel_degrees', path, label }, scene);
  const cap = sceneChoiceControl('lens.cap', cut_surfaces, scene);
  return opens.value === 'funnel' ? [opens, funnel, cap] : [opens, cap];
}

/** What the lens' present mode reads. */
export function lensModeControls(scene: Scene): readonly Control[] {
  switch (lensMode(scene)) {
    case 'cutaway':
      return cutawayControls(scene);
    case 'magic':
      return magicControls(scene);
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
