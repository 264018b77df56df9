// The page as it stands after the first look, with the gallery open. usage: picture_of_page.mjs OUT.png
import { DESKTOP, openBrowser } from '../end_to_end/browser/support/browser.mjs';
import { Server } from '../end_to_end/browser/support/server.mjs';
import { Viewer } from '../end_to_end/browser/support/viewer.mjs';

const server = await Server.start();
const browser = await openBrowser();
const viewer = await Viewer.open(browser, server.url, DESKTOP);
await viewer.settled();
await viewer.openTab('Styles');
await viewer.page
  .locator('[data-style]:not([data-picture=rendered]):visible')
  .first()
  .waitFor({ state: 'detached' });
await viewer.settled();
await viewer.page.screenshot({ path: process.argv[2], animations: 'disabled' });
await viewer.close();
await browser.close();
await server.kill();
