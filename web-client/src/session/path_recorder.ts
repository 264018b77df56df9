// Records what the user does with the view, for a film of it.
import type { CameraPath, PathSample } from '../film/camera_path.ts';
import type { ExportState } from '../state/export_state.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';

/** A film of it has thousands of frames, each a request. */
export const LONGEST_RECORDING_MS = 120_000;

export class PathRecorder {
  private samples: PathSample[] = [];
  private limit: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly store: Store<ViewerState>) {
    store.subscribe((state, before) => this.changed(state, before));
  }

  toggle(): void {
    if (this.store.state.exporting.recording_since_ms === undefined) this.start();
    else this.stop();
  }

  /** Closes the dialog, so that the view can be moved. */
  start(): void {
    const { scene } = this.store.state;
    if (!scene) return;
    this.samples = [{ at_ms: 0, scene }];
    this.limit = setTimeout(() => this.stop(), LONGEST_RECORDING_MS);
    this.update({
      open: false,
      outcome: undefined,
      path: undefined,
      recording_since_ms: performance.now(),
    });
  }

  /** The dialog opens again, with what was recorded. Nothing happens where nothing is recorded. */
  stop(): void {
    const { recording_since_ms: since_ms } = this.store.state.exporting;
    if (since_ms === undefined) return;
    const path: CameraPath = { duration_ms: performance.now() - since_ms, samples: this.samples };
    this.end({ path, open: true });
  }

  private changed({ scene, volume, exporting }: ViewerState, before: ViewerState): void {
    const { recording_since_ms: since_ms } = exporting;
    if (volume?.id !== before.volume?.id) this.end({ path: undefined });
    else if (since_ms !== undefined && scene && scene !== before.scene)
      this.samples.push({ at_ms: performance.now() - since_ms, scene });
  }

  private end(change: Partial<ExportState>): void {
    clearTimeout(this.limit);
    this.samples = [];
    this.update({ recording_since_ms: undefined, ...change });
  }

  private update(change: Partial<ExportState>): void {
    this.store.update({ exporting: { ...this.store.state.exporting, ...change } });
  }
}
