// A student's day: the vessels of the head are looked for with the lens, get another style, and are
// shown to someone else.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { served } from './support/suite.mjs';
import { meanDifference, Viewer } from './support/viewer.mjs';

/** What contrast medium in the phantom's vessels measures, at least and at most. */
const VESSEL_HU = [150, 450];

describe('a student’s day', { skip: skip || (isStandIn && 'draws no volume') }, () => {
  const suite = served();

  it('finds the vessels with the lens, changes the style, and shares what is seen', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, {
      ...DESKTOP,
      permissions: ['clipboard-read', 'clipboard-write'],
    });
    const { page } = viewer;
    await viewer.settled();
    await showVessels(viewer);
    const [x, y] = await vesselUnderLens(viewer);
    await probe(viewer, [x, y]);
    await page.keyboard.press('Escape');
    await viewer.openTab('Styles');
    await viewer.pictured('anatomy-atlas');
    await viewer.after(() => page.locator('[data-style=anatomy-atlas]').click());
    await viewer.screenshot('student-vessels');
    await assertAccessible(viewer, 'the vessels found');

    await page.getByRole('button', { name: 'Copy a link to this view' }).click();
    await page.locator('[data-part=toast]').waitFor();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    await viewer.settled();
    const picture = await viewer.pixels();
    const friend = await Viewer.open(suite.browser, link, DESKTOP);
    await friend.settled();
    const off = meanDifference(picture, await friend.pixels());
    assert.ok(off < 0.5, `the pictures differ by ${off} of 255`);
    await friend.close();
    await viewer.close();
  });
});

/** The focus is what the tissue's chip says; the lens is dragged from the face to the temple. */
async function showVessels(viewer) {
  const { page } = viewer;
  await viewer.openTab('Adjust');
  const chips = page.getByRole('group', { name: 'Focus: Tissue' });
  await viewer.after(() => chips.locator('[data-tissue=contrast_vessels]').click());
  const grip = await viewer.gripMiddle();
  await viewer.after(() => viewer.drag(grip, [grip[0], grip[1] - 60]));
}

/** A point of the screen in the lens where something of the focus' colour is drawn. */
async function vesselUnderLens(viewer) {
  const [middle_x, middle_y] = await viewer.lensMiddle();
  const radius = 0.35 * (await viewer.lensWidth());
  const box = await viewer.stageBox();
  const { data, width } = await viewer.pixels();
  const step = 4; // of the picture that pixels() gives
  let best = { warmth: 0 };
  for (let y = middle_y - radius; y < middle_y + radius; y += step) {
    for (let x = middle_x - radius; x < middle_x + radius; x += step) {
      const at = 4 * (Math.round((y - box.y) / step) * width + Math.round((x - box.x) / step));
      const warmth = data[at] - data[at + 2];
      if (warmth > best.warmth) best = { warmth, point: [x, y] };
    }
  }
  assert.ok(best.warmth > 90, 'nothing of the focus is seen in the lens');
  return best.point;
}

/** The probe says what is there: a vessel, by its value. */
async function probe(viewer, [x, y]) {
  const { page } = viewer;
  await page.locator('[data-tool=probe]').click();
  await page.mouse.click(x, y);
  const label = page.locator('cutaway-measure-overlay [data-measurement]').first();
  await label.waitFor();
  const value = Number.parseFloat(/(-?[\d,.]+) HU/.exec(await label.getAttribute('title'))[1]);
  const [lowest, highest] = VESSEL_HU;
  assert.ok(value > lowest - 30 && value < highest + 30, `${value} HU is no vessel`);
}
