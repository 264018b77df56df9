// What a first visit is told on the picture, and the status line on demand.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

describe('a first visit', { skip }, () => {
  const suite = served();
  const open = async (options) => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, {
      ...options,
      storageState: undefined,
    });
    await viewer.settled();
    return viewer;
  };

  for (const [name, options] of Object.entries({ desktop: DESKTOP, phone: PHONE })) {
    it(`${name}: shows three hints, which do not come again once sent away`, async () => {
      const viewer = await open(options);
      const hints = viewer.page.locator('cutaway-hints .hint');
      await viewer.page.locator('[data-part=hints]').waitFor();
      assert.equal(await hints.count(), 3);
      await assertAccessible(viewer, 'hints');
      await viewer.screenshot(`${name}-hints`);
      await viewer.page.getByRole('button', { name: 'Got it' }).press('Enter');
      assert.equal(await hints.count(), 0);
      await viewer.page.reload();
      await viewer.settled();
      assert.equal(await hints.count(), 0);
      await viewer.close();
    });
  }

  it('takes each hint away once it has been followed', async () => {
    const viewer = await open(DESKTOP);
    const hint = (name) => viewer.page.locator(`cutaway-hints .${name}`);
    const [x, y] = await viewer.stageMiddle();
    await viewer.after(() => viewer.drag([x - 40, y + 250], [x, y + 250]));
    await hint('turn').waitFor({ state: 'detached' });
    const grip = await viewer.gripMiddle();
    await viewer.after(() => viewer.drag(grip, [grip[0] - 30, grip[1] - 20]));
    await hint('lens').waitFor({ state: 'detached' });
    await hint('style').waitFor();
    await viewer.after(() => viewer.page.locator('[data-style=toon]').click());
    await hint('style').waitFor({ state: 'detached' });
    await viewer.page.locator('[data-part=hints]').waitFor({ state: 'detached' });
    await viewer.close();
  });
});

describe('the status line', { skip }, () => {
  const suite = served();

  for (const [name, options] of Object.entries({ desktop: DESKTOP, phone: PHONE })) {
    it(`${name}: comes and goes on demand, and is remembered`, async () => {
      const viewer = await Viewer.open(suite.browser, suite.server.url, options);
      await viewer.settled();
      const line = viewer.page.locator('[data-part=status-line]');
      assert.equal(await line.count(), 0);
      await viewer.after(() => viewer.page.locator('[data-part=stage]').press('i'));
      assert.match(
        await line.textContent(),
        /Frames per second.*Latency.*KiB.*Resolution.*Quality/s,
      );
      await assertAccessible(viewer, 'status line');
      await viewer.screenshot(`${name}-status-line`);
      await viewer.page.reload();
      await viewer.settled();
      await line.waitFor();
      await viewer.openTab('View');
      await viewer.settled();
      await viewer.toggle('Status line under the picture');
      await line.waitFor({ state: 'detached' });
      await viewer.close();
    });
  }
});
