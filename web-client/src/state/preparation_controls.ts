// What the volume goes through before it is drawn.
import type { Scene } from '../protocol/messages.ts';
import { words } from '../words/words.ts';
import type { BooleanControl, NumberControl } from './controls.ts';
import { booleanField, numberField, withTravel } from './field_controls.ts';
import type { BranchName } from './filter_model.ts';

/** Larger parts are no specks. */
const LARGEST_SPECK_ML = 10;

function preparationSwitch(name: 'hide_couch' | 'fill_context', scene: Scene): BooleanControl {
  const label = words().controls[name];
  return booleanField({ field: `preparation.${name}`, path: ['preparation', name], label }, scene);
}

/** Of the context's section. */
export const preparationSwitches = (scene: Scene): readonly BooleanControl[] => [
  preparationSwitch('hide_couch', scene),
  preparationSwitch('fill_context', scene),
];

/** Nothing where the band has an upper end: the server then leaves no part out. */
export function islandsControls(branch: BranchName, scene: Scene): readonly NumberControl[] {
  if (scene[branch]?.surface?.upper_value !== undefined) return [];
  const name = `${branch}_islands_ml` as const;
  const place = {
    field: `preparation.${name}`,
    path: ['preparation', name],
    label: words().controls.islands,
  } as const;
  return [withTravel(numberField(place, scene), 0, LARGEST_SPECK_ML)];
}
