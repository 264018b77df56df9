// The window: which values a slice draws from black to white.
import type { VolumeSummary } from '../protocol/messages.ts';

export interface ValueWindow {
  /** Drawn middle grey; the volume's units. */
  readonly centre: number;
  /** From black to white; same units. */
  readonly width: number;
}

export const WINDOW_PRESET_NAMES = ['soft_tissue', 'lung', 'bone', 'brain', 'liver'] as const;
export type WindowPresetName = (typeof WINDOW_PRESET_NAMES)[number];

/** Hounsfield units, as they are used at workstations. */
const PRESETS: Readonly<Record<WindowPresetName, ValueWindow>> = {
  soft_tissue: { centre: 40, width: 400 },
  lung: { centre: -600, width: 1500 },
  bone: { centre: 400, width: 1800 },
  brain: { centre: 40, width: 80 },
  liver: { centre: 60, width: 160 },
};

export const windowPreset = (name: WindowPresetName): ValueWindow => PRESETS[name];

/** The presets mean something only for values in Hounsfield units. */
export const hasPresets = (volume: Pick<VolumeSummary, 'units'> | undefined): boolean =>
  volume?.units === 'HU';

/** Of the width, or where that is small, of the volume's range: what a CSS pixel changes. */
const SHARE_OF_WIDTH = 1 / 256;
const SHARE_OF_RANGE = 1 / 8192;
const SMALLEST_SHARE_OF_RANGE = 1e-5;

/** To the right wider, down darker. */
export function draggedWindow(
  { centre, width }: ValueWindow,
  dx_css_px: number,
  dy_css_px: number,
  { value_range: [lowest, highest] }: Pick<VolumeSummary, 'value_range'>,
): ValueWindow {
  const range = Math.max(highest - lowest, Number.EPSILON);
  const per_px = Math.max(width * SHARE_OF_WIDTH, range * SHARE_OF_RANGE);
  return {
    centre: centre + dy_css_px * per_px,
    width: Math.max(range * SMALLEST_SHARE_OF_RANGE, width + dx_css_px * per_px),
  };
}
