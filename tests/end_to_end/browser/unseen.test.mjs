// A picture that shows nothing says why, and the page shows what its controls say, whatever the
// server left out on the way.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, openBrowser, skip } from './support/browser.mjs';
import { metaImage } from './support/meta_image.mjs';
import { linkTo } from './support/scene_link.mjs';
import { isStandIn, Server } from './support/server.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const needs_server = skip || (isStandIn && 'the stand-in looks at no volume and has no limits');
const scene = (iso_value, volume = 'phantom:head') => ({
  version: 1,
  volume,
  focus: { surface: { iso_value } },
});

describe('a picture that shows nothing', { skip: needs_server }, () => {
  const suite = served((folder) =>
    writeFile(
      join(folder, 'empty.mha'),
      metaImage({ size: [8, 8, 8], spacing_mm: [1, 1, 1], valueAt: () => 3 }),
    ),
  );
  const open = (document, options = DESKTOP) =>
    Viewer.open(suite.browser, `${suite.server.url}${linkTo(document)}`, options);
  const notice = (viewer) => viewer.page.locator('[data-part=unseen]');

  it('says so while it is so', async () => {
    const viewer = await open(scene(5000));
    await notice(viewer).waitFor();
    const text = await notice(viewer).innerText();
    assert.match(text, /^Nothing of the focus can be seen: its iso-value, 5,000, is above all/);
    await assertAccessible(viewer, 'nothing to be seen');
    await viewer.page.evaluate((hash) => (location.hash = hash), linkTo(scene(300)));
    await notice(viewer).waitFor({ state: 'detached' });
    await viewer.settled();
    await viewer.close();
  });

  it('says of an empty volume that it is empty, in German, too', async () => {
    const viewer = await open({ version: 1, volume: 'empty.mha' }, { ...DESKTOP, locale: 'de-DE' });
    await notice(viewer).waitFor();
    const text = await notice(viewer).innerText();
    assert.equal(text, 'Dieses Volumen ist leer: jedes Voxel hat den Wert 3.');
    await viewer.close();
  });

  it('says nothing where something is to be seen', async () => {
    const viewer = await open(scene(300));
    await viewer.settled();
    await viewer.page.waitForTimeout(1500);
    assert.equal(await notice(viewer).count(), 0);
    await viewer.close();
  });
});

describe('inputs that come faster than the server takes', { skip: needs_server }, () => {
  let folder;
  let server;
  let browser;
  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'cutaway-slow-'));
    const config = join(folder, 'cutaway.toml');
    await writeFile(
      config,
      '[session]\nmessages_per_second = 12.0\nmessage_burst = 24.0\nlens_search_messages = 0.0\n',
    );
    server = await Server.start({ config });
    browser = await openBrowser();
  });
  after(async () => {
    await browser?.close();
    await server?.kill();
    await rm(folder, { recursive: true });
  });

  it('are there in the end', async () => {
    const viewer = await Viewer.open(browser, server.url, DESKTOP);
    await viewer.settled();
    const stage = viewer.page.locator('[data-part=stage]');
    await stage.focus();
    // Each goes out at once, so that the last is refused, too.
    await stage.evaluate((element) => {
      const reset = { key: 'r', code: 'KeyR', bubbles: true, composed: true };
      for (let press = 0; press < 200; press++)
        element.dispatchEvent(new KeyboardEvent('keydown', reset));
    });
    await viewer.page.locator('[data-part=toast]', { hasText: 'Too many requests' }).waitFor();
    await viewer.settled();
    await viewer.close();
  });
});
