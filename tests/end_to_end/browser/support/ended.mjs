// Processes that a test started.
import { once } from 'node:events';

/** Resolves once it is gone. */
export async function ended(process) {
  if (!process || process.exitCode !== null || process.signalCode !== null) return;
  const exit = once(process, 'exit');
  process.kill();
  await exit;
}
