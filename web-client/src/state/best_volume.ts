// Which volume is opened where none is named.
import type { VolumeEntry } from '../protocol/messages.ts';

const isFile = ({ format }: VolumeEntry): boolean => format !== 'phantom';

/** The one best worth seeing, files before phantoms; of equals the first. */
export function bestVolume(volumes: readonly VolumeEntry[]): VolumeEntry | undefined {
  const files = volumes.filter(isFile);
  const candidates = files.length > 0 ? files : volumes;
  return candidates.reduce<VolumeEntry | undefined>(
    (best, volume) => (best && (best.worth ?? 0) >= (volume.worth ?? 0) ? best : volume),
    undefined,
  );
}
