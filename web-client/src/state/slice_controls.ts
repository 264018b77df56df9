// Controls of the slices: the window, and which side is the patient's right.
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import { CONVENTIONS } from '../preferences/preferences.ts';
import { words } from '../words/words.ts';
import {
  roundStep,
  type BooleanControl,
  type ChoiceControl,
  type NumberControl,
} from './controls.ts';
import { nestedPatch } from './merge_patch.ts';

/** Nothing while the scene leaves the window open. */
export function windowControls(scene: Scene, volume: VolumeSummary): readonly NumberControl[] {
  const { centre, width } = scene.slices?.window ?? {};
  if (centre === undefined || width === undefined) return [];
  const [lowest, highest] = volume.value_range;
  const step = roundStep(lowest, highest);
  const texts = words().slices;
  const unit = volume.units === 'none' ? '' : volume.units;
  return [
    {
      kind: 'number',
      id: 'window-centre',
      label: texts.window_centre,
      description: texts.window_centre_hint,
      value: centre,
      minimum: lowest,
      maximum: highest,
      step,
      unit,
      toPatch: (value) => nestedPatch(['slices', 'window', 'centre'], value),
    },
    {
      kind: 'number',
      id: 'window-width',
      label: texts.window_width,
      description: texts.window_width_hint,
      value: width,
      minimum: step,
      maximum: Math.max(step, highest - lowest),
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
