// Measuring: the tool in hand, the point that is being placed, and what was measured, by volume.
import type { MeasuredPoint, MeasurementKind } from '../view/measurement.ts';
import type { MeasuredVolumes } from './measured_volumes.ts';
import type { Draft, MeasurementList } from './measurement_list.ts';
import { volumeKey, type VolumeIdentity } from './volume_identity.ts';
import type { Point } from '../view/camera.ts';
import type { ViewName } from './views.ts';

/** The point that would be placed now. */
export interface Candidate {
  readonly view: ViewName;
  /** Device pixels of the picture. */
  readonly position_px: Point;
  /** Nothing where no surface is, or until the server has answered. */
  readonly found: MeasuredPoint | undefined;
  readonly answered: boolean;
  /** Moved there by keys, not by a pointer: it has to be drawn and read out. */
  readonly by_keys: boolean;
}

export interface MeasureState {
  /** Its points so far; nothing while no tool is in hand. */
  readonly draft: Draft | undefined;
  readonly candidate: Candidate | undefined;
  /** By the volume's key: what was measured in one comes back with it, and with no other. */
  readonly by_volume: MeasuredVolumes;
  /** Id of the measurement whose points can be moved. */
  readonly selected: number | undefined;
}

export const NOTHING_MEASURED: MeasureState = {
  draft: undefined,
  candidate: undefined,
  by_volume: new Map(),
  selected: undefined,
};

export const toolInHand = ({ draft }: MeasureState): MeasurementKind | undefined => draft?.kind;

export const measurementsOf = (
  { by_volume }: MeasureState,
  volume: VolumeIdentity | undefined,
): MeasurementList => (volume && by_volume.get(volumeKey(volume))) ?? [];
