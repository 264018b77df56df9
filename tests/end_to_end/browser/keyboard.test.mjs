// The whole of the page by keyboard: neither a mouse nor a finger is used, and at each key the focus
// is somewhere and is seen.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { download, pictureFacts } from './support/files.mjs';
import { Keyboard } from './support/keyboard.mjs';
import { Slices } from './support/slices.mjs';
import { servedPage } from './support/suite.mjs';

const WITH_CLIPBOARD = {
  ...DESKTOP,
  permissions: ['clipboard-read', 'clipboard-write'],
};

describe('the keyboard alone', { skip }, () => {
  let viewer, keyboard, slices;
  servedPage(WITH_CLIPBOARD, (page) => {
    viewer = page;
    keyboard = new Keyboard(page);
    slices = new Slices(page);
  });
  const part = (name) => viewer.page.locator(`[data-part=${name}]`);
  const button = (name) => viewer.page.getByRole('button', { name });

  /** With the arrows, from whichever tab is chosen. */
  async function openTab(name) {
    const tab = viewer.page.getByRole('tab', { name });
    await keyboard.goTo(viewer.page.getByRole('tab', { selected: true }));
    for (let tabs = 0; !(await keyboard.isOn(tab)); tabs++) {
      assert.ok(tabs < 5, `no tab ${name}`);
      await keyboard.press('ArrowRight');
    }
    if ((await tab.getAttribute('aria-selected')) !== 'true') await keyboard.press('Enter');
    await viewer.page.locator('#tabpanel').waitFor();
  }

  async function chooseGrid() {
    await keyboard.use(viewer.page.locator('cutaway-layout-choice [data-layout=grid]'));
    await slices.stage('sagittal').waitFor();
    await slices.settled();
  }

  it('opens a volume from the list', async () => {
    await openTab('Volumes');
    const other = viewer.page
      .locator('cutaway-volume-list .entry:not([aria-current=true])')
      .first();
    const id = await other.getAttribute('data-volume');
    await keyboard.use(viewer.page.locator(`.entry[data-volume="${id}"]`));
    await viewer.app(`[data-volume="${id}"]`).waitFor();
    await viewer.settled();
    await keyboard.assertFocusSeen('the volume is open');
  });

  it('reads the slices', async () => {
    await chooseGrid();
    await keyboard.goTo(slices.stage('axial'));
    const text = async () => (await slices.positions()).axial;
    const before = await text();
    await keyboard.press('ArrowUp', 3);
    await slices.settled();
    assert.notEqual(await text(), before, 'scrolled');
    await keyboard.press('3');
    await slices.settled();
    assert.equal(await slices.windowText('axial'), 'W 1,800 · C 400', 'the bone window');
    const coronal = (await slices.positions()).coronal;
    await keyboard.press('Shift+ArrowDown', 4);
    await slices.settled();
    assert.notEqual((await slices.positions()).coronal, coronal, 'the crosshair moved');
    const straight = await slices.letters('sagittal');
    await keyboard.press('.', 8);
    await slices.settled();
    assert.notEqual(await slices.letters('sagittal'), straight, 'tilted');
    await keyboard.press('t');
    await slices.until(async () => (await slices.letters('sagittal')) === straight);
    await viewer.screenshot('keyboard-slices');
  });

  it('measures a distance in a slice, and deletes it', async () => {
    await chooseGrid();
    await keyboard.goTo(slices.stage('axial'));
    await keyboard.press('m');
    await keyboard.press('Enter', 2);
    await viewer.page.getByText('Choose the second point').waitFor();
    await keyboard.press('ArrowRight', 5);
    await keyboard.press('Enter');
    const label = slices.of('axial').locator('cutaway-measure-overlay [data-measurement]');
    await label.waitFor();
    await keyboard.press('Escape');
    await openTab('Measure');
    const entry = viewer.page.locator('cutaway-measure-tab [data-measurement]');
    await keyboard.goTo(entry);
    await viewer.screenshot('keyboard-measure');
    await keyboard.use(entry.getByRole('button', { name: 'Delete' }));
    await entry.waitFor({ state: 'detached' });
    await keyboard.assertFocusSeen('the measurement is gone');
  });

  it('moves the lens and resizes it', async () => {
    await keyboard.goTo(part('lens-grip'));
    const [middle, width] = [await viewer.lensMiddle(), await viewer.lensWidth()];
    await viewer.after(() => keyboard.press('ArrowRight'));
    await viewer.after(() => keyboard.press('+', 3));
    assert.notDeepEqual(await viewer.lensMiddle(), middle);
    assert.ok((await viewer.lensWidth()) > width);
    await viewer.screenshot('keyboard-lens');
  });

  it('changes the style, takes it back, and keeps an own one', async () => {
    await openTab('Styles');
    const style = viewer.page.locator('[data-style]:not([aria-pressed=true])').first();
    const name = await style.getAttribute('data-style');
    const chosen = viewer.page.locator(`[data-style="${name}"]`);
    await viewer.after(() => keyboard.use(chosen));
    assert.equal(await chosen.getAttribute('aria-pressed'), 'true');
    await viewer.after(() => keyboard.use(button('Undo'), 'Shift+Tab'));
    assert.equal(await chosen.getAttribute('aria-pressed'), 'false');
    await viewer.after(() => keyboard.press('Control+y'));
    await keyboard.goTo(viewer.page.getByRole('textbox', { name: 'Name of the look' }));
    await keyboard.type('Mine');
    await keyboard.press('Enter');
    await viewer.page.locator('[data-own-style=Mine]').waitFor();
    await viewer.screenshot('keyboard-own-style');
    await keyboard.use(button('Delete Mine'), 'Shift+Tab');
    await viewer.page.locator('[data-own-style=Mine]').waitFor({ state: 'detached' });
    await keyboard.assertFocusSeen('the style is gone');
  });

  it('copies the link, saves a picture, opens help and closes it', async () => {
    await keyboard.use(button('Copy a link to this view'));
    await part('toast').waitFor();
    assert.match(await viewer.page.evaluate(() => navigator.clipboard.readText()), /#1\./);
    await keyboard.use(button('Export a picture or a film'));
    await viewer.page.getByRole('dialog', { name: 'Export' }).waitFor();
    const { bytes } = await download(viewer, () => keyboard.use(button('Save the picture')));
    assert.ok((await pictureFacts(viewer, bytes)).others > 20);
    await part('export-outcome').waitFor();
    await keyboard.assertFocusSeen('the picture is saved');
    await keyboard.press('Escape');
    await keyboard.goTo(part('stage'));
    await keyboard.press('?');
    await viewer.page.getByRole('dialog', { name: 'Help' }).waitFor();
    await keyboard.press('Escape');
    assert.ok(await keyboard.isOn(part('stage')), 'back where it was');
  });
});
