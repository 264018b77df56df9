// Undo and redo: the scene before each step, and what was measured. A step is a gesture: all that
// changes while a pointer is held, or without a pause.
import type { Scene } from '../protocol/messages.ts';
import { changedKeys, type MeasuredVolumes } from '../state/measured_volumes.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { sameScene, scenePatch } from '../state/scene_diff.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { SceneLink } from './scene_link.ts';

const PAUSE_MS = 400;
const MOST_STEPS = 100;

/** All that a user makes. */
interface Work {
  readonly scene: Scene;
  readonly by_volume: MeasuredVolumes;
}

function differs(one: Work, other: Work): boolean {
  const [scene, other_scene] = [one.scene as JsonObject, other.scene as JsonObject];
  return changedKeys(one.by_volume, other.by_volume).length > 0 || !sameScene(scene, other_scene);
}

export class History {
  private past: readonly Work[] = [];
  private future: readonly Work[] = [];
  private step_is_open = false;
  private pause: ReturnType<typeof setTimeout> | undefined;
  /** Was asked for, with another volume, and is not there yet. */
  private awaited: Scene | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly link: SceneLink,
  ) {
    store.subscribe((state, before) => this.followPointer(state, before));
    store.subscribe((state, before) => {
      const over = state.loading === undefined && before.loading !== undefined;
      if (over || state.scene?.volume !== before.scene?.volume) this.awaited = undefined;
    });
  }

  /** Before each change that a user makes; `scene` is what it changes. */
  changing(scene: Scene | undefined = this.store.state.scene): void {
    if (!this.step_is_open && scene) {
      this.past = [...this.past, this.workOn(scene)].slice(-MOST_STEPS);
      this.future = [];
      this.step_is_open = true;
      this.publish();
    }
    this.closeAfterPause();
  }

  /** Before a change that is a step of its own. */
  changingAtOnce(scene?: Scene): void {
    this.closeStep();
    this.changing(scene);
    this.closeStep();
  }

  undo(): void {
    this.closeStep();
    const { current } = this;
    const target = current && this.past.findLast((work) => differs(work, current));
    if (!target) return;
    this.past = this.past.slice(0, this.past.lastIndexOf(target));
    this.future = [...this.future, current];
    this.restore(target, current);
  }

  redo(): void {
    this.closeStep();
    const { current } = this;
    const target = current && this.future.findLast((work) => differs(work, current));
    if (!target) return;
    this.future = this.future.slice(0, this.future.lastIndexOf(target));
    this.past = [...this.past, current];
    this.restore(target, current);
  }

  /** What was measured changes in the past and in the future too: no step takes it back. */
  rewriteMeasured(rewrite: (all: MeasuredVolumes) => MeasuredVolumes): void {
    const rewritten = (work: Work): Work => ({ ...work, by_volume: rewrite(work.by_volume) });
    this.past = this.past.map(rewritten);
    this.future = this.future.map(rewritten);
    const { measure } = this.store.state;
    this.store.update({ measure: { ...measure, by_volume: rewrite(measure.by_volume) } });
  }

  /** The last scene of the past, of this volume, of which `wanted` holds. */
  last(wanted: (scene: Scene) => boolean): Scene | undefined {
    const volume = this.store.state.scene?.volume;
    return this.past.findLast(({ scene }) => scene.volume === volume && wanted(scene))?.scene;
  }

  private get current(): Work | undefined {
    const scene = this.awaited ?? this.store.state.scene;
    return scene && this.workOn(scene);
  }

  private workOn(scene: Scene): Work {
    return { scene, by_volume: this.store.state.measure.by_volume };
  }

  private restore({ scene, by_volume }: Work, current: Work): void {
    const { measure } = this.store.state;
    if (changedKeys(by_volume, current.by_volume).length > 0)
      this.store.update({ measure: { ...measure, by_volume } });
    this.restoreScene(scene, current.scene);
    this.publish();
  }

  /** Another volume comes with its whole scene, or the server would choose anew what is left out. */
  private restoreScene(target: Scene, current: Scene): void {
    const [from, to] = [current as JsonObject, target as JsonObject];
    if (sameScene(from, to)) return;
    if (target.volume === current.volume) this.link.sendPatch(scenePatch(from, to));
    else {
      this.awaited = target;
      this.link.replace(to);
    }
  }

  private followPointer(state: ViewerState, before: ViewerState): void {
    if (state.pointer_held && !before.pointer_held) this.closeStep();
    const released = before.pointer_held && !state.pointer_held;
    const follows_no_more = before.lens_follows && !state.lens_follows;
    if (released || follows_no_more) this.closeAfterPause();
  }

  private closeAfterPause(): void {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      const { pointer_held, lens_follows } = this.store.state;
      if (!pointer_held && !lens_follows) this.closeStep();
    }, PAUSE_MS);
  }

  private closeStep(): void {
    clearTimeout(this.pause);
    this.step_is_open = false;
  }

  private publish(): void {
    this.store.update({ can_undo: this.past.length > 0, can_redo: this.future.length > 0 });
  }
}
