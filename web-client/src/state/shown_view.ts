// Which camera and lens the picture on the screen shows. Frames lag behind the input; what is drawn
// over them must lag along with them, or the lens' outline would swim over the surface.
import { isAfter } from '../protocol/counter.ts';
import type { Scene } from '../protocol/messages.ts';

interface Step {
  readonly scene: Scene;
  /** Holds for frames that show this input... */
  readonly input?: number;
  /** ...or this revision. */
  readonly revision?: number;
}

interface FrameOrder {
  readonly input: number;
  readonly revision: number;
}

const reaches = (frame: FrameOrder, step: Step): boolean =>
  step.input === undefined
    ? step.revision === undefined || !isAfter(step.revision, frame.revision)
    : !isAfter(step.input, frame.input);

export class ShownView {
  private steps: readonly Step[] = [];

  changedByInput(input: number, scene: Scene): void {
    this.steps = [...this.steps, { input, scene }];
  }

  changedByServer(revision: number, scene: Scene): void {
    this.steps = [...this.steps, { revision, scene }];
  }

  /** The scene of the newest step that this frame shows; nothing where none is known. */
  sceneOf(frame: FrameOrder): Scene | undefined {
    const last = this.steps.findLastIndex((step) => reaches(frame, step));
    if (last > 0) this.steps = this.steps.slice(last);
    return last >= 0 ? this.steps[0]?.scene : undefined;
  }

  /** Revisions start anew with each session. */
  restart(scene: Scene | undefined): void {
    this.steps = scene ? [{ scene }] : [];
  }
}
