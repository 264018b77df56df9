// Nothing overlaps, and nothing keeps anyone out: every state of the page at both sizes.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip, TABLET } from './support/browser.mjs';
import { Slices } from './support/slices.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const FIXED_PARTS = [
  'cutaway-top-bar .brand',
  'cutaway-top-bar .volume',
  'cutaway-top-bar .link .dot',
  'cutaway-top-bar button',
  'cutaway-panel [role=tab]',
  'cutaway-panel [role=tabpanel]',
  'cutaway-orientation-marks span',
  'cutaway-orientation-cube',
  'cutaway-picture-notices span',
  'cutaway-scale-bar .scale',
  'cutaway-measure-toolbar [role=toolbar]',
  'cutaway-measure-readout .card',
];

/** Boxes of all visible parts, with their names. */
async function visibleBoxes(page, parts) {
  const boxes = [];
  for (const part of parts) {
    for (const element of await page.locator(part).all()) {
      const box = (await element.isVisible()) && (await element.boundingBox());
      if (box)
        boxes.push({
          part: `${part} ${(await element.textContent()).trim()}`,
          ...box,
        });
    }
  }
  return boxes;
}

const overlap = (a, b) =>
  a.x + a.width > b.x + 0.5 &&
  b.x + b.width > a.x + 0.5 &&
  a.y + a.height > b.y + 0.5 &&
  b.y + b.height > a.y + 0.5;

async function assertLayout({ page }, parts = FIXED_PARTS) {
  const boxes = await visibleBoxes(page, parts);
  const { width, height } = page.viewportSize();
  const scrollable = await page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    return [scrollWidth, scrollHeight];
  });
  assert.deepEqual(scrollable, [width, height], 'the page is larger than the screen');
  for (const [index, box] of boxes.entries()) {
    assert.ok(
      box.x >= 0 &&
        box.y >= 0 &&
        box.x + box.width <= width + 0.5 &&
        box.y + box.height <= height + 0.5,
      `${box.part} leaves the page`,
    );
    for (const other of boxes.slice(index + 1))
      assert.ok(!overlap(box, other), `${box.part} overlaps ${other.part}`);
  }
  assert.ok(boxes.length >= 15, `only ${boxes.length} parts were found`);
}

/** The longest form of a tab. */
const UNFOLD = {
  async Styles(viewer) {
    await viewer.pictured('flagship', 'anatomy-atlas');
    await viewer.screenshot(`${viewer.name}-gallery`);
    await viewer.openStudies();
    const study = viewer.page.locator('[data-style=toon-sobel]');
    await study.scrollIntoViewIfNeeded();
    await viewer.pictured('toon-sobel');
  },
  async Adjust(viewer) {
    await viewer.after(() => viewer.choose('Lens: Mode', 'Magic'));
    await viewer.after(() => viewer.toggle('Focus: Upper end'));
  },
  async Measure(viewer) {
    const [x, y] = await viewer.stageMiddle();
    await viewer.page.locator('[data-tool=distance]').click();
    for (const rise of [40, -40]) {
      await viewer.page.mouse.click(x, y + rise);
      await viewer.page.locator('[data-part=measure-readout]').waitFor();
    }
    await viewer.page.locator('li[data-measurement]').waitFor();
  },
};

const SLICE_PARTS = [
  'cutaway-orientation-marks span',
  'cutaway-picture-notices span',
  'cutaway-scale-bar .scale',
  'cutaway-slice-labels .name',
  'cutaway-slice-labels .window',
  'cutaway-slice-scroller input',
  'cutaway-enlarge-button button',
  'cutaway-orientation-cube button:first-child',
  'cutaway-measure-toolbar [role=toolbar]',
];

describe('layout and accessibility', { skip }, () => {
  const suite = served();

  for (const [name, options] of Object.entries({
    desktop: DESKTOP,
    phone: PHONE,
  })) {
    it(`${name}: every tab, the help, and a message`, async () => {
      const viewer = await Viewer.open(suite.browser, suite.server.url, options);
      viewer.name = name;
      await viewer.settled();
      await assertLayout(viewer);
      await assertAccessible(viewer, 'first');
      for (const tab of ['Volumes', 'Styles', 'Adjust', 'Measure', 'View']) {
        await viewer.openTab(tab);
        await viewer.settled();
        await UNFOLD[tab]?.(viewer);
        await assertLayout(viewer);
        await assertAccessible(viewer, tab);
        await viewer.screenshot(`${name}-tab-${tab.toLowerCase()}`);
      }
      await viewer.page.getByRole('button', { name: 'Help and keys' }).click();
      await viewer.page.getByRole('dialog', { name: 'Help' }).waitFor();
      await assertAccessible(viewer, 'help');
      await viewer.screenshot(`${name}-help`);
      await viewer.page.keyboard.press('Escape');
      await viewer.page.getByRole('button', { name: 'Copy a link to this view' }).click();
      await viewer.page.locator('[data-part=toast]').waitFor();
      await assertAccessible(viewer, 'message');
      await viewer.screenshot(`${name}-message`);
      await viewer.close();
    });
  }

  for (const [name, options] of Object.entries({
    desktop: DESKTOP,
    tablet: TABLET,
    phone: PHONE,
  })) {
    it(`${name}: slices beside the volume`, async () => {
      const viewer = await Viewer.open(suite.browser, suite.server.url, options);
      await viewer.settled();
      const slices = new Slices(viewer);
      await viewer.page.locator('[data-part=stage]').focus();
      for (const layout of ['grid', 'focus']) {
        await viewer.page.keyboard.press('g');
        await viewer.page.locator(`[data-part=views][data-layout=${layout}]`).waitFor();
        await slices.settled();
        await assertLayout(viewer, SLICE_PARTS);
      }
      await viewer.close();
    });
  }

  it('every part can be reached with Tab alone, and left again', async () => {
    const viewer = await Viewer.open(suite.browser, suite.server.url, DESKTOP);
    await viewer.settled();
    await viewer.after(() => viewer.page.locator('[data-part=stage]').press('ArrowRight'));
    await viewer.page.evaluate(() => document.activeElement.blur());
    const reached = new Set();
    for (let presses = 0; presses < 40; presses++) {
      await viewer.page.keyboard.press('Tab');
      reached.add(await viewer.page.evaluate(focusedName));
    }
    for (const name of [
      'Lens follows the pointer',
      'Undo',
      'Copy a link to this view',
      'Export a picture or a film',
      'Help and keys',
      'Hide the panel',
      '3-D picture',
      'Lens',
      'Styles',
      'Hold to compare',
      'Flagship',
      'Toon',
      'Technique studies',
    ])
      assert.ok(
        [...reached].some((text) => text.startsWith(name)),
        `${name} is not among ${[...reached].join(', ')}`,
      );
    await viewer.close();
  });
});

/** Runs in the page: what has the focus, through the shadow roots. */
function focusedName() {
  let focused = document.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  return (focused?.getAttribute('aria-label') ?? focused?.textContent ?? '').trim();
}
