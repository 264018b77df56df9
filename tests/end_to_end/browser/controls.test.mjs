// The panel's controls: they come after the first picture, and show no more than what does something.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { servedPage } from './support/suite.mjs';
import { meanDifference } from './support/viewer.mjs';

const LEAST_CHANGE = 0.05;

/** The page anew, with the code of the controls held back until that is let go. */
async function withoutControls({ page }) {
  let letGo;
  const held = new Promise((resolve) => (letGo = resolve));
  await page.route('**/assets/controls-*.js', async (route) => {
    await held;
    await route.continue();
  });
  await page.reload();
  return letGo;
}

for (const [name, device] of Object.entries({
  desktop: DESKTOP,
  phone: PHONE,
})) {
  describe(`controls that come late, ${name}`, { skip: skip || isStandIn }, () => {
    let viewer, letGo;
    servedPage(device, async (page) => {
      viewer = page;
      letGo = await withoutControls(viewer);
      await viewer.settled();
    });

    it('push nothing aside where they are awaited', async () => {
      await viewer.openTab('Styles');
      await viewer.page.evaluate(() => {
        const shading = { name: 'tone' };
        const { commands } = document.querySelector('cutaway-app').session;
        commands.change({ focus: { shading }, context: { shading } });
      });
      const sliders = viewer.page.locator('cutaway-detail-sliders cutaway-control');
      await sliders.nth(1).waitFor();
      const first = viewer.page.locator('[data-style]').first();
      const awaited = await first.boundingBox();
      letGo();
      await viewer.page.getByRole('slider', { name: 'Focus' }).waitFor();
      const there = await first.boundingBox();
      assert.ok(Math.abs(there.y - awaited.y) < 1, `${awaited.y} to ${there.y}`);
    });

    it('leave the focus where it is', async () => {
      const tab = viewer.page.getByRole('tab', { name: 'Adjust' });
      await tab.focus();
      await tab.press('Enter');
      await viewer.page.locator('#tabpanel').getByText('Waiting for the server').waitFor();
      letGo();
      await viewer.page.locator('cutaway-adjust-tab').waitFor();
      assert.equal(await tab.evaluate((element) => element.matches(':focus')), true);
    });
  });
}

describe('surface, light and wall', { skip: skip || isStandIn }, () => {
  let viewer;
  servedPage(DESKTOP, async (page) => {
    viewer = page;
    await viewer.openTab('Adjust');
  });
  const slider = (name) => viewer.page.getByRole('slider', { name, exact: true });
  const scene = () =>
    viewer.page.evaluate(() => document.querySelector('cutaway-app').session.store.state.scene);

  async function choose(label, option) {
    await viewer.page.getByRole('combobox', { name: label }).click();
    await viewer.page.getByRole('option', { name: option, exact: true }).click();
  }

  async function changes(action) {
    const before = await viewer.pixels();
    await viewer.after(action);
    assert.ok(meanDifference(before, await viewer.pixels()) > LEAST_CHANGE);
  }

  it('change the picture, and go back step by step', async () => {
    await viewer.after(() => slider('Focus: Shadow').press('Home'));
    await changes(() => slider('Focus: Ambient occlusion').press('End'));
    assert.equal((await scene()).focus.occlusion.strength, 1);
    await viewer.after(() => viewer.page.getByRole('button', { name: 'Undo' }).click());
    assert.notEqual((await scene()).focus.occlusion.strength, 1);
  });

  it('ask for a funnel’s angle and a smoothing’s width only where there is one', async () => {
    await viewer.after(() => choose('Lens: Opening', 'Funnel'));
    await slider('Lens: Funnel angle').waitFor();
    await viewer.after(() => choose('Lens: Opening', 'Closed'));
    await slider('Lens: Funnel angle').waitFor({ state: 'detached' });
    await viewer.after(() => choose('Focus: Smoothing', 'In millimetres'));
    await slider('Focus: Smoothing width').waitFor();
    await viewer.after(() => choose('Focus: Smoothing', 'Off'));
    await slider('Focus: Smoothing width').waitFor({ state: 'detached' });
    assert.equal((await scene()).focus.normals.scale_mm, 0);
  });

  it('give the cavity’s wall a colour, until the lens is put back', async () => {
    const strength = slider('Lens, Wall of the cavity: Strength of its colour');
    const reset = viewer.page.getByRole('button', { name: 'Lens: reset' });
    await viewer.after(() => strength.press('Home'));
    await changes(() => strength.press('End'));
    assert.equal((await scene()).lens.wall.strength, 1);
    await viewer.after(() => reset.click());
    assert.notEqual((await scene()).lens.wall.strength, 1);
  });

  it('say why they are gone where light goes through a surface', async () => {
    await viewer.after(() => slider('Focus: Opacity').press('ArrowLeft'));
    await slider('Focus: Shadow').waitFor({ state: 'detached' });
    await viewer.page.getByText('On opaque surfaces only').first().waitFor();
  });
});
