// Where the browser keeps what was measured, by the volumes' keys; once it was by their ids. Several
// pages share the storage, so each change begins with what is there.
import {
  parsedJson,
  storedText,
  storeText,
  type OpenStorage,
  type WatchStorage,
} from '../preferences/browser_storage.ts';
import {
  MEASUREMENT_KINDS,
  POINT_COUNTS,
  type MeasuredPoint,
  type Measurement,
} from '../view/measurement.ts';
import { isObject } from '../state/merge_patch.ts';
import type { Vector3 } from '../view/vector.ts';

/** On the page it has an id besides, which is the page's own. */
export type KeptMeasurement = Omit<Measurement, 'id'>;
export type KeptMeasurements = ReadonlyMap<string, readonly KeptMeasurement[]>;

const KEY = 'cutaway.measurements';
/** What cannot be read is kept there, so that saving anew does not destroy it. */
const UNREADABLE_KEY = 'cutaway.measurements.unreadable';
const VERSION = 1;
/** Of the volumes that were measured in last; the storage is small. */
const MOST_VOLUMES = 200;

export class MeasurementStore {
  constructor(private readonly open: OpenStorage) {}

  /** `changed` hears that another page has saved. */
  watch(watchStorage: WatchStorage, changed: () => void): void {
    watchStorage((key) => {
      if (key === KEY) changed();
    });
  }

  /** Nothing where what is kept there cannot be read: it is of another version, or damaged. */
  load(): KeptMeasurements | undefined {
    const text = storedText(this.open, KEY);
    if (text === null) return new Map();
    const kept = keptFrom(text);
    if (!kept) storeText(this.open, UNREADABLE_KEY, text);
    return kept;
  }

  /** All of one volume; none forget it. Whether they are kept. */
  save(volume: string, list: readonly Measurement[]): boolean {
    const volumes = new Map(this.load());
    volumes.delete(volume);
    if (list.length > 0)
      volumes.set(
        volume,
        list.map(({ id: _id, ...one }) => one),
      );
    const newest = [...volumes].slice(-MOST_VOLUMES);
    return storeText(this.open, KEY, JSON.stringify({ version: VERSION, volumes: newest }));
  }
}

function keptFrom(text: string): KeptMeasurements | undefined {
  const document = parsedJson(text);
  if (!isObject(document) || document['version'] !== VERSION) return undefined;
  const volumes: unknown = document['volumes'];
  if (!Array.isArray(volumes)) return undefined;
  const entries = volumes.map(volumeFrom);
  return entries.every((entry) => entry !== undefined) ? new Map(entries) : undefined;
}

function volumeFrom(entry: unknown): [string, readonly KeptMeasurement[]] | undefined {
  if (!Array.isArray(entry)) return undefined;
  const [volume, list] = entry as [unknown, unknown];
  if (typeof volume !== 'string' || !Array.isArray(list)) return undefined;
  const read = list.map(measurementFrom);
  return read.every((one) => one !== undefined) ? [volume, read] : undefined;
}

function measurementFrom(one: unknown): KeptMeasurement | undefined {
  if (!isObject(one) || typeof one['name'] !== 'string') return undefined;
  const kind = MEASUREMENT_KINDS.find((known) => known === one['kind']);
  const listed: unknown = one['points'];
  if (!kind || !Array.isArray(listed) || listed.length !== POINT_COUNTS[kind]) return undefined;
  const points = listed.map(pointFrom);
  if (!points.every((point) => point !== undefined)) return undefined;
  return { kind, name: one['name'], points };
}

function pointFrom(point: unknown): MeasuredPoint | undefined {
  if (!isObject(point) || typeof point['value'] !== 'number') return undefined;
  const place: unknown = point['position_mm'];
  const numbers = Array.isArray(place) && place.every((part) => Number.isFinite(part));
  if (!numbers || place.length !== 3) return undefined;
  return { position_mm: place as unknown as Vector3, value: point['value'] };
}
