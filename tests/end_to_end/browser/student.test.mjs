// A student's day: the vessels of the head are looked for with the lens, get another style, and are
// shown to someone else.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { Slices } from './support/slices.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

/** What contrast medium in the phantom's vessels measures, at least and at most. */
const VESSEL_HU = [250, 450];
/** In the left common carotid artery of the head phantom; patient space, LPS. */
const CAROTID_MM = [27, 1, -110];

describe('a student’s day', { skip: skip || (isStandIn && 'draws no volume') }, () => {
  const suite = served();

  it('finds the vessels with the lens, changes the style, and shares what is seen', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, {
      ...DESKTOP,
      permissions: ['clipboard-read', 'clipboard-write'],
    });
    const { page } = viewer;
    await viewer.settled();
    const slices = new Slices(viewer);
    await slices.choose('grid');
    await viewer.openTab('Adjust');
    const chips = page.getByRole('group', { name: 'Focus: Tissue' });
    await viewer.after(() => chips.locator('[data-tissue=contrast_vessels]').click());
    await takeLensTo(viewer, slices);
    await readsVessel(slices);
    await viewer.screenshot('student-slices');
    assert.ok((await warmthInLens(viewer)) > 60, 'the lens shows nothing where the artery is');
    await page.locator('cutaway-layout-choice [data-layout=single]').click();
    await slices.of('axial').waitFor({ state: 'detached' });
    await viewer.settled();
    await viewer.openTab('Styles');
    await viewer.pictured('anatomy-atlas');
    await viewer.after(() => page.locator('[data-style=anatomy-atlas]').click());
    await viewer.screenshot('student-vessels');
    await assertAccessible(viewer, 'the vessels found');

    await page.getByRole('button', { name: 'Copy a link to this view' }).click();
    await page.locator('[data-part=toast]').waitFor();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    await viewer.settled();
    const friend = await Viewer.open(suite.browser, link, DESKTOP);
    await friend.settled();
    await viewer.looksLike(friend, 0.5);
    await friend.close();
    await viewer.close();
  });
});

/** In the slices, with the lens on the crosshair: down to the neck, then onto the artery. */
async function takeLensTo(viewer, slices) {
  const { page } = viewer;
  await slices.stage('coronal').focus();
  await viewer.after(() => page.keyboard.press('l'));
  const [x, y, z] = CAROTID_MM;
  for (const [slice, off_mm] of [
    ['coronal', [x, -z]],
    ['axial', [0, y]],
  ]) {
    const scale = await slices.pixelsPerMm(slice);
    const at = await slices.crosshair(slice);
    await viewer.after(() =>
      page.mouse.click(...at.map((part, axis) => part + scale * off_mm[axis])),
    );
    await slices.settled();
  }
}

/** The value under the pointer on the crosshair of the axial slice. */
async function readsVessel(slices) {
  const [x, y] = await slices.crosshair('axial');
  await slices.page.mouse.move(x + 1, y + 1);
  const hover = slices.part('axial', 'slice-hover');
  await hover.getByText(/HU/).waitFor();
  const value = Number.parseFloat(/(-?[\d,.]+) HU/.exec(await hover.textContent())[1]);
  const [lowest, highest] = VESSEL_HU;
  assert.ok(value > lowest && value < highest, `${value} HU is no contrast medium`);
}

/** How much redder than blue the 3-D picture is at most, about the lens' middle: as the focus is. */
async function warmthInLens(viewer) {
  const [x_px, y_px] = await viewer.gripMiddle();
  const box = await viewer.stageBox();
  const { data, width } = await viewer.pixels();
  const step = 4; // of the picture that pixels() gives
  const reach = 5;
  const column = Math.round((x_px - box.x) / step);
  const row = Math.round((y_px - box.y) / step);
  let warmest = 0;
  for (let y = row - reach; y <= row + reach; y++) {
    for (let x = column - reach; x <= column + reach; x++) {
      const at = 4 * (y * width + x);
      warmest = Math.max(warmest, data[at] - data[at + 2]);
    }
  }
  return warmest;
}
