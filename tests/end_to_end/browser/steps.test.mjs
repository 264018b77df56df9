// Steps back and forth, the previous style while a key or a button is held, and groups put back.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, skip } from './support/browser.mjs';
import { servedPage } from './support/suite.mjs';
import { meanDifference } from './support/viewer.mjs';

const SAME_PICTURE = 0.5;
const VISIBLE_CHANGE = 0.5;

describe('steps', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, (page) => (viewer = page));

  const same = async (picture) => meanDifference(picture, await viewer.pixels()) < SAME_PICTURE;
  const button = (name) => viewer.page.getByRole('button', { name, exact: true });
  const wears = (style) =>
    viewer.page.locator(`[data-style=${style}][aria-pressed=true]`).waitFor();

  it('go back over a drag, a style and the lens by key, and forth again', async () => {
    await viewer.openTab('Styles');
    assert.ok(await button('Undo').isDisabled());
    const first = await viewer.pixels();
    const [x, y] = await viewer.stageMiddle();
    await viewer.after(() => viewer.drag([x - 80, y + 200], [x + 80, y + 160]));
    const turned = await viewer.pixels();
    await viewer.after(() => viewer.page.locator('[data-style=porcelain]').click());
    const grip = await viewer.gripMiddle();
    await viewer.after(() => viewer.drag(grip, [grip[0] - 40, grip[1] - 30]));
    const last = await viewer.pixels();
    await viewer.after(() => viewer.page.keyboard.press('Control+z'));
    assert.ok(Math.abs((await viewer.gripMiddle())[0] - grip[0]) < 2);
    await viewer.after(() => viewer.page.keyboard.press('Control+z'));
    await wears('flagship');
    assert.ok(await same(turned));
    await viewer.after(() => button('Undo').click());
    assert.ok(await same(first));
    assert.ok(await button('Undo').isDisabled());
    await viewer.after(() => viewer.page.keyboard.press('Control+Shift+z'));
    await viewer.after(() => viewer.page.keyboard.press('Control+y'));
    await wears('porcelain');
    await viewer.after(() => button('Redo').click());
    assert.ok(await same(last));
  });

  it('go back to the volume before, in the view that it had', async () => {
    const [x, y] = await viewer.stageMiddle();
    await viewer.after(() => viewer.drag([x - 80, y + 200], [x + 80, y + 160]));
    const before = await viewer.pixels();
    const shown = await viewer.data('volume');
    await viewer.openTab('Volumes');
    const id = 'phantom:knees';
    await viewer.after(async () => {
      await viewer.page.locator(`[data-volume="${id}"]`).click();
      await viewer.app(`[data-volume="${id}"]`).waitFor();
    });
    await viewer.after(async () => {
      await viewer.page.keyboard.press('Control+z');
      await viewer.app(`[data-volume="${shown}"]`).waitFor();
    });
    assert.ok(await same(before));
    await viewer.after(async () => {
      await viewer.page.keyboard.press('Control+y');
      await viewer.app(`[data-volume="${id}"]`).waitFor();
    });
  });

  it('leave a text field its own undo', async () => {
    await viewer.openTab('Adjust');
    const radius = viewer.number('Lens: Radius, number');
    await viewer.after(() => viewer.page.locator('[data-part=stage]').press('ArrowRight'));
    const sent = await viewer.data('sent');
    await radius.focus();
    await viewer.page.keyboard.type('7');
    await viewer.page.keyboard.press('Control+z');
    assert.equal(await viewer.data('sent'), sent);
  });

  it('show the previous style while a key or the button is held', async () => {
    await viewer.openTab('Styles');
    const compare = viewer.page.locator('[data-part=compare]');
    assert.ok(await compare.isDisabled());
    const flagship = await viewer.pixels();
    await viewer.after(() => viewer.page.locator('[data-style=porcelain]').click());
    const porcelain = await viewer.pixels();
    assert.ok(meanDifference(flagship, porcelain) > VISIBLE_CHANGE);
    await viewer.page.locator('[data-part=stage]').focus();
    await viewer.after(() => viewer.page.keyboard.down('b'));
    await wears('flagship');
    await viewer.page.locator('[data-part=comparing]').waitFor();
    await assertAccessible(viewer, 'comparing');
    await viewer.screenshot('desktop-comparing');
    await viewer.after(() => viewer.page.keyboard.up('b'));
    assert.ok(await same(porcelain));
    const { x, y, width, height } = await compare.boundingBox();
    await viewer.page.mouse.move(x + width / 2, y + height / 2);
    await viewer.after(() => viewer.page.mouse.down());
    await wears('flagship');
    await viewer.after(() => viewer.page.mouse.up());
    await wears('porcelain');
    await compare.focus();
    await viewer.after(() => viewer.page.keyboard.down('Space'));
    await wears('flagship');
    await viewer.after(() => viewer.page.keyboard.up('Space'));
    await wears('porcelain');
  });

  it('put a group of the panel back', async () => {
    await viewer.openTab('Adjust');
    const first = await viewer.pixels();
    await viewer.after(() => viewer.choose('Focus: Shading', 'Phong'));
    await viewer.after(() => viewer.toggle('Focus: Upper end'));
    assert.ok(meanDifference(first, await viewer.pixels()) > 0.1);
    await viewer.after(() => button('Focus: reset').click());
    assert.ok(await same(first));
    await viewer.after(async () => {
      await viewer.number('Lens: Radius, number').fill('20');
      await viewer.number('Lens: Radius, number').press('Enter');
    });
    await viewer.after(() => viewer.choose('Lens: Mode', 'Magic'));
    await viewer.after(() => button('Lens: reset').click());
    assert.ok(await same(first));
    await viewer.screenshot('desktop-adjust-reset');
  });
});
