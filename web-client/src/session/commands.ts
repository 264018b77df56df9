// What a user can do, by name. Components, pointer and keys all call these.
import { holdsNull, nestedPatch, type Json, type JsonObject } from '../state/merge_patch.ts';
import { sceneToAddress } from '../state/scene_address.ts';
import { shownCamera, viewCamera } from '../state/scene_parts.ts';
import { stylePatch } from '../state/style_patch.ts';
import type { MeasuredVolumes } from '../state/measured_volumes.ts';
import type { Store } from '../state/store.ts';
import type { PanelTab, ViewerState } from '../state/viewer_state.ts';
import type { Stream } from '../stream/stream.ts';
import { projectPx, type Camera, type Point, type Viewport } from '../view/camera.ts';
import { lookFrom, orbitByPixels, panByPixels, roll, zoom } from '../view/camera_motion.ts';
import type { StandardView } from '../view/orientation.ts';
import { SCENE_FIELDS, type Scene, type Style } from '../protocol/messages.ts';
import { groupReset, type PanelGroup } from '../state/group_reset.ts';
import { words } from '../words/words.ts';
import { Comparison } from './comparison.ts';
import { History } from './history.ts';
import type { SceneLink } from './scene_link.ts';
import type { Toasts } from './toasts.ts';
import type { Preferences } from '../preferences/preferences.ts';

const SMALLEST_LENS_MM = 1;

