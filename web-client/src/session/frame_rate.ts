// Frames per second over the last second of motion.

const WINDOW_MS = 1_000;

export class FrameRate {
  private times_ms: readonly number[] = [];

  shown(now_ms: number): number {
    this.times_ms = [...this.times_ms.filter((time_ms) => now_ms - time_ms < WINDOW_MS), now_ms];
    return this.times_ms.length;
  }
}
