// What each of the session's pictures shows, by the inputs and revisions of their frames.
import type { Scene } from '../protocol/messages.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { sameScene } from '../state/scene_diff.ts';
import { ShownView } from '../state/shown_view.ts';
import { samePicture, slicePicture, type SlicePicture } from '../state/slice_views.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import { SLICE_NAMES, type SliceName } from '../view/slice_geometry.ts';

const inVolume = ({ slices: _, ...scene }: Scene): JsonObject => scene as JsonObject;

const sameInVolume = (a: Scene, b: Scene): boolean => sameScene(inVolume(a), inVolume(b));

export class ShownViews {
  private readonly volume = new ShownView<Scene>(sameInVolume);
  private readonly slices = new Map<SliceName, ShownView<SlicePicture>>();

  /** From now on this slice's frames are followed. */
  opened(name: SliceName, scene: Scene | undefined): void {
    const shown = new ShownView<SlicePicture>(samePicture);
    shown.restart(scene && slicePicture(scene, name));
    this.slices.set(name, shown);
  }

  closed(name: SliceName): void {
    this.slices.delete(name);
  }

  changedByInput(input: number, scene: Scene): void {
    this.volume.changedByInput(input, scene);
    for (const [name, shown] of this.slices) shown.changedByInput(input, slicePicture(scene, name));
  }

  changedByServer(revision: number, scene: Scene): void {
    this.volume.changedByServer(revision, scene);
    for (const [name, shown] of this.slices)
      shown.changedByServer(revision, slicePicture(scene, name));
  }

  /** Whether no other 3-D picture is to come after this one. */
  isVolumeShownBy(frame: ShownFrame): boolean {
    return this.volume.isShownBy(frame);
  }

  volumeShownBy(frame: ShownFrame): Scene | undefined {
    return this.volume.shownBy(frame);
  }

  sliceShownBy(name: SliceName, frame: ShownFrame): SlicePicture | undefined {
    return this.slices.get(name)?.shownBy(frame);
  }

  /** Revisions start anew with each session. */
  restart(scene: Scene | undefined): void {
    this.volume.restart(scene);
    for (const name of SLICE_NAMES) if (this.slices.has(name)) this.opened(name, scene);
  }
}
