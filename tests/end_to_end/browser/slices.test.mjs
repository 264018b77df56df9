// Slices beside the 3-D picture: layouts, what links them, their gestures and keys, and measuring on
// a volume of which every value is known.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip, TABLET } from './support/browser.mjs';
import { metaImage } from './support/meta_image.mjs';
import { linkTo } from './support/scene_link.mjs';
import { isStandIn } from './support/server.mjs';
import { Slices } from './support/slices.mjs';
import { served, servedPage } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const SPACING_MM = [1, 1.5, 2];
/** In the patient's left, anterior, superior part. */
const BALL = { centre_mm: [20, -15, 12], radius_mm: 10 };
const BALL_HU = 300;
const valueAt = (at_mm) => {
  const distance_mm = Math.hypot(...at_mm.map((part, axis) => part - BALL.centre_mm[axis]));
  return distance_mm < BALL.radius_mm ? BALL_HU : -500;
};

describe('slices of a known volume', { skip: skip || (isStandIn && 'needs files') }, () => {
  let viewer, slices;
  const suite = served(async (folder) => {
    const size = [96, 64, 48];
    await writeFile(join(folder, 'ball.mha'), metaImage({ size, spacing_mm: SPACING_MM, valueAt }));
  });

  async function open(said = {}) {
    const scene = {
      version: 1,
      volume: 'ball.mha',
      context: { surface: { iso_value: -100 } },
      lens: { mode: 'none' },
      slices: {
        crosshair_mm: BALL.centre_mm,
        window: { centre: 0, width: 1000 },
        ...said,
      },
    };
    viewer = await Viewer.open(suite.browser, `${suite.server.url}${linkTo(scene)}`, DESKTOP);
    await viewer.settled();
    slices = new Slices(viewer);
    await slices.choose('grid');
  }

  it('has left on the side that the convention says, and the shared link says it', async () => {
    for (const [convention, letters] of [
      ['radiological', ['A L P R', 'S L I R', 'S P I A']],
      ['neurological', ['A R P L', 'S R I L', 'S P I A']],
    ]) {
      await open({ convention });
      const names = ['axial', 'coronal', 'sagittal'];
      assert.deepEqual(await Promise.all(names.map((name) => slices.letters(name))), letters);
      const [x] = await slices.crosshair('axial');
      const box = await slices.box('axial');
      assert.equal(x > box.x + box.width / 2, convention === 'radiological');
      // The picture agrees with what is drawn over it: the ball is there, and not at the mirror's place.
      const [ball_x, ball_y] = await slices.crosshair('axial');
      const off_px = 6 * (await slices.pixelsPerMm('axial'));
      const bright = await slices.brightness([ball_x + off_px, ball_y + off_px]);
      const mirrored = [2 * (box.x + box.width / 2) - ball_x - off_px, ball_y + off_px];
      assert.ok(bright > 180, `${bright} in the ball`);
      assert.ok((await slices.brightness(mirrored)) < 60, 'nothing on the other side');
      await viewer.close();
    }
  });

  it('measures a known distance, and shows it where it lies', async () => {
    await open();
    const [x, y] = await slices.crosshair('axial');
    const px = await slices.pixelsPerMm('axial');
    await viewer.page.locator('[data-tool=distance]').click();
    await viewer.page.mouse.click(x - 15 * px, y);
    await viewer.page.getByText('Choose the second point').waitFor();
    await viewer.page.mouse.click(x + 10 * px, y);
    const label = slices.of('axial').locator('cutaway-measure-overlay [data-measurement]');
    await label.waitFor();
    const length_mm = Number.parseFloat(/: ([\d.]+) mm/.exec(await label.getAttribute('title'))[1]);
    assert.ok(Math.abs(length_mm - 25) < 1, `${length_mm} mm`);
    await viewer.page.keyboard.press('Escape');
    await slices.stage('axial').focus();
    await viewer.page.keyboard.press('PageUp');
    await slices.settled();
    await label.waitFor({ state: 'detached' });
    await slices.of('axial').locator('cutaway-measure-overlay .off').waitFor();
    await viewer.close();
  });

  it('reads the value under the pointer', async () => {
    await open();
    const [x, y] = await slices.crosshair('coronal');
    await viewer.page.mouse.move(x + 3, y + 3);
    const hover = slices.part('coronal', 'slice-hover');
    await hover.waitFor();
    assert.match(
      (await hover.textContent()).trim(),
      /^300 HU · L 2\d\.\d · A 1\d\.\d · S 1\d\.\d mm$/,
    );
    // The pointer rests, and the slice under it becomes another.
    const anterior_mm = async () => Number(/A ([\d.]+)/.exec(await hover.textContent())?.[1]);
    const before_mm = await anterior_mm();
    await slices.stage('coronal').focus();
    await viewer.page.keyboard.press('ArrowUp');
    await slices.until(async () => (await anterior_mm()) > before_mm);
    await viewer.page.mouse.move(5, 5);
    await hover.waitFor({ state: 'detached' });
    await viewer.close();
  });
});

