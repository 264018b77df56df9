// No rule of axe-core is broken: names, roles, contrast.
import assert from 'node:assert/strict';
import { axeSource } from './browser.mjs';

export async function assertAccessible({ page }, state) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() =>
    globalThis.axe.run(document, { resultTypes: ['violations'] }),
  );
  const found = violations.map(
    ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join('; ')}`,
  );
  assert.deepEqual(found, [], state);
}
