// The page with mouse and keyboard at 1440x900.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { served, servedPage } from './support/suite.mjs';
import { meanDifference, Viewer } from './support/viewer.mjs';

const VISIBLE_CHANGE = 0.5;
const SAME_PICTURE = 0.5;

describe('the page on a desktop', { skip }, () => {
  let viewer;
  const suite = servedPage(DESKTOP, (page) => (viewer = page));

  it('shows a first picture from the front, and says what it is', async () => {
    const coverage = await viewer.coverage();
    assert.ok(coverage > 0.08 && coverage < 0.9, `the volume covers ${coverage} of the picture`);
    assert.equal(await viewer.edgeLetters(), 'S L I R');
    await viewer.page
      .locator('[data-part=notice]', { hasText: /not for diagnostic use/i })
      .waitFor();
    await viewer.page.locator('[data-part=lossy]').waitFor();
    await viewer.screenshot('desktop-first');
  });

  it('rotates with a drag: a quarter turn to the right shows the patient’s right side', async () => {
    const before = await viewer.pixels();
    const [x, y] = await viewer.stageMiddle();
    const { width, height } = await viewer.stageBox();
    const quarter = Math.min(width, height) / 2;
    await viewer.after(() => viewer.drag([x - quarter / 2, y + 180], [x + quarter / 2, y + 180]));
    assert.equal(await viewer.edgeLetters(), 'S A I P');
    assert.ok(meanDifference(before, await viewer.pixels()) > VISIBLE_CHANGE);
    await viewer.screenshot('desktop-rotated');
  });

  it('zooms with the wheel and with a right drag', async () => {
    const [x, y] = await viewer.stageMiddle();
    const first = await viewer.coverage();
    await viewer.page.mouse.move(x, y);
    await viewer.after(() => viewer.page.mouse.wheel(0, 300));
    const smaller = await viewer.coverage();
    assert.ok(smaller < first * 0.8, `${smaller} after zooming out of ${first}`);
    await viewer.after(() => viewer.drag([x, y + 200], [x, y + 100], { button: 'right' }));
    assert.ok((await viewer.coverage()) > smaller * 1.2);
  });

  it('pans with Shift and a drag', async () => {
    const [x, y] = await viewer.stageMiddle();
    const before = await viewer.gripMiddle();
    await viewer.page.keyboard.down('Shift');
    await viewer.after(() => viewer.drag([x - 100, y + 200], [x, y + 150]));
    await viewer.page.keyboard.up('Shift');
    const moved = await viewer.gripMiddle();
    const [right, down] = [moved[0] - before[0], moved[1] - before[1]];
    // The lens lies nearer than the target, whose depth follows the pointer.
    assert.ok(right >= 100 && right < 150 && down <= -50 && down > -75, `by ${right}, ${down}`);
  });

  it('moves the lens with its grip, over the surface', async () => {
    const before = await viewer.pixels();
    const [x, y] = await viewer.gripMiddle();
    await viewer.after(() => viewer.drag([x, y], [x - 40, y - 30]));
    const [moved_x, moved_y] = await viewer.gripMiddle();
    assert.ok(
      Math.hypot(moved_x - (x - 40), moved_y - (y - 30)) < 4,
      `the grip is at ${moved_x}, ${moved_y}`,
    );
    assert.ok(meanDifference(before, await viewer.pixels()) > 0.1);
  });

  it('resizes the lens with Alt and the wheel, with its rim, and in the panel', async () => {
    const [x, y] = await viewer.stageMiddle();
    const first = await viewer.lensWidth();
    await viewer.page.mouse.move(x, y);
    await viewer.page.keyboard.down('Alt');
    await viewer.after(() => viewer.page.mouse.wheel(0, -200));
    await viewer.page.keyboard.up('Alt');
    const larger = await viewer.lensWidth();
    assert.ok(larger > first * 1.2, `${larger} after ${first}`);
    const rim = await viewer.gripMiddle('lens-size-grip');
    await viewer.after(() => viewer.drag(rim, [rim[0] - 30, rim[1]]));
    const smaller = await viewer.lensWidth();
    assert.ok(smaller < larger - 30, `${smaller} after ${larger}`);
    await viewer.openTab('Adjust');
    const radius = viewer.page.getByRole('spinbutton', {
      name: 'Lens: Radius',
    });
    await viewer.after(async () => {
      await radius.fill('20');
      await radius.press('Enter');
    });
    assert.equal(await radius.inputValue(), '20');
    await viewer.screenshot('desktop-adjust');
  });

  it('does it all with the keyboard', async () => {
    await viewer.page.locator('[data-part=stage]').focus();
    const grip = await viewer.gripMiddle();
    const width = await viewer.lensWidth();
    await viewer.after(() => viewer.page.keyboard.press('Shift+ArrowRight'));
    assert.ok((await viewer.gripMiddle())[0] > grip[0] + 4);
    await viewer.after(() => viewer.page.keyboard.press(']'));
    assert.ok((await viewer.lensWidth()) > width * 1.03);
    for (let presses = 0; presses < 12; presses++)
      await viewer.after(() => viewer.page.keyboard.press('ArrowRight'));
    assert.notEqual(await viewer.edgeLetters(), 'S L I R');
    await viewer.after(() => viewer.page.keyboard.press('r'));
    assert.equal(await viewer.edgeLetters(), 'S L I R');
    await viewer.page.keyboard.press('?');
    await viewer.page.getByRole('dialog', { name: 'Help' }).waitFor();
    await viewer.screenshot('desktop-help');
    await viewer.page.keyboard.press('Escape');
    await viewer.page.getByRole('dialog', { name: 'Help' }).waitFor({ state: 'hidden' });
  });

  it('puts a style on', async () => {
    await viewer.openTab('Styles');
    const porcelain = viewer.page.locator('[data-style=porcelain]');
    await viewer.after(() => porcelain.click());
    await viewer.page.locator('[data-style=porcelain][aria-pressed=true]').waitFor();
    const { data } = await viewer.pixels();
    const expected = [0.85, 0.86, 0.88].map((part) => part * 255);
    expected.forEach((part, index) =>
      assert.ok(Math.abs(data[index] - part) < 8, `corner colour ${data.slice(0, 3)}`),
    );
    await viewer.screenshot('desktop-porcelain');
  });

  it('changes shading, filters and colours in the panel', async () => {
    await viewer.openTab('Adjust');
    const removal = viewer.page.getByRole('button', {
      name: /^Focus, .*: remove$/,
    });
    const before = await removal.count();
    await viewer.after(() =>
      viewer.page.getByRole('button', { name: 'Focus: add Kuwahara' }).click(),
    );
    assert.equal(await removal.count(), before + 1);
    await viewer.after(() => removal.last().click());
    assert.equal(await removal.count(), before);
    const first = await viewer.pixels();
    const shading = viewer.page.getByRole('combobox', { name: 'Shading' }).first();
    await viewer.after(async () => {
      await shading.click();
      await viewer.page.getByRole('option', { name: 'Phong' }).first().click();
    });
    assert.ok(meanDifference(first, await viewer.pixels()) > 0.1);
  });

  it('opens another volume and shows its progress', async () => {
    await viewer.openTab('Volumes');
    await viewer.screenshot('desktop-volumes');
    const shown = await viewer.data('volume');
    await viewer.page.evaluate(() => {
      globalThis.stagesSeen = new Set();
      const app = document.querySelector('cutaway-app');
      new MutationObserver(() => globalThis.stagesSeen.add(app.dataset.loading)).observe(app, {
        attributes: true,
      });
    });
    const other = viewer.page.locator(`[data-volume]:not([data-volume="${shown}"])`).first();
    const id = await other.getAttribute('data-volume');
    await viewer.after(async () => {
      await other.click();
      await viewer.app(`[data-volume="${id}"]`).waitFor();
    });
    const stages = await viewer.page.evaluate(() => [...globalThis.stagesSeen].filter(Boolean));
    assert.ok(stages.length > 0, 'no progress was seen');
    await viewer.page.locator(`[data-volume="${id}"][aria-current=true]`).waitFor();
    await viewer.screenshot('desktop-other-volume');
  });

  it('shows the same view after a reload, and to someone else', async () => {
    const [x, y] = await viewer.stageMiddle();
    await viewer.after(() => viewer.drag([x - 60, y + 200], [x + 60, y + 160]));
    await viewer.openTab('Styles');
    await viewer.after(() => viewer.page.locator('[data-style=toon]').click());
    const letters = await viewer.edgeLetters();
    const picture = await viewer.pixels();
    await viewer.app('[data-address=current]').waitFor();
    await viewer.page.reload();
    await viewer.settled();
    await viewer.openTab('Styles');
    await viewer.page.locator('[data-style=toon][aria-pressed=true]').waitFor();
    assert.equal(await viewer.edgeLetters(), letters);
    assert.ok(meanDifference(picture, await viewer.pixels()) < SAME_PICTURE);
    const other = await Viewer.open(suite.browser, viewer.page.url(), DESKTOP);
    await other.settled();
    await viewer.looksLike(other, SAME_PICTURE);
    await other.close();
  });
});

describe('a link that cannot be opened', { skip }, () => {
  const suite = served();

  for (const hash of ['#1.broken', '#0.old', '#1.q1YqS8xRsqpWSswrVrJSMjZV0lEqLi0oKMovAwA']) {
    it(`leads to a message and a working page: ${hash}`, async () => {
      const viewer = await Viewer.open(suite.browser, `${suite.server.url}${hash}`, DESKTOP);
      await viewer.page
        .locator('[data-part=toast]', {
          hasText: 'This link could not be opened',
        })
        .waitFor();
      await viewer.settled();
      assert.equal(await viewer.edgeLetters(), 'S L I R');
      await viewer.close();
    });
  }
});
