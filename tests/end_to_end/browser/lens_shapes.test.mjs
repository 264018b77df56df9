// Lenses that are no sphere: chosen, sized, turned by hand, and outlined in 3-D and in slices.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { servedPage } from './support/suite.mjs';
import { meanDifference } from './support/viewer.mjs';

const VISIBLE_CHANGE = 0.1;
const A_BOX_HAS = 6;
const A_BALL_HAS = 24;

const skipped = skip || (isStandIn && 'the stand-in draws spheres alone');

describe('the shape of the lens', { skip: skipped }, () => {
  let viewer;
  servedPage(DESKTOP, async (page) => {
    viewer = page;
    await viewer.openTab('Adjust');
  });

  const corners = async (overlay) => {
    const points = await viewer.page.locator(`${overlay} polygon`).last().getAttribute('points');
    return points.trim().split(' ').length;
  };

  it('is chosen, and its outline follows', async () => {
    assert.ok((await corners('cutaway-lens-overlay')) >= A_BALL_HAS);
    const ball = await viewer.pixels();
    for (const shape of ['Ellipsoid', 'Cylinder', 'Cone', 'Box']) {
      await viewer.after(() => viewer.choose('Lens: Shape', shape));
      await viewer.screenshot(`desktop-lens-${shape.toLowerCase()}`);
    }
    assert.ok(meanDifference(ball, await viewer.pixels()) > VISIBLE_CHANGE);
    const found = await corners('cutaway-lens-overlay');
    assert.ok(found >= 4 && found <= A_BOX_HAS, `a box has ${found} corners`);
  });

  it('is turned by its grip, and by its angles in the panel', async () => {
    assert.equal(await viewer.page.locator('[data-part=lens-turn-grip]').count(), 0);
    await viewer.after(() => viewer.choose('Lens: Shape', 'Cylinder'));
    const before = await viewer.pixels();
    const [x, y] = await viewer.gripMiddle('lens-turn-grip');
    await viewer.after(() => viewer.drag([x, y], [x + 60, y]));
    const turned = Number(await viewer.number('Lens: Turned to the left, number').inputValue());
    assert.ok(turned > 5, `turned by ${turned} degrees`);
    assert.ok(meanDifference(before, await viewer.pixels()) > VISIBLE_CHANGE);
    await viewer.after(async () => {
      await viewer.number('Lens: Turned to the left, number').fill('0');
      await viewer.number('Lens: Turned to the left, number').press('Enter');
    });
    assert.ok(meanDifference(before, await viewer.pixels()) < VISIBLE_CHANGE);
  });

  it('is as large as its grip says', async () => {
    await viewer.after(() => viewer.choose('Lens: Shape', 'Box'));
    const before = await viewer.lensWidth();
    const [x, y] = await viewer.gripMiddle('lens-size-grip');
    const [middle_x] = await viewer.lensMiddle();
    await viewer.after(() => viewer.drag([x, y], [x + (x - middle_x) * 0.3, y]));
    const ratio = (await viewer.lensWidth()) / before;
    assert.ok(ratio > 1.1 && ratio < 1.5, `grown by ${ratio}`);
  });

  it('is cut by slices as it is', async () => {
    await viewer.after(() => viewer.choose('Lens: Shape', 'Box'));
    await viewer.page.locator('[data-part=stage]').focus();
    await viewer.page.keyboard.press('g');
    await viewer.page.locator('cutaway-slice-lens polygon').first().waitFor();
    const found = await corners('cutaway-slice-lens');
    assert.ok(found >= 3 && found <= A_BOX_HAS, `its cut has ${found} corners`);
    await viewer.settled();
    await viewer.screenshot('desktop-lens-box-slices');
  });
});
