// Bands of Hounsfield values by the tissue that has them. Only CT has Hounsfield values, so other
// modalities get none.
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import type { BranchName } from './filter_model.ts';
import { nestedPatch, type JsonObject } from './merge_patch.ts';

export const TISSUES = ['skin', 'muscle', 'contrast_vessels', 'bone'] as const;
export type Tissue = (typeof TISSUES)[number];

interface Band {
  readonly lower: number;
  /** Nothing where the band is open. */
  readonly upper?: number;
}

/**
 * HU. Skin and bone are the iso-values that the server chooses for CT. Muscle: the range by which
 * body composition is measured. Vessels: blood with contrast medium, above soft tissue and
 * below dense bone.
 */
const BANDS: Readonly<Record<Tissue, Band>> = {
  skin: { lower: -200 },
  muscle: { lower: -29, upper: 150 },
  contrast_vessels: { lower: 150, upper: 450 },
  bone: { lower: 250 },
};

export interface TissuePreset {
  readonly tissue: Tissue;
  readonly lower: number;
  readonly upper: number | undefined;
  /** Whether the branch draws this band now. */
  readonly chosen: boolean;
  /** False where no value of the volume lies in the band. */
  readonly occurs: boolean;
  readonly patch: JsonObject;
}

export function tissuePresets(
  branch: BranchName,
  scene: Scene,
  { modality, units, value_range: [smallest, largest] }: VolumeSummary,
): readonly TissuePreset[] {
  if (modality !== 'CT' || units !== 'HU') return [];
  const { iso_value, upper_value } = scene[branch]?.surface ?? {};
  return TISSUES.map((tissue) => {
    const { lower, upper } = BANDS[tissue];
    return {
      tissue,
      lower,
      upper,
      chosen: iso_value === lower && upper_value === upper,
      occurs: lower < largest && (upper ?? Infinity) > smallest,
      patch: nestedPatch([branch, 'surface'], { iso_value: lower, upper_value: upper ?? null }),
    };
  });
}