describe('the slices on a desktop', { skip }, () => {
  let viewer, slices;
  servedPage(DESKTOP, async (page) => {
    viewer = page;
    slices = new Slices(page);
    await slices.choose('grid');
  });
  const page = () => viewer.page;

  it('are laid out in three ways, remembered, and any of them is enlarged', async () => {
    for (const layout of ['grid', 'focus']) {
      await slices.choose(layout);
      await assertAccessible(viewer, layout);
      await viewer.screenshot(`desktop-slices-${layout}`);
    }
    await slices.part('coronal', 'enlarge').click();
    await slices.settled();
    const [large, small] = [await slices.box('coronal'), await slices.box('axial')];
    assert.ok(large.width > 2 * small.width);
    await slices.stage('coronal').dblclick();
    await viewer.page.locator('[data-part=views][data-layout=coronal]').waitFor();
    await slices.settled();
    await viewer.screenshot('desktop-slices-alone');
    await assertAccessible(viewer, 'one alone');
    await page().keyboard.press('z');
    await viewer.page.locator('[data-part=views][data-layout=focus]').waitFor();
    await viewer.page.reload();
    await viewer.settled();
    await slices.settled();
    assert.ok((await slices.box('coronal')).width > 2 * (await slices.box('axial')).width);
    await viewer.page.locator('[data-part=stage]').focus();
    await page().keyboard.press('g');
    await viewer.page.locator('[data-part=views][data-layout="3d"]').waitFor();
    await slices.of('axial').waitFor({ state: 'detached' });
  });

  it('are linked by the crosshair, in every picture and in one step of undo', async () => {
    const before = await slices.positions();
    await viewer.drag(await slices.at('axial', 0.5, 0.5), await slices.at('axial', 0.6, 0.35));
    await slices.settled();
    const moved = await slices.positions();
    assert.equal(moved.axial, before.axial);
    assert.match(moved.sagittal, /^L [1-9]/);
    assert.match(moved.coronal, /^A [1-9]/);
    const [x, y] = await slices.crosshair('axial');
    const [pointer_x, pointer_y] = await slices.at('axial', 0.6, 0.35);
    assert.ok(Math.hypot(x - pointer_x, y - pointer_y) < 2, `${x}, ${y}`);
    await viewer.page.locator('[data-part=crosshair-mark]').waitFor();
    await slices.stage('axial').focus();
    await page().keyboard.press('Control+z');
    await slices.settled();
    assert.deepEqual(await slices.positions(), before);
    await page().keyboard.press('Control+y');
    await slices.settled();
    assert.deepEqual(await slices.positions(), moved);
  });

  it('step with the wheel, keys and slider', async () => {
    const offset = async () =>
      Number.parseFloat(/[\d.]+/.exec((await slices.positions()).axial)[0]);
    await page().mouse.move(...(await slices.at('axial', 0.4, 0.4)));
    const start = await offset();
    await page().mouse.wheel(0, -100);
    await slices.settled();
    const step = (await offset()) - start;
    assert.ok(step > 0.5 && step < 2, `${step} mm`);
    await slices.stage('axial').focus();
    await page().keyboard.press('PageUp');
    await slices.settled();
    assert.ok(Math.abs((await offset()) - start - 11 * step) < 0.3);
    await page().keyboard.press('ArrowDown');
    await slices.settled();
    assert.ok(Math.abs((await offset()) - start - 10 * step) < 0.3);
    const slider = viewer.page.getByRole('slider', { name: 'Axial: position' });
    await slider.press('Home');
    await slices.settled();
    assert.match((await slices.positions()).axial, /^I \d\d/);
    assert.equal(await slider.getAttribute('aria-valuetext'), (await slices.positions()).axial);
  });

  it('zoom about the pointer, pan, and show all again', async () => {
    const at = await slices.at('coronal', 0.3, 0.4);
    const mm = await slices.pixelsPerMm('coronal');
    const [x, y] = await slices.crosshair('coronal');
    await page().mouse.move(...at);
    await page().keyboard.down('Control');
    await page().mouse.wheel(0, -30);
    await page().keyboard.up('Control');
    await slices.settled();
    const factor = (await slices.pixelsPerMm('coronal')) / mm;
    assert.ok(factor > 1.2, `${factor}`);
    const [zoomed_x, zoomed_y] = await slices.crosshair('coronal');
    assert.ok(Math.abs(zoomed_x - at[0] - (x - at[0]) * factor) < 2);
    assert.ok(Math.abs(zoomed_y - at[1] - (y - at[1]) * factor) < 2);
    await viewer.drag(at, [at[0] + 40, at[1] + 25], { button: 'middle' });
    await slices.settled();
    const panned = await slices.crosshair('coronal');
    assert.ok(Math.hypot(panned[0] - zoomed_x - 40, panned[1] - zoomed_y - 25) < 2);
    await slices.stage('coronal').focus();
    await page().keyboard.press('r');
    await slices.until(async () => Math.abs((await slices.pixelsPerMm('coronal')) / mm - 1) < 0.01);
  });

  it('have their window by key, by drag and in the panel', async () => {
    await slices.stage('axial').focus();
    for (const [key, text] of [
      ['3', 'W 1,800 · C 400'],
      ['2', 'W 1,500 · C -600'],
      ['1', 'W 400 · C 40'],
    ]) {
      await page().keyboard.press(key);
      await slices.settled();
      assert.equal(await slices.windowText('sagittal'), text);
    }
    await page().keyboard.down('Alt');
    await viewer.drag(await slices.at('axial', 0.4, 0.4), await slices.at('axial', 0.6, 0.4));
    await page().keyboard.up('Alt');
    await slices.settled();
    assert.notEqual(await slices.windowText('axial'), 'W 400 · C 40');
    await slices.part('axial', 'slice-window').click();
    const crosshair = await slices.positions();
    await viewer.drag(await slices.at('axial', 0.4, 0.4), await slices.at('axial', 0.4, 0.6));
    assert.deepEqual(await slices.positions(), crosshair);
    await viewer.openTab('View');
    await viewer.page.locator('[data-preset=liver]').click();
    await slices.settled();
    assert.equal(await slices.windowText('axial'), 'W 160 · C 60');
    await viewer.number('Slices: Window centre').fill('100');
    await viewer.number('Slices: Window centre').press('Enter');
    await slices.settled();
    assert.equal(await slices.windowText('axial'), 'W 160 · C 100');
    // Beyond the volume's values, where the slider does not reach.
    await viewer.number('Slices: Window centre').fill('-9000');
    await viewer.number('Slices: Window centre').press('Enter');
    await slices.settled();
    assert.equal(await slices.windowText('axial'), 'W 160 · C -9,000');
    await viewer.number('Slices: Window centre').fill('100');
    await viewer.number('Slices: Window centre').press('Enter');
    await slices.settled();
    await assertAccessible(viewer, 'the slices’ part of the panel');
    await viewer.screenshot('desktop-slices-panel');
  });

  it('are neurological where that is wanted, also after a reload', async () => {
    await viewer.openTab('View');
    await viewer.choose('Slices: Convention', 'Neurological');
    await slices.settled();
    assert.equal(await slices.letters('axial'), 'A R P L');
    await slices.part('axial', 'convention').getByText('Neurological').waitFor();
    await viewer.page.evaluate(() => history.replaceState(null, '', location.pathname));
    await viewer.page.reload();
    await viewer.settled();
    await slices.settled();
    assert.equal(await slices.letters('axial'), 'A R P L');
  });

  it('are tilted by the ends of the crosshair, and straightened', async () => {
    const grip = slices.of('coronal').locator('[data-part=tilt-grip][data-plane=axial]').first();
    const { x, y, width, height } = await grip.boundingBox();
    const [from_x, from_y] = [x + width / 2, y + height / 2];
    await page().mouse.move(from_x, from_y);
    await page().mouse.down();
    await page().mouse.move(from_x + 10, from_y + 90, { steps: 6 });
    await viewer.screenshot('desktop-slices-tilting');
    await page().mouse.up();
    await slices.settled();
    assert.match((await slices.letters('axial')).split(' ')[1], /^L[SI]$/);
    await slices.part('axial', 'convention').getByText('oblique').waitFor();
    await viewer.screenshot('desktop-slices-oblique');
    await assertAccessible(viewer, 'oblique');
    await slices.stage('axial').focus();
    await page().keyboard.press('t');
    await slices.until(async () => (await slices.letters('axial')) === 'A L P R');
  });

  it('show the lens, which is dragged there and follows the crosshair', async () => {
    const grip = slices.part('sagittal', 'slice-lens-grip');
    const before = await grip.boundingBox();
    await viewer.after(async () => {
      const middle = [before.x + before.width / 2, before.y + before.height / 2];
      await viewer.drag(middle, [middle[0] + 30, middle[1] + 20]);
    });
    const moved = await grip.boundingBox();
    assert.ok(Math.hypot(moved.x - before.x - 30, moved.y - before.y - 20) < 3);
    await slices.stage('axial').focus();
    await viewer.after(() => page().keyboard.press('l'));
    await viewer.after(async () => {
      await page().mouse.click(...(await slices.at('axial', 0.55, 0.55)));
    });
    const ring = await slices.part('axial', 'lens-cut').locator('polygon').first().boundingBox();
    const [x, y] = await slices.crosshair('axial');
    assert.ok(Math.hypot(ring.x + ring.width / 2 - x, ring.y + ring.height / 2 - y) < 3);
    await viewer.screenshot('desktop-slices-lens');
  });

  it('go to what is pressed in 3-D, which a drag still turns', async () => {
    const before = await slices.positions();
    const [x, y] = await viewer.stageMiddle();
    await page().mouse.click(x + 70, y - 60);
    await viewer.page.waitForFunction(
      (text) =>
        document
          .querySelector('cutaway-app')
          .shadowRoot.querySelector('cutaway-views')
          .shadowRoot.querySelector('[data-slice=sagittal]')
          .shadowRoot.querySelector('cutaway-slice-labels')
          .shadowRoot.querySelector('[data-part=slice-position]')
          .textContent.trim() !== text,
      before.sagittal,
    );
    await slices.settled();
    const moved = await slices.positions();
    assert.match(moved.sagittal, /^L [1-9]/);
    assert.match(moved.axial, /^S [1-9]/);
    await viewer.after(() => viewer.drag([x - 60, y + 60], [x + 60, y + 60]));
    assert.notEqual(await viewer.edgeLetters(), 'S L I R');
    assert.deepEqual(await slices.positions(), moved);
  });
});

