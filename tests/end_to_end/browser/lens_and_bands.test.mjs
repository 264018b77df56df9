// The Magic Lens, the lens under the pointer and in millimetres, and bands with two ends.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { linkTo } from './support/scene_link.mjs';
import { served, servedPage } from './support/suite.mjs';
import { meanDifference, Viewer } from './support/viewer.mjs';

const VISIBLE_CHANGE = 0.1;
/** The outline's middle is not quite the projected centre of a sphere near the eye. */
const NEAR_PX = 14;

describe('lens and bands', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, (page) => (viewer = page));

  const setNumber = (name, value) =>
    viewer.after(async () => {
      await viewer.number(name).fill(String(value));
      await viewer.number(name).press('Enter');
    });

  async function assertLensAt([x, y]) {
    const [lens_x, lens_y] = await viewer.lensMiddle();
    const distance = Math.hypot(lens_x - x, lens_y - y);
    assert.ok(distance < NEAR_PX, `the lens is at ${lens_x}, ${lens_y}, not at ${x}, ${y}`);
  }

  it('shows for each mode what it reads', async () => {
    await viewer.openTab('Adjust');
    const cap = viewer.page.getByRole('combobox', {
      name: 'Lens: Cut surfaces',
    });
    await cap.waitFor();
    const cutaway = await viewer.pixels();
    await viewer.after(() => viewer.choose('Lens: Mode', 'Magic'));
    await cap.waitFor({ state: 'hidden' });
    const magic = await viewer.pixels();
    assert.ok(meanDifference(cutaway, magic) > VISIBLE_CHANGE);
    await viewer.number('Lens: Soft rim, number').waitFor();
    await viewer.page.getByRole('switch', { name: 'Lens: Fade the context everywhere' }).waitFor();
    await setNumber('Lens: Strength, number', 0.2);
    assert.ok(meanDifference(magic, await viewer.pixels()) > VISIBLE_CHANGE);
    await viewer.screenshot('desktop-magic-lens');
    await viewer.after(() => viewer.choose('Lens: Mode', 'None'));
    await viewer.number('Lens: Radius, number').waitFor({ state: 'hidden' });
  });

  it('goes back to the Magic Lens that was switched off by key', async () => {
    await viewer.openTab('Styles');
    await viewer.after(() => viewer.page.locator('[data-style=magic-lens]').click());
    await viewer.page.locator('[data-part=stage]').focus();
    await viewer.after(() => viewer.page.keyboard.press('x'));
    await viewer.after(() => viewer.page.keyboard.press('x'));
    await viewer.page.locator('[data-style=magic-lens][aria-pressed=true]').waitFor();
  });

  it('follows the pointer until Escape, and until the camera is dragged', async () => {
    const [x, y] = await viewer.stageMiddle();
    const { mouse, keyboard } = viewer.page;
    const button = viewer.page.getByRole('button', {
      name: 'Lens follows the pointer',
    });
    await viewer.page.locator('[data-part=stage]').focus();
    await keyboard.press('f');
    assert.equal(await button.getAttribute('aria-pressed'), 'true');
    await viewer.after(() => mouse.move(x - 70, y - 50, { steps: 10 }));
    await assertLensAt([x - 70, y - 50]);
    await viewer.screenshot('desktop-lens-follows');
    await keyboard.press('Escape');
    assert.equal(await button.getAttribute('aria-pressed'), 'false');
    const sent = await viewer.data('sent');
    await mouse.move(x, y, { steps: 5 });
    await viewer.page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
    assert.equal(await viewer.data('sent'), sent);
    await button.click();
    assert.equal(await button.getAttribute('aria-pressed'), 'true');
    await viewer.after(() => mouse.move(x + 20, y + 30, { steps: 5 }));
    await assertLensAt([x + 20, y + 30]);
    await viewer.after(() => viewer.drag([x - 100, y + 200], [x + 100, y + 200]));
    assert.equal(await button.getAttribute('aria-pressed'), 'false');
  });

  it('lies where its millimetres say', async () => {
    await viewer.openTab('Adjust');
    await viewer.page.locator('[data-part=stage]').focus();
    const [x, y] = await viewer.lensMiddle();
    const left = viewer.number('Lens: Centre towards left (L), mm');
    const superior = viewer.number('Lens: Centre towards superior (S), mm');
    const [left_mm, superior_mm] = [await left.inputValue(), await superior.inputValue()].map(
      Number,
    );
    await setNumber('Lens: Centre towards left (L), mm', left_mm + 20);
    await setNumber('Lens: Centre towards superior (S), mm', superior_mm + 10);
    const [moved_x, moved_y] = await viewer.lensMiddle();
    const ratio = (moved_x - x) / (y - moved_y);
    assert.ok(moved_x > x + 20, `from ${x} to ${moved_x}: the patient's left is on the right`);
    assert.ok(Math.abs(ratio - 2) < 0.2, `20 mm by 10 mm appear as ${ratio} to 1`);
  });

  it('gives a band an upper end and takes it away', async () => {
    await viewer.openTab('Adjust');
    const ends = viewer.page.locator('cutaway-histogram').first().locator('line');
    assert.equal(await ends.count(), 1);
    await viewer.after(() => viewer.toggle('Focus: Upper end'));
    assert.equal(await ends.count(), 2);
    const before_change = await viewer.pixels();
    await setNumber('Focus: Upper value, number', 400);
    await setNumber('Focus: Lower end (iso-value), number', 1000);
    assert.ok(
      Number(await viewer.number('Focus: Lower end (iso-value), number').inputValue()) < 400,
    );
    await setNumber('Focus: Opacity, number', 0.1);
    if (!isStandIn)
      assert.ok(meanDifference(before_change, await viewer.pixels()) > VISIBLE_CHANGE);
    await viewer.screenshot('desktop-band');
    await viewer.after(() => viewer.toggle('Focus: Upper end'));
    await viewer.number('Focus: Upper value, number').waitFor({ state: 'hidden' });
    assert.equal(await ends.count(), 1);
  });
});

describe('a refused scene', { skip }, () => {
  const suite = served();

  it('is answered with its field and what was expected', async () => {
    const scene = { version: 1, volume: 'phantom:head', lens: { strength: 7 } };
    const viewer = await Viewer.open(suite.browser, `${suite.server.url}${linkTo(scene)}`, DESKTOP);
    const toast = viewer.page.locator('[data-part=toast]');
    await toast.filter({ hasText: /Field: \/lens\/strength\. Expected: .*1/ }).waitFor();
    await viewer.settled();
    await viewer.close();
  });
});
