// How long to wait before the next attempt to connect: doubling, bounded, and spread so that a
// fleet of pages does not come back to a restarted server in one instant.

const FIRST_MS = 250;
/** A page is to be back within three seconds of its server, which also has to read the volume again. */
const LONGEST_MS = 750;
/** A server that refuses is not asked as often. */
const LONGEST_WHEN_REFUSED_MS = 15_000;

export class ReconnectBackoff {
  private failures = 0;

  /** `random` gives numbers in [0, 1). */
  constructor(private readonly random: () => number = Math.random) {}

  /** Between half and all of the doubled time. */
  nextDelayMs(is_refused = false): number {
    const longest_ms = is_refused ? LONGEST_WHEN_REFUSED_MS : LONGEST_MS;
    const full_ms = Math.min(longest_ms, FIRST_MS * 2 ** this.failures);
    this.failures += 1;
    return full_ms * (0.5 + 0.5 * this.random());
  }

  /** After a connection that worked. */
  reset(): void {
    this.failures = 0;
  }
}
