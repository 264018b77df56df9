// Changes leave at most once per animation frame: however many pointer events came since, one patch
// holds their sum.
import { isObject, type Json, type JsonObject } from '../state/merge_patch.ts';
import type { Point } from '../view/camera.ts';

function compose(first: JsonObject, second: JsonObject): JsonObject {
  const merged: Record<string, Json> = { ...first };
  for (const [key, value] of Object.entries(second)) {
    const old = merged[key];
    const replaces =
      !isObject(value) || !isObject(old) || ('name' in value && value['name'] !== old['name']);
    merged[key] = replaces ? value : compose(old, value);
  }
  return merged;
}

export interface OutboxSender {
  sendPatch(patch: JsonObject): void;
  sendLensDrag(position_px: Point): void;
}

export class Outbox {
  private patch: JsonObject | undefined;
  private lens_position_px: Point | undefined;
  private scheduled = false;

  constructor(
    private readonly sender: OutboxSender,
    private readonly schedule: (flush: () => void) => void = (flush) =>
      void requestAnimationFrame(flush),
  ) {}

  get holds_lens(): boolean {
    return this.lens_position_px !== undefined;
  }

  /** `patch` holds no nulls: those go out at once, after a flush. */
  change(patch: JsonObject): void {
    this.patch = compose(this.patch ?? {}, patch);
    this.wake();
  }

  dragLens(position_px: Point): void {
    this.lens_position_px = position_px;
    this.wake();
  }

  flush(): void {
    const { patch, lens_position_px } = this;
    this.discard();
    if (patch) this.sender.sendPatch(patch);
    if (lens_position_px) this.sender.sendLensDrag(lens_position_px);
  }

  discard(): void {
    this.patch = undefined;
    this.lens_position_px = undefined;
  }

  private wake(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    this.schedule(() => {
      this.scheduled = false;
      this.flush();
    });
  }
}