export class Commands {
  /** What comes back when the lens is switched on again. */
  private lens_mode: Json = 'cutaway';
  /** Where a key sent the lens, if nothing else was done since. */
  private nudged_px: Point | undefined;
  private readonly history: History;
  private readonly comparison: Comparison;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly link: SceneLink,
    private readonly stream: Stream,
    private readonly toasts: Toasts,
  ) {
    this.history = new History(store, link);
    this.comparison = new Comparison(store, link, this.history);
  }

  /** A null, which leaves a choice to the server, goes out at once. */
  change(patch: JsonObject): void {
    this.step();
    if (holdsNull(patch)) this.link.sendPatch(patch);
    else this.link.change(patch);
  }

  set(path: readonly string[], value: Json): void {
    this.change(nestedPatch(path, value));
  }

  orbit(dx_px: number, dy_px: number): void {
    this.move((camera, viewport) => orbitByPixels(camera, viewport, dx_px, dy_px));
  }

  pan(dx_px: number, dy_px: number): void {
    this.move((camera, viewport) => panByPixels(camera, viewport, dx_px, dy_px));
  }

  zoom(magnification: number): void {
    this.move((camera) => zoom(camera, magnification, this.store.state.volume?.diagonal_mm));
  }

  roll(angle_radians: number): void {
    this.move((camera) => roll(camera, angle_radians));
  }

  look({ towards_eye, up }: StandardView): void {
    this.stepAtOnce();
    this.move((camera) => lookFrom(camera, towards_eye, up));
  }

  /** Back to the view that the server chooses for the volume. */
  resetView(): void {
    this.stepAtOnce();
    this.link.sendPatch({ camera: null, lens: { centre_mm: null, radius_mm: null } });
  }

  dragLens(position_px: Point): void {
    this.step();
    this.link.dragLens(position_px);
  }

  /**
   * Moves the lens over the surface by a distance in the picture. Keys repeat faster than pictures
   * come: a nudge goes on from the one before until a picture shows that.
   */
  nudgeLens(dx_px: number, dy_px: number): void {
    const underway_px = this.link.awaits_picture ? this.nudged_px : undefined;
    const from_px = underway_px ?? this.shownLensPx();
    if (!from_px) return;
    const to_px: Point = [from_px[0] + dx_px, from_px[1] + dy_px];
    this.dragLens(to_px);
    this.nudged_px = to_px;
  }

  private shownLensPx(): Point | undefined {
    const { shown_scene, viewport } = this.store.state;
    const camera = shownCamera(this.store.state);
    const centre_mm = shown_scene?.lens?.centre_mm;
    return camera && viewport && centre_mm && projectPx(camera, viewport, centre_mm);
  }

  setLensRadius(radius_mm: number): void {
    const largest_mm = Math.min(
      SCENE_FIELDS['lens.radius_mm'].maximum,
      this.store.state.volume?.diagonal_mm ?? Infinity,
    );
    this.set(['lens', 'radius_mm'], Math.min(largest_mm, Math.max(SMALLEST_LENS_MM, radius_mm)));
  }

  scaleLens(factor: number): void {
    const radius_mm = this.store.state.scene?.lens?.radius_mm;
    if (radius_mm !== undefined) this.setLensRadius(radius_mm * factor);
  }

  toggleLens(): void {
    const mode = this.store.state.scene?.lens?.mode ?? 'none';
    if (mode !== 'none') this.lens_mode = mode;
    this.stepAtOnce();
    this.link.change(nestedPatch(['lens', 'mode'], mode === 'none' ? this.lens_mode : 'none'));
  }

  /** A lens that is off comes on, or nothing would be seen to follow. */
  followPointer(lens_follows = !this.store.state.lens_follows): void {
    if (lens_follows && this.store.state.scene?.lens?.mode === 'none') this.toggleLens();
    this.store.update({ lens_follows });
  }

  /** The server's, or an own one. Returns the number of the input that puts it on. */
  applyStyle(style: Style): number | undefined {
    const { capabilities } = this.store.state;
    if (!capabilities) return undefined;
    this.stepAtOnce();
    this.store.update({ base_style: style });
    return this.link.sendPatch(stylePatch(style, capabilities.modules));
  }

  /** A part of the panel, back to what the last style says of it. */
  resetGroup(group: PanelGroup): void {
    const { capabilities, base_style } = this.store.state;
    if (!capabilities) return;
    this.stepAtOnce();
    this.link.sendPatch(groupReset(group, capabilities, base_style));
  }

  /** Before a change: undo goes back to here, or to where the gesture began. */
  step(): void {
    this.nudged_px = undefined;
    this.history.changing(this.sceneToKeep());
  }

  /** Before a change that is undone on its own. */
  stepAtOnce(): void {
    this.nudged_px = undefined;
    this.history.changingAtOnce(this.sceneToKeep());
  }

  /** Not a step: what another page has changed, or what comes to be another volume's. */
  rewriteMeasured(rewrite: (all: MeasuredVolumes) => MeasuredVolumes): void {
    this.history.rewriteMeasured(rewrite);
  }

  undo(): void {
    this.nudged_px = undefined;
    this.comparison.end();
    this.history.undo();
  }

  redo(): void {
    this.nudged_px = undefined;
    this.comparison.end();
    this.history.redo();
  }

  /** Shows the previous look until it is called with false. */
  compare(begins: boolean): void {
    if (!begins) this.comparison.end();
    else if (!this.comparison.begin()) this.toasts.note(words().messages.nothing_to_compare);
  }

  /** The server chooses camera, lens and iso-values for the new volume. */
  openVolume(id: string): void {
    if (this.store.state.link.phase !== 'connected')
      return this.toasts.note(words().messages.not_without_connection);
    this.store.update({ awaits_volume: false });
    this.stepAtOnce();
    this.link.openVolume(id);
  }

  cancelLoad(): void {
    this.stream.send({ type: 'cancel_load' });
  }

  resize(viewport: Viewport): void {
    this.store.update({ viewport });
    this.link.sendViewport('3d', viewport);
  }

  /** Nothing before there is a scene. */
  sceneLink(): Promise<string> | undefined {
    const { scene } = this.store.state;
    const [page = ''] = location.href.split('#');
    return scene && sceneToAddress(scene as JsonObject).then((address) => `${page}${address}`);
  }

  connectNow(): void {
    this.stream.connectNow();
  }

  showTab(panel_tab: PanelTab): void {
    this.store.update({ panel_tab });
    this.prefer({ panel_open: true });
  }

  togglePanel(): void {
    this.prefer({ panel_open: !this.store.state.preferences.panel_open });
  }

  prefer(change: Partial<Preferences>): void {
    this.store.update({ preferences: { ...this.store.state.preferences, ...change } });
  }

  toggleStatusLine(): void {
    this.prefer({ status_line: !this.store.state.preferences.status_line });
  }

  toggleHelp(help_open = !this.store.state.help_open): void {
    this.store.update({ help_open });
  }

  private move(motion: (camera: Camera, viewport: Viewport) => Camera): void {
    const { viewport } = this.store.state;
    const camera = viewCamera(this.store.state);
    if (!camera || !viewport) return;
    const moved = motion(camera, viewport);
    if (moved === camera) return;
    const { eye_mm, target_mm, up, ...lens } = moved;
    this.step();
    this.link.change({ camera: { eye_mm, target_mm, up, ...lens } });
  }

  private sceneToKeep(): Scene | undefined {
    const { scene } = this.store.state;
    return scene && this.comparison.withoutIt(scene);
  }
}
