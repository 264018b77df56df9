// Finding volumes in a long list.
import type { VolumeEntry } from '../protocol/messages.ts';

export interface VolumeFilter {
  /** Words, all of which occur in what is known of the volume. */
  readonly text: string;
  /** Empty: any. */
  readonly modality: string;
}

export const EVERY_VOLUME: VolumeFilter = { text: '', modality: '' };

/** 'Schädel' is found by 'schadel'. */
const plain = (text: string): string =>
  text.normalize('NFD').replaceAll(/\p{M}/gu, '').replaceAll('×', 'x').toLowerCase();

export function matchingVolumes(
  volumes: readonly VolumeEntry[],
  { text, modality }: VolumeFilter,
): readonly VolumeEntry[] {
  const words = plain(text).split(/\s+/).filter(Boolean);
  return volumes.filter((volume) => {
    const { id, title, format, size_voxels } = volume;
    const known = plain([id, title, format, volume.modality, size_voxels?.join('×')].join(' '));
    const of_modality = !modality || volume.modality === modality;
    return of_modality && words.every((word) => known.includes(word));
  });
}

/** Those that occur, in alphabetical order. */
export const modalitiesOf = (volumes: readonly VolumeEntry[]): readonly string[] =>
  [...new Set(volumes.map(({ modality }) => modality).filter(Boolean))].sort();
