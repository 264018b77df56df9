// Sends changes of the scene and keeps the page's scene in step with the server's.
import { Counter, isAfter } from '../protocol/counter.ts';
import {
  SLICES_GROUPS,
  type ErrorMessage,
  type Scene,
  type SceneStateMessage,
} from '../protocol/messages.ts';
import { holdsNull, omit, type JsonObject } from '../state/merge_patch.ts';
import { fieldsOf, leftOpen } from '../state/scene_fields.ts';
import { SceneSync } from '../state/scene_sync.ts';
import type { SlicePicture } from '../state/slice_views.ts';
import type { Store } from '../state/store.ts';
import { awaitsPicture, type ViewerState } from '../state/viewer_state.ts';
import { viewNumber, type ViewName } from '../state/views.ts';
import type { Stream } from '../stream/stream.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import type { Point, Viewport } from '../view/camera.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { Outbox, type OutboxSender } from './outbox.ts';
import { ShownViews } from './shown_views.ts';

const clockMs = (): number => performance.timeOrigin + performance.now();

/** What the server chooses anew when another volume is opened. */
const CHOSEN_FOR_A_VOLUME = leftOpen(fieldsOf('volume'));

/** Whether a change of the scene makes another 3-D picture. */
const changesVolume = (patch: JsonObject): boolean =>
  Object.keys(omit(patch, SLICES_GROUPS)).length > 0;

interface Asked {
  readonly input: number;
  readonly again: () => void;
  readonly opens_volume?: boolean;
}

