// What is known of a volume, in words.
import type { VolumeEntry, VolumeSummary } from '../protocol/messages.ts';

type Facts = Pick<VolumeEntry, 'modality' | 'size_voxels' | 'spacing_mm'>;

const shortNumber = (value: number): string => String(Number(value.toPrecision(3)));

/** 'CT · 512×512×275 · 0.781×0.781×1 mm', as far as it is known. */
export function volumeFacts({ modality, size_voxels, spacing_mm }: Facts): string {
  const parts = [
    modality,
    size_voxels?.join('×'),
    spacing_mm && `${spacing_mm.map(shortNumber).join('×')} mm`,
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
