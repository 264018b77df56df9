// How long to wait before the next attempt to connect: doubling, bounded, and spread so that a
// fleet of pages does not come back to a restarted server in one instant.

const FIRST_MS = 250;
const LONGEST_MS = 8_000;

export class ReconnectBackoff {
  private failures = 0;

  /** `random` gives numbers in [0, 1). */
  constructor(private readonly random: () => number = Math.random) {}

  /** Between half and all of the doubled time. */
  nextDelayMs(): number {
    const full_ms = Math.min(LONGEST_MS, FIRST_MS * 2 ** this.failures);
    this.failures += 1;
    return full_ms * (0.5 + 0.5 * this.random());
  }

  /** After a connection that worked. */
  reset(): void {
    this.failures = 0;
  }
}