export class SceneLink implements OutboxSender {
  private readonly inputs = new Counter();
  private readonly sync = new SceneSync();
  private readonly shown_views = new ShownViews();
  private readonly outbox = new Outbox(this);
  /** What the server said last: a picture of that revision shows that input. */
  private last_told: { readonly revision: number; readonly input: number } | undefined;
  /** Of this connection: revisions of the one before count for nothing. */
  private last_shown: ShownFrame | undefined;
  /** The newest input, where its outcome is the server's to say and was not said yet. */
  private asked: Asked | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly stream: Stream,
  ) {}

  /**
   * Shows on the page at once, and goes out with the next animation frame. `patch` holds no nulls.
   */
  change(patch: JsonObject): void {
    this.sync.stage(patch);
    this.outbox.change(patch);
    this.publish();
  }

  dragLens(position_px: Point): void {
    this.outbox.dragLens(position_px);
  }

  /** Sends now what would go out with the next animation frame. */
  flush(): void {
    this.outbox.flush();
  }

  /** Goes out now. Returns its input number. */
  sendPatch(patch: JsonObject): number {
    this.outbox.flush();
    const input = this.sendScene(patch, false);
    if (holdsNull(patch)) this.asked = { input, again: () => this.sendPatch(patch) };
    this.sync.sent(input, patch);
    this.publish();
    this.remember(input);
    return input;
  }

  /**
   * The server has left out some of what was sent, and nobody knows which: the scene goes out as the
   * page has it, and then what was asked last. Not while a volume is opened, for which the server
   * chooses what this would spell out.
   */
  repeat(): void {
    this.outbox.flush();
    const { asked } = this;
    const { scene, volume } = this.store.state;
    if (scene && volume && !asked?.opens_volume)
      this.sendPatch(omit(scene as JsonObject, ['volume']));
    asked?.again();
  }

  /**
   * The old volume stands until the server says that the new one is open, so the page's scene does
   * not change yet.
   */
  openVolume(id: string): void {
    this.outbox.flush();
    this.sync.leaveOpen(CHOSEN_FOR_A_VOLUME);
    const input = this.sendScene({ volume: id }, false);
    this.asked = { input, again: () => this.openVolume(id), opens_volume: true };
  }

  sendLensDrag(position_px: Point): void {
    this.sync.leaveOpen({ lens: { centre_mm: null } });
    const stamp = this.stamp();
    this.stream.send({ type: 'drag_lens', ...stamp, position_px: [...position_px] });
    this.asked = { input: stamp.input, again: () => this.sendLensDrag(position_px) };
  }

  sendViewport(view: ViewName, viewport: Viewport): void {
    this.outbox.flush();
    const stamp = this.stamp(view === '3d');
    this.stream.send({ type: 'viewport', view: viewNumber(view), ...stamp, ...viewport });
  }

  /** A slice of which pictures are wanted from now on; its viewport follows. */
  openSlice(name: SliceName): void {
    this.shown_views.opened(name, this.store.state.scene);
  }

  closeSlice(name: SliceName): void {
    this.shown_views.closed(name);
    this.stream.send({ type: 'close_view', view: viewNumber(name) });
  }

  /** Starts the session's scene anew with a whole document. Returns its input number. */
  replace(scene: JsonObject): number {
    this.outbox.discard();
    return this.sendScene(scene, true);
  }

  /** A new connection: what the page shows stays, the server knows nothing. */
  restart(): void {
    this.outbox.discard();
    this.last_told = undefined;
    this.last_shown = undefined;
    this.asked = undefined;
    this.sync.restart(this.sync.scene);
    this.shown_views.restart(this.store.state.scene);
  }

  told(message: SceneStateMessage): void {
    this.answered(message.input);
    this.sync.shown(message.input);
    this.sync.told(message.scene as JsonObject);
    this.publish();
    const { scene } = this.store.state;
    if (scene) this.shown_views.changedByServer(message.revision, scene);
    this.last_told = message;
    this.showsTold();
  }

  /** A gesture is under way whose picture is not there yet. */
  get awaits_picture(): boolean {
    return this.outbox.holds_lens || awaitsPicture(this.store.state);
  }

  shown(frame: ShownFrame): Scene | undefined {
    this.sync.shown(frame.input);
    this.showsInput(frame.input);
    this.last_shown = frame;
    this.showsTold();
    return this.shown_views.volumeShownBy(frame);
  }

  sliceShown(name: SliceName, frame: ShownFrame): SlicePicture | undefined {
    this.sync.shown(frame.input);
    return this.shown_views.sliceShownBy(name, frame);
  }

  refused(error: ErrorMessage): void {
    if (error.input === undefined) return;
    this.answered(error.input);
    this.sync.refused(error.input);
    this.showsInput(error.input); // no picture will
    this.publish();
  }

  /**
   * What changes nothing in the picture makes no frame: the one of the revision that was told shows
   * it, be it on the screen already or still to come, with an older input in its header.
   */
  private showsTold(): void {
    const { last_told: told, last_shown: shown } = this;
    if (!told || !shown) return;
    const is_newest =
      !isAfter(told.revision, shown.revision) || this.shown_views.isVolumeShownBy(shown);
    if (is_newest) this.showsInput(told.input);
  }

  /** The server has begun to open the volume that was asked for, or has ended. */
  heardOfOpening(): void {
    if (this.asked?.opens_volume) this.asked = undefined;
  }

  /** The server speaks of an input that it had from here. */
  private answered(input: number): void {
    if (this.asked && !isAfter(this.asked.input, input)) this.asked = undefined;
  }

  private showsInput(input: number): void {
    if (isAfter(input, this.store.state.shown_input)) this.store.update({ shown_input: input });
  }

  private sendScene(scene: JsonObject, replace: boolean): number {
    this.asked = undefined;
    const stamp = this.stamp(replace || changesVolume(scene));
    this.stream.send({ type: 'scene', ...stamp, scene: { ...scene }, ...(replace && { replace }) });
    return stamp.input;
  }

  /** `in_volume`: a 3-D picture will show it. */
  private stamp(in_volume = true): { input: number; clock_ms: number } {
    const input = this.inputs.next();
    if (in_volume) this.store.update({ sent_input: input });
    return { input, clock_ms: clockMs() };
  }

  private publish(): void {
    this.store.update({ scene: this.sync.scene });
  }

  private remember(input: number): void {
    const { scene } = this.store.state;
    if (scene) this.shown_views.changedByInput(input, scene);
  }
}
