// A film whose server goes away while it is made.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { DESKTOP, openBrowser, skip } from './support/browser.mjs';
import { download, zipEntries } from './support/files.mjs';
import { Server } from './support/server.mjs';
import { Viewer } from './support/viewer.mjs';

const FRAMES = 30;

describe('a film', { skip }, () => {
  let server;
  let browser;
  before(async () => {
    server = await Server.start();
    browser = await openBrowser();
  });
  after(async () => {
    await browser?.close();
    await server?.kill();
  });

  it('is whole although its server ends in the middle of it and starts again', async () => {
    const viewer = await Viewer.open(browser, server.url, DESKTOP);
    await viewer.settled();
    const button = (name) => viewer.page.getByRole('button', { name, exact: true });
    await button('Export a picture or a film (e)').click();
    await button('Film').click();
    for (const [name, value] of [
      ['Length', 1],
      ['Width', 160],
    ]) {
      const field = viewer.number(new RegExp(`^${name}`));
      await field.fill(String(value));
      await field.press('Enter');
    }
    await viewer.choose('Frames per second', String(FRAMES));
    await viewer.choose('Format', 'Numbered PNG in a ZIP');
    const { bytes } = await download(viewer, async () => {
      await viewer.page.getByRole('button', { name: /^Make the film/ }).click();
      await viewer.page.locator('[data-part=export-progress]', { hasText: /Frame [2-9] / }).waitFor();
      await server.kill();
      await viewer.page.getByText('Waiting for the server').waitFor();
      await viewer.screenshot('desktop-export-waits');
      await server.startAgain();
    });
    const [, ...frames] = zipEntries(bytes);
    assert.equal(frames.length, FRAMES);
    const pictures = new Set(frames.map(({ content }) => content.toString('base64')));
    assert.equal(pictures.size, FRAMES, 'each frame is another one');
    await viewer.closeAfterLoss();
  });
});
