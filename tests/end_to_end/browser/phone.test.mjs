// The page under fingers at 390x844.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { PHONE, skip } from './support/browser.mjs';
import { servedPage } from './support/suite.mjs';

const STEPS = 6;
const between = (from, to, share) => from + (to - from) * share;

describe('the page on a phone', { skip }, () => {
  let viewer, touch;
  servedPage(PHONE, async (page) => {
    viewer = page;
    touch = await viewer.page.context().newCDPSession(viewer.page);
  });

  /** Each finger goes from one place to another: [[x, y], [x, y]]. */
  async function move(...fingers) {
    const points = (share) =>
      fingers.map(([from, to], id) => ({
        id,
        x: between(from[0], to[0], share),
        y: between(from[1], to[1], share),
      }));
    await touch.send('Input.dispatchTouchEvent', {
      type: 'touchStart',
      touchPoints: points(0),
    });
    for (let step = 1; step <= STEPS; step++) {
      await touch.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: points(step / STEPS),
      });
    }
    await touch.send('Input.dispatchTouchEvent', {
      type: 'touchEnd',
      touchPoints: [],
    });
  }

  it('rotates with one finger', async () => {
    const [x, y] = await viewer.stageMiddle();
    const { width } = await viewer.stageBox();
    await viewer.screenshot('phone-first');
    await viewer.after(() =>
      move([
        [x - width / 4, y + 200],
        [x + width / 4, y + 200],
      ]),
    );
    assert.equal(await viewer.edgeLetters(), 'S A I P');
  });

  it('zooms with two fingers and keeps the direction', async () => {
    const [x, y] = await viewer.stageMiddle();
    const before = await viewer.coverage();
    await viewer.after(() =>
      move(
        [
          [x - 120, y + 150],
          [x - 60, y + 150],
        ],
        [
          [x + 120, y + 150],
          [x + 60, y + 150],
        ],
      ),
    );
    const smaller = await viewer.coverage();
    assert.ok(smaller < before * 0.6, `${smaller} after ${before}`);
    assert.equal(await viewer.edgeLetters(), 'S L I R');
  });

  it('moves the lens with a finger on its grip', async () => {
    const [x, y] = await viewer.gripMiddle();
    await viewer.after(() =>
      move([
        [x, y],
        [x - 30, y + 20],
      ]),
    );
    const [moved_x, moved_y] = await viewer.gripMiddle();
    assert.ok(
      Math.hypot(moved_x - (x - 30), moved_y - (y + 20)) < 4,
      `the grip is at ${moved_x}, ${moved_y}`,
    );
  });

  it('counts in device pixels', async () => {
    const { width } = await viewer.stageBox();
    await viewer.openTab('View');
    await viewer.settled();
    const pixels = width * PHONE.deviceScaleFactor;
    await viewer.page.locator('dd', { hasText: new RegExp(`of ${pixels}×`) }).waitFor();
  });

  it('opens the panel as a sheet and closes it again', async () => {
    const { height } = await viewer.stageBox();
    await viewer.page.getByRole('tab', { name: 'Adjust' }).tap();
    await viewer.page.locator('#tabpanel').waitFor();
    await viewer.settled();
    assert.ok((await viewer.stageBox()).height < height - 200);
    await viewer.screenshot('phone-adjust');
    await viewer.page.getByRole('tab', { name: 'Adjust' }).tap();
    await viewer.page.locator('#tabpanel').waitFor({ state: 'hidden' });
    await viewer.settled();
    assert.equal((await viewer.stageBox()).height, height);
  });
});
