// Undo and redo: the scenes before each step. A step is a gesture: all that changes while a pointer
// is held, or without a pause.
import type { Scene } from '../protocol/messages.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { sameScene, scenePatch } from '../state/scene_diff.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { SceneLink } from './scene_link.ts';

const PAUSE_MS = 400;
const MOST_STEPS = 100;

export class History {
  private past: readonly Scene[] = [];
  private future: readonly Scene[] = [];
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
      this.past = [...this.past, scene].slice(-MOST_STEPS);
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
    const { state } = this.store;
    const current = this.awaited ?? state.scene;
    const target = this.past.findLast((scene) => this.differs(scene, current));
    if (!current || !target) return;
    this.past = this.past.slice(0, this.past.lastIndexOf(target));
    this.future = [...this.future, current];
    this.restore(target, current);
  }

  redo(): void {
    this.closeStep();
    const current = this.awaited ?? this.store.state.scene;
    const target = this.future.findLast((scene) => this.differs(scene, current));
    if (!current || !target) return;
    this.future = this.future.slice(0, this.future.lastIndexOf(target));
    this.past = [...this.past, current];
    this.restore(target, current);
  }

  /** The last scene of the past, of this volume, of which `wanted` holds. */
  last(wanted: (scene: Scene) => boolean): Scene | undefined {
    const volume = this.store.state.scene?.volume;
    return this.past.findLast((scene) => scene.volume === volume && wanted(scene));
  }

  private differs(scene: Scene, current: Scene | undefined): boolean {
    return current !== undefined && !sameScene(scene as JsonObject, current as JsonObject);
  }

  /** Another volume comes with its whole scene, or the server would choose anew what is left out. */
  private restore(target: Scene, current: Scene): void {
    const [from, to] = [current as JsonObject, target as JsonObject];
    if (target.volume === current.volume) this.link.sendPatch(scenePatch(from, to));
    else {
      this.awaited = target;
      this.link.replace(to);
    }
    this.publish();
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
