// What goes wrong around the page: each leads to a message and to a working page.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, openBrowser, PHONE, skip } from './support/browser.mjs';
import { linkTo } from './support/scene_link.mjs';
import { isStandIn, Server } from './support/server.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const toast = (viewer, hasText) => viewer.page.locator('[data-part=toast]', { hasText });

describe('bad input', { skip }, () => {
  const suite = served();
  const open = (hash = '', options = DESKTOP) =>
    Viewer.open(suite.browser, `${suite.server.url}${hash}`, options);

  async function assertWorks(viewer) {
    await viewer.settled();
    await viewer.after(() => viewer.page.locator('[data-part=stage]').press('ArrowRight'));
  }

  for (const [name, scene] of [
    ['an unknown volume', { version: 1, volume: 'ct/gone' }],
    ['a version to come', { version: 99, volume: 'phantom:head' }],
    ['a broken scene', { version: 1, volume: 'phantom:head', lens: 'round' }],
  ]) {
    it(`a link with ${name} is refused with a message, and a view is opened`, async () => {
      const viewer = await open(linkTo(scene));
      await toast(viewer, 'This link could not be opened').waitFor();
      await assertAccessible(viewer, name);
      await assertWorks(viewer);
      await viewer.close();
    });
  }

  it('a link is refused in German, too', async () => {
    const viewer = await open('#1.broken', { ...DESKTOP, locale: 'de-DE' });
    await toast(viewer, 'Dieser Link konnte nicht geöffnet werden').waitFor();
    await assertWorks(viewer);
    await viewer.close();
  });

  for (const [name, options] of Object.entries({ desktop: DESKTOP, phone: PHONE })) {
    it(`${name}: a window that was made as small as can be shows the view again`, async () => {
      const viewer = await open('', options);
      await viewer.settled();
      const letters = await viewer.edgeLetters();
      await viewer.page.setViewportSize({ width: 1, height: 1 });
      await viewer.page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
      await viewer.page.setViewportSize(options.viewport);
      await viewer.settled();
      assert.equal(await viewer.edgeLetters(), letters);
      assert.equal(await viewer.page.getByRole('alert').count(), 0);
      await assertWorks(viewer);
      await viewer.close();
    });
  }

  it('a server that stalls is told of, and the page goes on with it', async () => {
    const viewer = await open();
    await viewer.settled();
    suite.server.stall();
    try {
      await viewer.page.locator('[data-part=stage]').press('ArrowRight');
      await viewer.page.locator('[data-part=stalled]').waitFor();
      await assertAccessible(viewer, 'stalled');
      await viewer.screenshot('desktop-stalled');
    } finally {
      suite.server.goOn();
    }
    await viewer.page.locator('[data-part=stalled]').waitFor({ state: 'detached' });
    await assertWorks(viewer);
    await viewer.closeAfterLoss();
  });
});

describe('a full server', { skip: skip || (isStandIn && 'the stand-in is never full') }, () => {
  let browser, folder, server;
  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'cutaway-full-'));
    const config = join(folder, 'cutaway.toml');
    await writeFile(config, '[server]\nsessions = 1\nqueued_sessions = 1\nidle_seat_ms = 500\n');
    server = await Server.start({ config });
    browser = await openBrowser();
  });
  after(async () => {
    await browser?.close();
    await server?.kill();
    await rm(folder, { recursive: true });
  });

  it('has a page wait in the queue, another try again, and lets both in', async () => {
    const open = () => Viewer.open(browser, server.url, DESKTOP);
    const within = await open();
    await within.settled();
    const queued = await open();
    await queued.page.locator('.banner', { hasText: 'You are next' }).waitFor();
    await assertAccessible(queued, 'queued');
    await queued.screenshot('desktop-queued');
    const outside = await open();
    await outside.page.getByText('Reconnecting: the server is full.').waitFor();
    await assertAccessible(outside, 'full');
    await outside.screenshot('desktop-full');
    await within.close();
    await queued.settled();
    await queued.close();
    await outside.settled();
    await outside.close();
  });

  for (const [locale, words] of [
    ['en-GB', 'It goes on as soon as you are back.'],
    ['de-DE', 'Sie macht weiter, sobald Sie zurück sind.'],
  ]) {
    it(`${locale}: gives a hidden page's place to one that waits, and has it back`, async () => {
      const first = await Viewer.open(browser, server.url, { ...DESKTOP, locale });
      await first.settled();
      const letters = await first.edgeLetters();
      await putInSight(first, 'hidden');
      const second = await Viewer.open(browser, server.url, DESKTOP);
      await second.settled();
      await first.page.locator('[data-part=gave-way]', { hasText: words }).waitFor();
      await assertAccessible(first, 'gave way');
      await first.screenshot(`desktop-gave-way-${locale}`);
      await putInSight(first, 'visible');
      await first.page.locator('.banner', { hasText: /You are next|an der Reihe/ }).waitFor();
      await second.close();
      await first.settled();
      assert.equal(await first.edgeLetters(), letters);
      await first.close();
    });
  }
});

/** As when the browser's window is covered, or another tab is in front. */
async function putInSight(viewer, state) {
  await viewer.page.evaluate((visibility) => {
    Object.defineProperty(document, 'visibilityState', { value: visibility, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }, state);
}
