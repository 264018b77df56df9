// What was measured, by volume, and what a user can do with it, each of which can be undone. It lives
// in the browser's storage.
import {
  freeName,
  identified,
  renamed,
  without,
  withReturned,
  type Draft,
  type MeasurementList,
} from '../state/measurement_list.ts';
import { fileName } from '../state/file_name.ts';
import { measurementsCsv, measurementsJson } from '../state/measurement_export.ts';
import {
  adopted,
  changedKeys,
  isMistakable,
  withList,
  withListsOf,
  type MeasuredVolumes,
} from '../state/measured_volumes.ts';
import { measurementsOf, NOTHING_MEASURED } from '../state/measure_state.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { isSameVolume, volumeKey } from '../state/volume_identity.ts';
import { words } from '../words/words.ts';
import type { Commands } from './commands.ts';
import { MeasurementStore, type KeptMeasurements } from './measurement_store.ts';
import type { Toasts } from './toasts.ts';
import type { PageParts } from './session_parts.ts';

export class Measured {
  private last_id = 0;
  private readonly storage: MeasurementStore;
  /** What the storage has. */
  private kept = NOTHING_MEASURED.by_volume;
  /** Until the storage has refused to keep them; then they live in the page alone. */
  private works = true;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly commands: Commands,
    private readonly toasts: Toasts,
    private readonly page: PageParts,
  ) {
    this.storage = new MeasurementStore(page.openStorage);
    store.subscribe((state, before) => {
      this.keep(state.measure.by_volume);
      if (!isSameVolume(state.volume, before.volume)) this.opened();
    });
  }

  /** What was measured on the visit before. Says so where it cannot be read. */
  restore(): void {
    this.storage.watch(this.page.watchStorage, () => this.takeOver());
    const kept = this.storage.load();
    const { unreadable, unreadable_detail } = words().measure;
    if (!kept) return this.toasts.problem(unreadable, unreadable_detail);
    this.kept = this.withIds(kept);
    this.update(this.kept);
    this.opened();
  }

  /** Another page has saved: the next save of this one would destroy what it does not know. */
  private takeOver(): void {
    const kept = this.works ? this.storage.load() : undefined;
    if (!kept) return;
    this.kept = this.withIds(kept);
    const { kept: saved } = this;
    const changed = changedKeys(this.store.state.measure.by_volume, saved);
    if (changed.length > 0)
      this.commands.rewriteMeasured((all) => withListsOf(all, saved, changed));
  }

  /** What the page has already stays the very same. */
  private withIds(kept: KeptMeasurements): MeasuredVolumes {
    const { by_volume } = this.store.state.measure;
    const lists = [...kept].map(
      ([key, list]) =>
        [key, identified(list, by_volume.get(key) ?? [], () => this.nextId())] as const,
    );
    return new Map(lists);
  }

  /** What was kept by its id alone is taken over where it may be; what belongs to another, is said. */
  private opened(): void {
    const { volume, measure } = this.store.state;
    if (!volume) return;
    const { elsewhere, elsewhere_detail } = words().measure;
    if (adopted(measure.by_volume, volume))
      this.commands.rewriteMeasured((all) => adopted(all, volume) ?? all);
    else if (isMistakable(measure.by_volume, volume)) this.toasts.note(elsewhere, elsewhere_detail);
  }

  /** Of the volume that is open. */
  get list(): MeasurementList {
    const { measure, volume } = this.store.state;
    return measurementsOf(measure, volume);
  }

  /** `draft` is whole. Returns the measurement's id. */
  add({ kind, points }: Draft): number {
    const id = this.nextId();
    const name = freeName(words().measure.kinds[kind], this.list);
    this.changeAtOnce((list) => [...list, { id, kind, points, name }]);
    return id;
  }

  rename(id: number, name: string): void {
    this.changeAtOnce((list) => renamed(list, id, name));
  }

  remove(id: number): void {
    const name = this.list.find((one) => one.id === id)?.name ?? '';
    this.removing(words().measure.removed(name), (list) => without(list, id));
  }

  removeAll(): void {
    this.removing(words().measure.all_removed, () => []);
  }

  exportAs(format: 'json' | 'csv', notice: string): void {
    const { volume } = this.store.state;
    if (!volume) return;
    const { list } = this;
    const [text, type] =
      format === 'json'
        ? [measurementsJson(list, volume, notice), 'application/json']
        : [measurementsCsv(list, volume, notice), 'text/csv;charset=utf-8'];
    const name = fileName(words().measure.file(volume.title), format);
    this.page.saveFile(name, new Blob([text], { type }));
  }

  /** Of the volume that is open; with what follows without a pause it is one step. */
  change(change: (list: MeasurementList) => MeasurementList): void {
    this.commands.step();
    this.apply(change);
  }

  private changeAtOnce(change: (list: MeasurementList) => MeasurementList): void {
    this.commands.stepAtOnce();
    this.apply(change);
  }

  private apply(change: (list: MeasurementList) => MeasurementList): void {
    const { volume } = this.store.state;
    if (volume) this.setList(volumeKey(volume), change(this.list));
  }

  /** Says so, with a button that takes it back, also once another volume is open. */
  private removing(said: string, change: (list: MeasurementList) => MeasurementList): void {
    const { volume } = this.store.state;
    if (!volume) return;
    const before = this.list;
    this.changeAtOnce(change);
    const takeBack = (): void => {
      this.commands.stepAtOnce();
      const now = measurementsOf(this.store.state.measure, volume);
      this.setList(volumeKey(volume), withReturned(now, before));
    };
    this.toasts.note(said, '', { label: words().page.bar.undo, run: takeBack });
  }

  private setList(key: string, list: MeasurementList): void {
    this.update(withList(this.store.state.measure.by_volume, key, list));
  }

  /** Whoever has changed it: a tool, or a step back. */
  private keep(by_volume: MeasuredVolumes): void {
    const changed = changedKeys(this.kept, by_volume);
    this.kept = by_volume;
    for (const key of changed) this.save(key, by_volume.get(key) ?? []);
  }

  private save(key: string, list: MeasurementList): void {
    if (!this.works) return;
    this.works = this.storage.save(key, list);
    const { not_kept, not_kept_detail } = words().measure;
    if (!this.works) this.toasts.problem(not_kept, not_kept_detail);
  }

  private nextId(): number {
    this.last_id += 1;
    return this.last_id;
  }

  private update(by_volume: MeasuredVolumes): void {
    this.store.update({ measure: { ...this.store.state.measure, by_volume } });
  }
}
