// Controls of the form that a branch's surface shows to the light, and of the light that reaches it.
import { SCENE_FIELDS, type Scene, type VolumeSummary } from '../protocol/messages.ts';
import { words } from '../words/words.ts';
import type { ChoiceControl, Control, NumberControl } from './controls.ts';
import { choiceField, colourField, numberField, withTravel } from './field_controls.ts';
import type { BranchName } from './filter_model.ts';
import { nestedPatch, type Json, type JsonObject } from './merge_patch.ts';
import type { ControlLevels } from './module_model.ts';
import { islandsControls } from './preparation_controls.ts';

type Smoothing = 'off' | 'auto' | 'mm';

const SMOOTHINGS: readonly Smoothing[] = ['off', 'auto', 'mm'];
const LEAST_SMOOTHING_MM = SCENE_FIELDS['normals.scale_mm'].step;
const MOST_SMOOTHING_MM = 10;

/** Of this the server draws nothing where a surface lets light through, of either branch. */
export const isTranslucent = ({ focus, context }: Scene): boolean =>
  [focus, context].some((branch) => (branch?.surface?.opacity ?? 1) < 1);

function smoothingOf(branch: BranchName, scene: Scene): Smoothing {
  const { scale, scale_mm = 0 } = scene[branch]?.normals ?? {};
  if (scale === 'auto') return 'auto';
  return scale_mm > 0 ? 'mm' : 'off';
}

/** One and a half voxels, the widest way: enough to be seen, too little to lose the form. */
function firstSmoothing_mm({ spacing_mm }: VolumeSummary): number {
  const wide_mm = Math.min(MOST_SMOOTHING_MM, 1.5 * Math.max(...spacing_mm));
  return Math.max(LEAST_SMOOTHING_MM, Number(wide_mm.toFixed(1)));
}

function smoothingChoice(branch: BranchName, scene: Scene, volume: VolumeSummary): ChoiceControl {
  const { smoothing, smoothing_hint, smoothings } = words().controls;
  const normals: Readonly<Record<Smoothing, JsonObject>> = {
    off: { scale: 'fixed', scale_mm: 0 },
    auto: { scale: 'auto' },
    mm: { scale: 'fixed', scale_mm: firstSmoothing_mm(volume) },
  };
  const toPatch = (value: Json): JsonObject =>
    nestedPatch([branch, 'normals'], normals[SMOOTHINGS.find((one) => one === value) ?? 'off']);
  return {
    kind: 'choice',
    id: `${branch}-smoothing`,
    label: smoothing,
    description: smoothing_hint,
    value: smoothingOf(branch, scene),
    choices: SMOOTHINGS.map((value) => ({ value, label: smoothings[value] })),
    toPatch,
  };
}

/** Never 0, where the slider would go from under the hand that moves it. */
function smoothingWidth(branch: BranchName, scene: Scene): NumberControl {
  const label = words().controls.smoothing_width;
  const path = [branch, 'normals', 'scale_mm'];
  const control = numberField({ field: 'normals.scale_mm', path, label }, scene);
  return withTravel(control, LEAST_SMOOTHING_MM, MOST_SMOOTHING_MM);
}

function occlusionDetails(branch: BranchName, scene: Scene): readonly Control[] {
  const { occlusion_near, occlusion_colour } = words().controls;
  const at = (name: string): string[] => [branch, 'occlusion', name];
  const near = {
    field: 'occlusion.near_share',
    path: at('near_share'),
    label: occlusion_near,
  } as const;
  const colour = {
    field: 'occlusion.colour',
    path: at('colour'),
    label: occlusion_colour,
  } as const;
  return [numberField(near, scene), colourField(colour, scene)];
}

function shadowSoftness(branch: BranchName, scene: Scene): Control {
  const label = words().controls.shadow_softness;
  const path = [branch, 'shadow', 'softness_degrees'];
  return numberField({ field: 'shadow.softness_degrees', path, label }, scene);
}

/** What does nothing now is left out. */
export function lightOnSurface(
  branch: BranchName,
  scene: Scene,
  volume: VolumeSummary,
): ControlLevels {
  const { occlusion, shadow, reconstruction } = words().controls;
  const strength = (name: 'occlusion' | 'shadow', label: string): NumberControl =>
    numberField({ field: `${name}.strength`, path: [branch, name, 'strength'], label }, scene);
  const [dark, cast] = [strength('occlusion', occlusion), strength('shadow', shadow)];
  const voxels = {
    field: 'normals.reconstruction',
    path: [branch, 'normals', 'reconstruction'],
    label: reconstruction,
  } as const;
  const is_wide = smoothingOf(branch, scene) === 'mm';
  return {
    ramp: undefined,
    basic: [
      smoothingChoice(branch, scene, volume),
      ...(is_wide ? [smoothingWidth(branch, scene)] : []),
      dark,
      cast,
    ],
    advanced: [
      choiceField(voxels, scene),
      ...(dark.value > 0 ? occlusionDetails(branch, scene) : []),
      ...(cast.value > 0 ? [shadowSoftness(branch, scene)] : []),
      ...islandsControls(branch, scene),
    ],
  };
}
