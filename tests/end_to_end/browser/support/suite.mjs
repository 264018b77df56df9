// The set-up that suites share: one server and one browser each, and a page for each test.
import { after, afterEach, before, beforeEach } from 'node:test';
import { openBrowser } from './browser.mjs';
import { Server } from './server.mjs';
import { Viewer } from './viewer.mjs';

/** For the suite that calls it: its `server` and its `browser`, there once its tests run. */
export function served() {
  const suite = {};
  before(async () => {
    suite.server = await Server.start();
    suite.browser = await openBrowser();
  });
  after(async () => {
    await suite.browser?.close();
    await suite.server?.kill();
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
