// Which volume something belongs to. An id is a path, where another day another patient may lie: the
// grid and the range of its values tell one from the other.
import type { VolumeSummary } from '../protocol/messages.ts';
import type { Vector3 } from '../view/vector.ts';

export type VolumeIdentity = Pick<
  VolumeSummary,
  'id' | 'size_voxels' | 'spacing_mm' | 'origin_mm' | 'axes' | 'value_range'
>;

/** What single precision keeps: how a number is computed does not make another volume. */
const DIGITS = 6;

/** Text that is equal for the same volume alone. */
export function volumeKey({ id, ...volume }: VolumeIdentity): string {
  const { size_voxels, spacing_mm, origin_mm, axes, value_range } = volume;
  const numbers = [size_voxels, spacing_mm, origin_mm, ...axes, value_range].flat();
  return [id, ...numbers.map((number) => Number(number.toPrecision(DIGITS)))].join('\n');
}

/** Whether it is the key of a volume of that id, or, of older storage, the id alone. */
export const isKeyOf = (key: string, id: string): boolean =>
  key === id || key.startsWith(`${id}\n`);

export const isSameVolume = (
  one: VolumeIdentity | undefined,
  other: VolumeIdentity | undefined,
): boolean => one === other || (!!one && !!other && volumeKey(one) === volumeKey(other));

type Bounds = Pick<VolumeSummary, 'bounds_minimum_mm' | 'bounds_maximum_mm' | 'spacing_mm'>;

/** Bounds are of the voxels' centres; half a voxel lies beyond them. */
export function isWithin(position_mm: Vector3, volume: Bounds): boolean {
  const beyond_mm = Math.max(...volume.spacing_mm) / 2;
  const [lowest, highest] = [volume.bounds_minimum_mm, volume.bounds_maximum_mm];
  return position_mm.every(
    (place, axis) =>
      place >= (lowest[axis] ?? place) - beyond_mm && place <= (highest[axis] ?? place) + beyond_mm,
  );
}
