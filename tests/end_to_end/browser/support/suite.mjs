// The set-up that suites share: one server and one browser each, and a page for each test.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before, beforeEach } from 'node:test';
import { openBrowser } from './browser.mjs';
import { Server } from './server.mjs';
import { Viewer } from './viewer.mjs';

/**
 * For the suite that calls it: its `server` and its `browser`, there once its tests run. `fill` puts
 * volumes into a folder that the server then has, too.
 */
export function served(fill) {
  const suite = {};
  let folder;
  before(async () => {
    if (fill) folder = await mkdtemp(join(tmpdir(), 'cutaway-volumes-'));
    await fill?.(folder);
    suite.server = await Server.start({ data: folder ? [folder] : [] });
    suite.browser = await openBrowser();
  });
  after(async () => {
    await suite.browser?.close();
    await suite.server?.kill();
    if (folder) await rm(folder, { recursive: true });
  });
  return suite;
}

/** The same with a page at rest for each test, of which `opened` is told. */
export function servedPage(options, opened) {
  const suite = served();
  let viewer;
  beforeEach(async () => {
    viewer = await Viewer.open(suite.browser, suite.server.url, options);
    await viewer.settled();
    await opened(viewer);
  });
  afterEach(() => viewer.close());
  return suite;
}
