// The picture in its previous look, for as long as a key or a button is held.
import type { Scene } from '../protocol/messages.ts';
import { sameLook, withLook } from '../state/look.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { scenePatch } from '../state/scene_diff.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { History } from './history.ts';
import type { SceneLink } from './scene_link.ts';

export class Comparison {
  /** Of the look that comes back. */
  private present: Scene | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly link: SceneLink,
    private readonly history: History,
  ) {
    store.subscribe((state, before) => {
      if (state.scene?.volume !== before.scene?.volume) this.forget();
    });
  }

  /** Whether there is another look to compare with. */
  begin(): boolean {
    const { scene } = this.store.state;
    if (this.present || !scene) return true;
    const previous = this.history.last((past) => !sameLook(past, scene));
    if (!previous) return false;
    this.present = scene;
    this.show(scene, withLook(scene, previous));
    this.store.update({ comparing: true });
    return true;
  }

  end(): void {
    const { scene } = this.store.state;
    if (!this.present || !scene) return;
    this.show(scene, this.withoutIt(scene));
    this.present = undefined;
    this.store.update({ comparing: false });
  }

  /** `scene` as it is when nothing is compared. */
  withoutIt(scene: Scene): Scene {
    return this.present ? withLook(scene, this.present) : scene;
  }

  /** Another volume has come in between. */
  private forget(): void {
    this.present = undefined;
    this.store.update({ comparing: false });
  }

  private show(from: Scene, to: Scene): void {
    this.link.sendPatch(scenePatch(from as JsonObject, to as JsonObject));
  }
}
