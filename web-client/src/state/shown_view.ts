// What a picture on the screen shows. Frames lag behind the input; what is drawn over them must lag
// along with them, or the lens' outline would swim over the surface.
import { isAfter } from '../protocol/counter.ts';

interface Step<Shown> {
  readonly shown: Shown;
  /** Holds for frames that show this input... */
  readonly input?: number;
  /** ...or this revision. */
  readonly revision?: number;
}

interface FrameOrder {
  readonly input: number;
  readonly revision: number;
}

const reaches = (frame: FrameOrder, step: Step<unknown>): boolean =>
  step.input === undefined
    ? step.revision === undefined || !isAfter(step.revision, frame.revision)
    : !isAfter(step.input, frame.input);

export class ShownView<Shown> {
  private steps: readonly Step<Shown>[] = [];

  /** `same`: what changes nothing in the picture makes no frame, and is no step. */
  constructor(private readonly same: (a: Shown, b: Shown) => boolean = Object.is) {}

  changedByInput(input: number, shown: Shown): void {
    this.add({ input, shown });
  }

  changedByServer(revision: number, shown: Shown): void {
    this.add({ revision, shown });
  }

  /** Of the newest step that this frame shows; nothing where none is known. */
  shownBy(frame: FrameOrder): Shown | undefined {
    const last = this.steps.findLastIndex((step) => reaches(frame, step));
    if (last > 0) this.steps = this.steps.slice(last);
    return last >= 0 ? this.steps[0]?.shown : undefined;
  }

  /** Whether this frame shows the newest step. */
  isShownBy(frame: FrameOrder): boolean {
    const newest = this.steps.at(-1);
    return newest !== undefined && reaches(frame, newest);
  }

  /** Revisions start anew with each session. */
  restart(shown: Shown | undefined): void {
    this.steps = shown ? [{ shown }] : [];
  }

  private add(step: Step<Shown>): void {
    const newest = this.steps.at(-1);
    if (!newest || !this.same(newest.shown, step.shown)) this.steps = [...this.steps, step];
  }
}