describe('the slices at other sizes', { skip }, () => {
  const suite = served();

  it('tablet: all layouts', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, TABLET);
    await viewer.settled();
    const slices = new Slices(viewer);
    for (const layout of ['grid', 'focus']) {
      await slices.choose(layout);
      await assertAccessible(viewer, layout);
      await viewer.screenshot(`tablet-slices-${layout}`);
    }
    await viewer.close();
  });

  it('come back when the server does', { skip: isStandIn && 'keeps no session' }, async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, DESKTOP);
    await viewer.settled();
    const slices = new Slices(viewer);
    await slices.choose('grid');
    await viewer.page.mouse.click(...(await slices.at('axial', 0.6, 0.4)));
    await slices.settled();
    const before = await slices.positions();
    await suite.server.kill();
    await viewer.app('[data-connection=waiting]').waitFor();
    await suite.server.startAgain();
    await viewer.settled();
    await viewer.page.mouse.wheel(0, -100);
    await slices.settled();
    const after = await slices.positions();
    assert.deepEqual([after.coronal, after.sagittal], [before.coronal, before.sagittal]);
    assert.notEqual(after.axial, before.axial);
    await viewer.closeAfterLoss();
  });

  it('phone: layouts by one button, a tap moves the crosshair, two fingers zoom', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, PHONE);
    await viewer.settled();
    const slices = new Slices(viewer);
    const next = viewer.page.locator('[data-part=next-layout]');
    for (const layout of ['grid', 'focus']) {
      await next.tap();
      await viewer.page.locator(`[data-part=views][data-layout=${layout}]`).waitFor();
      await slices.settled();
      await assertAccessible(viewer, layout);
      await viewer.screenshot(`phone-slices-${layout}`);
    }
    await slices.part('axial', 'enlarge').tap();
    await slices.settled();
    await viewer.page.touchscreen.tap(...(await slices.at('axial', 0.6, 0.4)));
    await slices.settled();
    assert.match((await slices.positions()).sagittal ?? '', /L [1-9]|^$/);
    await viewer.screenshot('phone-slices-large');
    const mm = await slices.pixelsPerMm('axial');
    await pinch(viewer, await slices.at('axial', 0.5, 0.5));
    await slices.settled();
    assert.ok((await slices.pixelsPerMm('axial')) > 1.3 * mm);
    await viewer.close();
  });
});

/** Two fingers go apart. */
async function pinch({ page }, [x, y]) {
  const touch = await page.context().newCDPSession(page);
  const points = (reach) => [
    { id: 0, x: x - reach, y },
    { id: 1, x: x + reach, y },
  ];
  const send = (type, touchPoints) => touch.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', points(40));
  for (let step = 1; step <= 6; step++) await send('touchMove', points(40 + 8 * step));
  await send('touchEnd', []);
}
