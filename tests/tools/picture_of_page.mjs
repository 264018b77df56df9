// The page as it stands, for the README: with the gallery of styles, and with the slices of a chest CT in a folder, on a
// desktop and on a phone. usage: picture_of_page.mjs OUT_FOLDER CHEST_FOLDER
import { join } from 'node:path';
import { DESKTOP, openBrowser, PHONE } from '../end_to_end/browser/support/browser.mjs';
import { Server } from '../end_to_end/browser/support/server.mjs';
import { Slices } from '../end_to_end/browser/support/slices.mjs';
import { Viewer } from '../end_to_end/browser/support/viewer.mjs';

const [folder, chest] = process.argv.slice(2);
const browser = await openBrowser();

async function picture(name, { options, server, prepare }) {
  const viewer = await Viewer.open(browser, server.url, options);
  await viewer.settled();
  await prepare(viewer);
  await viewer.settled();
  await viewer.page.screenshot({ path: join(folder, `${name}.png`), animations: 'disabled' });
  await viewer.close();
}

async function gallery(viewer) {
  await viewer.openTab('Styles');
  const waiting = viewer.page.locator('[data-style]:not([data-picture=rendered]):visible');
  await waiting.first().waitFor({ state: 'detached' });
}

/** Down to the heart, in the soft tissue's window; the lens goes along. */
async function heart(viewer) {
  const slices = new Slices(viewer);
  await slices.choose('grid');
  await slices.stage('axial').focus();
  await viewer.page.keyboard.press('1');
  await viewer.page.mouse.click(...(await slices.at('axial', 0.56, 0.42)));
  await slices.settled();
  await viewer.page.mouse.move(2, 2);
  await gallery(viewer);
}

async function phone(viewer) {
  const slices = new Slices(viewer);
  const next = viewer.page.locator('[data-part=next-layout]');
  await next.tap();
  await next.tap();
  await slices.settled();
}

const phantoms = await Server.start();
await picture('viewer', { options: DESKTOP, server: phantoms, prepare: gallery });
await phantoms.kill();
const patient = await Server.start({ data: [chest] });
await picture('slices', { options: DESKTOP, server: patient, prepare: heart });
await picture('phone', { options: PHONE, server: patient, prepare: phone });
await patient.kill();
await browser.close();
