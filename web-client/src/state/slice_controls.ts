// Controls of the slices: the window, and which side is the patient's right.
import { SCENE_FIELDS, type Scene, type VolumeSummary } from '../protocol/messages.ts';
import { CONVENTIONS } from '../preferences/preferences.ts';
import { words } from '../words/words.ts';
import {
  roundStep,
  type BooleanControl,
  type ChoiceControl,
  type NumberControl,
} from './controls.ts';
import { nestedPatch } from './merge_patch.ts';

/**
 * Nothing while the scene leaves the window open. It may lie beyond the volume's values: a lung's in a
 * series of soft tissue.
 */
export function windowControls(scene: Scene, volume: VolumeSummary): readonly NumberControl[] {
  const { centre, width } = scene.slices?.window ?? {};
  if (centre === undefined || width === undefined) return [];
  const [lowest, highest] = volume.value_range;
  const step = roundStep(lowest, highest);
  const { slices: texts, controls } = words();
  const unit = volume.units === 'none' ? '' : volume.units;
  return [
    {
      kind: 'number',
      id: 'window-centre',
      label: texts.window_centre,
      description: controls.description('window.centre'),
      value: centre,
      minimum: lowest,
      maximum: highest,
      accepts: SCENE_FIELDS['window.centre'],
      step,
      unit,
      toPatch: (value) => nestedPatch(['slices', 'window', 'centre'], value),
    },
    {
      kind: 'number',
      id: 'window-width',
      label: texts.window_width,
      description: controls.description('window.width'),
      value: width,
      minimum: step,
      maximum: Math.max(step, highest - lowest),
      accepts: SCENE_FIELDS['window.width'],
      step,
      unit,
      toPatch: (value) => nestedPatch(['slices', 'window', 'width'], value),
    },
  ];
}

/** Its patch is of the preferences, too: `{convention}`. */
export function conventionControl(scene: Scene): ChoiceControl {
  const { convention, convention_hint, conventions } = words().slices;
  return {
    kind: 'choice',
    id: 'slices-convention',
    label: convention,
    description: convention_hint,
    value: scene.slices?.convention ?? 'radiological',
    choices: CONVENTIONS.map((value) => ({ value, label: conventions[value] })),
    toPatch: (value) => ({ convention: value }),
  };
}

export function lensAtCrosshairControl(value: boolean): BooleanControl {
  const { lens_at_crosshair, lens_at_crosshair_hint } = words().slices;
  return {
    kind: 'boolean',
    id: 'lens-at-crosshair',
    label: lens_at_crosshair,
    description: lens_at_crosshair_hint,
    value,
    toPatch: (follows) => ({ lens_at_crosshair: follows }),
  };
}
