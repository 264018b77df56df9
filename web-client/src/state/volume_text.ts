// What is known of a volume, in words.
import type { VolumeEntry, VolumeSummary } from '../protocol/messages.ts';
import { words } from '../words/words.ts';

type Facts = Pick<VolumeEntry, 'modality' | 'size_voxels' | 'spacing_mm'>;

/** Three digits that count, as the page's language writes them. */
function shortNumber(value: number): string {
  const short = Number(value.toPrecision(3));
  const [, decimals = ''] = String(short).split('.');
  return words().number(short, decimals.length);
}

/** 'CT · 512×512×275 · 0.781×0.781×1 mm', as far as it is known. */
export function volumeFacts({ modality, size_voxels, spacing_mm }: Facts): string {
  const parts = [
    modality,
    size_voxels?.join('×'),
    spacing_mm && `${spacing_mm.map(shortNumber).join('×')}\u00a0mm`,
  ];
  return parts.filter(Boolean).join(' · ');
}

type Warned = Pick<VolumeEntry, 'id' | 'warnings'>;

/** Each warning of the listing, and of what reading the volume found where it is the open one, once. */
export function volumeWarnings(
  { id, warnings = [] }: Warned,
  open: Pick<VolumeSummary, 'id' | 'warnings'> | undefined,
): string[] {
  return [...new Set([...warnings, ...(open?.id === id ? open.warnings : [])])];
}
