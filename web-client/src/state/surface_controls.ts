// Controls of a branch's surface: the band of values that is drawn, and how much of the light it
// takes. Both ends have the volume's own range, so that sliders and histogram lie one under another.
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import { roundStep, type BooleanControl, type NumberControl } from './controls.ts';
import { numberField } from './field_controls.ts';
import type { BranchName } from './filter_model.ts';
import { nestedPatch } from './merge_patch.ts';
import { words } from '../words/words.ts';

export interface BandModel {
  readonly lower: NumberControl;
  readonly has_upper: BooleanControl;
  /** Nothing where the band has no upper end. */
  readonly upper: NumberControl | undefined;
  readonly opacity: NumberControl;
}

const defaultIsoValue = (branch: BranchName, volume: VolumeSummary): number =>
  branch === 'focus' ? volume.inner_iso_value : volume.outer_iso_value;

function endControl(
  branch: BranchName,
  field: 'iso_value' | 'upper_value',
  value: number,
  volume: VolumeSummary,
): Omit<NumberControl, 'label' | 'toPatch'> {
  const [minimum, maximum] = volume.value_range;
  return {
    kind: 'number',
    id: `${branch}-${field.replace('_', '-')}`,
    description: words().controls.description(`surface.${field}`),
    value,
    minimum,
    maximum,
    step: roundStep(minimum, maximum),
    unit: volume.units === 'none' ? '' : volume.units,
  };
}

function opacityControl(branch: BranchName, scene: Scene): NumberControl {
  const label = words().controls.opacity;
  const path = [branch, 'surface', 'opacity'];
  return numberField({ field: 'surface.opacity', path, label }, scene);
}

/** Neither end passes the other: the server refuses an empty band. */
export function bandModel(branch: BranchName, scene: Scene, volume: VolumeSummary): BandModel {
  const surface = scene[branch]?.surface;
  const lower_value = surface?.iso_value ?? defaultIsoValue(branch, volume);
  const upper_value = surface?.upper_value;
  const [, largest] = volume.value_range;
  const step = roundStep(...volume.value_range);
  const toLower = (value: number): number => Math.min(value, (upper_value ?? Infinity) - step);
  const middle = Math.round((lower_value + largest) / 2 / step) * step;
  const toUpper = (value: number): number => Math.max(value, lower_value + step);
  const set = (field: string, value: number | null) =>
    nestedPatch([branch, 'surface', field], value);
  return {
    lower: {
      ...endControl(branch, 'iso_value', lower_value, volume),
      label: words().controls.lower_end,
      toPatch: (value) => set('iso_value', toLower(Number(value))),
    },
    has_upper: {
      kind: 'boolean',
      id: `${branch}-has-upper`,
      label: words().controls.upper_end,
      description: words().controls.description('surface.upper_value'),
      value: upper_value !== undefined,
      toPatch: (value) => set('upper_value', value === true ? toUpper(middle) : null),
    },
    upper:
      upper_value === undefined
        ? undefined
        : {
            ...endControl(branch, 'upper_value', upper_value, volume),
            label: words().controls.upper_value,
            toPatch: (value) => set('upper_value', toUpper(Number(value))),
          },
    opacity: opacityControl(branch, scene),
  };
}
