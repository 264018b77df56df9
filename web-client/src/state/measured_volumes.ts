// The measurements of all volumes, by the volumes' keys; every change is a new map.
import type { VolumeSummary } from '../protocol/messages.ts';
import type { MeasurementList } from './measurement_list.ts';
import { isKeyOf, isWithin, volumeKey } from './volume_identity.ts';

export type MeasuredVolumes = ReadonlyMap<string, MeasurementList>;

/** No measurements are the same as none yet. */
export function withList(
  volumes: MeasuredVolumes,
  key: string,
  list: MeasurementList,
): MeasuredVolumes {
  const changed = new Map(volumes);
  if (list.length > 0) changed.set(key, list);
  else changed.delete(key);
  return changed;
}

/** Those whose lists are not the very same. */
export function changedKeys(from: MeasuredVolumes, to: MeasuredVolumes): readonly string[] {
  const keys = new Set([...from.keys(), ...to.keys()]);
  return [...keys].filter((key) => from.get(key) !== to.get(key));
}

/** With the lists of `keys` as they are in `other`. */
export const withListsOf = (
  volumes: MeasuredVolumes,
  other: MeasuredVolumes,
  keys: readonly string[],
): MeasuredVolumes => keys.reduce((all, key) => withList(all, key, other.get(key) ?? []), volumes);

/**
 * Measurements that were kept by the id alone become the volume's, where all of them lie within it.
 * Nothing where there are none to take over.
 */
export function adopted(
  volumes: MeasuredVolumes,
  volume: VolumeSummary,
): MeasuredVolumes | undefined {
  const [key, list] = [volumeKey(volume), volumes.get(volume.id)];
  if (!list || volumes.has(key)) return undefined;
  const points = list.flatMap((one) => one.points);
  if (!points.every(({ position_mm }) => isWithin(position_mm, volume))) return undefined;
  return withList(withList(volumes, volume.id, []), key, list);
}

/** Whether there are measurements of another volume of the same name, and none of this one. */
export function isMistakable(volumes: MeasuredVolumes, volume: VolumeSummary): boolean {
  if (volumes.has(volumeKey(volume))) return false;
  return [...volumes.keys()].some((key) => isKeyOf(key, volume.id));
}
