// Which scene a session begins with: the one it showed before, else the address', else the volume
// best worth seeing, in the style that the server finds to suit it. That is a file's where the
// server has files, so it waits for their scan.
import type { ErrorMessage } from '../protocol/messages.ts';
import { bestVolume } from '../state/best_volume.ts';
import { SceneAddressError, sceneFromAddress } from '../state/scene_address.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { errorDetail } from '../state/error_text.ts';
import type { SceneLink } from './scene_link.ts';
import type { Toasts } from './toasts.ts';
import { words } from '../words/words.ts';

interface Asked {
  readonly input: number;
  readonly refusal: string;
  /** It is the view before the connection was lost. */
  readonly restores: boolean;
}

export class SceneOpening {
  private begun = false;
  /** The input under which a whole scene was asked for, and what to say should it be refused. */
  private asked: Asked | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly link: SceneLink,
    private readonly toasts: Toasts,
  ) {}

  /** A new connection. */
  restart(): void {
    this.begun = false;
    this.asked = undefined;
    this.store.update({ awaits_volume: false });
  }

  /** Once capabilities and volumes are known, and whenever those are others. */
  async begin(address: string): Promise<void> {
    const { capabilities, volumes, scene, awaits_volume } = this.store.state;
    if (awaits_volume) return this.openDefault();
    if (this.begun || !capabilities || volumes.length === 0) return;
    this.begun = true;
    if (scene) this.ask(scene as JsonObject, words().messages.view_not_restored, true);
    else if (!(await this.openAddress(address))) this.openDefault();
  }

  /** Whether the address holds a scene that can be read. */
  async openAddress(address: string): Promise<boolean> {
    try {
      const scene = await sceneFromAddress(address);
      if (scene) this.ask(scene, words().messages.link_not_opened);
      return scene !== undefined;
    } catch (error) {
      if (!(error instanceof SceneAddressError)) throw error;
      const { link_not_opened, new_view_instead, link_faults } = words().messages;
      this.toasts.problem(link_not_opened, new_view_instead(link_faults[error.fault]));
      return false;
    }
  }

  /** Whether the error answers the whole scene that was asked for; if so another one is opened. */
  refused(error: ErrorMessage): boolean {
    const { asked } = this;
    if (!asked || error.input !== asked.input) return false;
    this.asked = undefined;
    this.toasts.problem(asked.refusal, errorDetail(error));
    this.openDefault();
    return true;
  }

  /** The server has taken a scene over. */
  told(): void {
    const { restored, restored_detail } = words().messages;
    if (this.asked?.restores) this.toasts.note(restored, restored_detail);
    this.asked = undefined;
  }

  private ask(scene: JsonObject, refusal: string, restores = false): void {
    this.store.update({ awaits_volume: false });
    this.asked = { input: this.link.replace(scene), refusal, restores };
  }

  private openDefault(): void {
    const { volumes, scanning, preferences } = this.store.state;
    const volume = bestVolume(volumes);
    const awaits_volume = scanning && volumes.every(({ format }) => format === 'phantom');
    this.store.update({ awaits_volume });
    if (!volume || awaits_volume) return;
    const slices = { convention: preferences.convention };
    this.link.replace({ volume: volume.id, slices });
  }
}
