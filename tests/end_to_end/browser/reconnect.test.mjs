// A server that goes away and comes back.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { served } from './support/suite.mjs';
import { meanDifference, Viewer } from './support/viewer.mjs';

describe('a lost connection', { skip }, () => {
  const suite = served();

  it('dims the last picture, and is followed by the same view', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, DESKTOP);
    await viewer.settled();
    const [x, y] = await viewer.stageMiddle();
    await viewer.after(() => viewer.drag([x - 80, y + 200], [x + 80, y + 150]));
    const letters = await viewer.edgeLetters();
    const picture = await viewer.pixels();

    await viewer.page.mouse.move(x, y + 200);
    await viewer.page.mouse.down();
    await suite.server.kill();
    await viewer.app('[data-connection=waiting]').waitFor();
    await viewer.page.mouse.up();
    await viewer.page.getByText(/^Reconnecting:/).waitFor();
    // It grows dim: a screenshot in the middle of that may miss it.
    await viewer.page.waitForFunction(() => document.getAnimations().length === 0);
    assert.ok((await viewer.coverage()) > 0.02, 'the last picture is gone');
    await viewer.screenshot('desktop-disconnected');

    await suite.server.startAgain();
    await viewer.app('[data-connection=connected]').waitFor();
    await viewer.settled();
    assert.equal(await viewer.edgeLetters(), letters);
    assert.ok(meanDifference(picture, await viewer.pixels()) < 0.5);
    await viewer.after(() => viewer.drag([x, y + 200], [x + 50, y + 200]));

    await viewer.closeAfterLoss();
  });

  it('in the middle of a drag loses nothing of it', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, DESKTOP);
    await viewer.settled();
    const { mouse } = viewer.page;
    const [x, y] = await viewer.stageMiddle();
    const { width, height } = await viewer.stageBox();
    const eighth = Math.min(width, height) / 4;
    await mouse.move(x - eighth, y + 200);
    await mouse.down();
    await mouse.move(x - eighth / 2, y + 200, { steps: 4 });
    await suite.server.kill();
    await viewer.app('[data-connection=waiting]').waitFor();
    await mouse.move(x, y + 200, { steps: 4 });
    await suite.server.startAgain();
    const said = viewer.page.locator('[data-part=toast]', { hasText: 'Connected again' }).waitFor();
    const connected = viewer.app('[data-connection=connected]').waitFor();
    await mouse.move(x + eighth / 2, y + 200, { steps: 40 });
    await connected;
    await mouse.move(x + eighth, y + 200, { steps: 10 });
    await mouse.up();
    await said;
    await viewer.settled();
    assert.equal(await viewer.edgeLetters(), 'S A I P');
    assert.equal(await viewer.page.getByRole('alert').count(), 0);
    await viewer.after(() => viewer.page.keyboard.press('Control+z'));
    assert.equal(await viewer.edgeLetters(), 'S L I R');
    await viewer.closeAfterLoss();
  });
});
