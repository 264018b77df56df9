// Choosing how things look: bands on the histogram, tissues, tones, and the user's own styles.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { DESKTOP, skip } from './support/browser.mjs';
import { isStandIn } from './support/server.mjs';
import { servedPage } from './support/suite.mjs';
import { meanDifference } from './support/viewer.mjs';

const VISIBLE_CHANGE = 0.1;

describe('bands and tones', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, async (page) => {
    viewer = page;
    await viewer.openTab('Adjust');
  });

  const lowerEnd = () => viewer.page.getByRole('slider', { name: 'Focus: Lower end' });
  const lowerValue = async () => Number(await lowerEnd().getAttribute('aria-valuenow'));

  it('has an end of the band dragged over the histogram, and moved with keys', async () => {
    const before = await viewer.pixels();
    const { x, y, width, height } = await viewer.page
      .locator('[data-part=histogram]')
      .first()
      .boundingBox();
    const from = [x + width * 0.3, y + height / 2];
    await viewer.after(() => viewer.drag(from, [x + width * 0.45, y + height / 2]));
    const [smallest, largest] = await Promise.all(
      ['aria-valuemin', 'aria-valuemax'].map(async (end) =>
        Number(await lowerEnd().getAttribute(end)),
      ),
    );
    const dragged = await lowerValue();
    const wanted = smallest + 0.45 * (largest - smallest);
    assert.ok(Math.abs(dragged - wanted) < (largest - smallest) / 50, `${dragged}, not ${wanted}`);
    if (!isStandIn) assert.ok(meanDifference(before, await viewer.pixels()) > VISIBLE_CHANGE);
    await viewer.after(() => lowerEnd().press('ArrowLeft'));
    assert.ok((await lowerValue()) < dragged);
    await viewer.after(() => lowerEnd().press('Home'));
    assert.equal(await lowerValue(), smallest);
  });

  it('draws a tissue by its name', async () => {
    const muscle = viewer.page
      .getByRole('group', { name: 'Focus: Tissue' })
      .getByRole('button', { name: 'Muscle' });
    await viewer.after(() => muscle.click());
    assert.equal(await muscle.getAttribute('aria-pressed'), 'true');
    assert.equal(await lowerValue(), -29);
    assert.equal(
      await viewer.page
        .getByRole('slider', { name: 'Focus: Upper value' })
        .getAttribute('aria-valuenow'),
      '150',
    );
    await viewer.screenshot('desktop-muscle');
  });

  it('shows the ramp of both tones, and the detail at the first level', async () => {
    await viewer.openTab('Styles');
    await viewer.after(() => viewer.page.locator('[data-style=gooch]').click());
    await viewer.openTab('Adjust');
    const ramp = viewer.page.locator('cutaway-tone-ramp .ramp').first();
    const background = () => ramp.evaluate((element) => element.style.background);
    const before = await background();
    await viewer.after(() =>
      viewer.page.getByLabel('Focus: Dark colour').evaluate((input) => {
        input.value = '#00ff00';
        input.dispatchEvent(new Event('input'));
      }),
    );
    assert.notEqual(await background(), before);
    await viewer.openTab('Styles');
    const detail = viewer.page.getByRole('slider', { name: 'Detail: Focus' });
    await viewer.after(() => detail.press('Home'));
    assert.equal(await detail.getAttribute('aria-valuenow'), '0');
  });
});

describe('own styles', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, async (page) => {
    viewer = page;
    await viewer.openTab('Styles');
  });

  const own = (title) => viewer.page.locator(`[data-own-style="${title}"]`);

  async function save(title) {
    const name = viewer.page.getByRole('textbox', { name: 'Name of the look' });
    await name.fill(title);
    await name.press('Enter');
    await own(title).waitFor();
  }

  async function importFile(name, text) {
    await viewer.page
      .locator('cutaway-own-styles input[type=file]')
      .setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  }

  const refusal = (text) =>
    viewer.page.locator('[data-part=toast]', { hasText: text }).first().waitFor();

  it('are saved, found after a reload, put on, renamed and deleted', async () => {
    await viewer.after(() => viewer.page.locator('[data-style=toon]').click());
    await save('Mine');
    await viewer.after(() => viewer.page.locator('[data-style=porcelain]').click());
    await viewer.app('[data-address=current]').waitFor();
    await viewer.page.reload();
    await viewer.settled();
    await viewer.openTab('Styles');
    await viewer.after(() =>
      own('Mine').getByRole('button', { name: 'Mine', exact: true }).click(),
    );
    await viewer.page.locator('[data-style=toon][aria-pressed=true]').waitFor();
    const title = own('Mine').getByRole('textbox', { name: 'Rename Mine' });
    await title.fill('Yours');
    // A picture that comes draws the list anew.
    await viewer.page.locator('cutaway-own-styles').evaluate((list) => {
      list.requestUpdate();
      return list.updateComplete;
    });
    await title.press('Enter');
    await viewer.screenshot('desktop-own-style');
    await own('Yours').getByRole('button', { name: 'Delete Yours' }).click();
    await own('Yours').waitFor({ state: 'detached' });
  });

  it('go out as a scene document and come in again', async () => {
    await save('Mine');
    const coming = viewer.page.waitForEvent('download');
    await viewer.page.getByRole('button', { name: 'Export Mine as a file' }).click();
    const file = await coming;
    assert.equal(file.suggestedFilename(), 'Mine.scene.json');
    const text = await readFile(await file.path(), 'utf8');
    assert.equal(JSON.parse(text).version, 1);
    await viewer.after(() => viewer.page.locator('[data-style=porcelain]').click());
    await viewer.after(() => importFile('Mine.scene.json', text));
    await own('Mine 2').waitFor();
  });

  it('are refused with the reason, by the page and by the server', async () => {
    await importFile('broken.json', '{"version": 1');
    await refusal('broken.json could not be imported');
    await importFile('old.json', '{"version": 0, "focus": {}}');
    await refusal('this page reads version 1');
    await importFile('strong.json', '{"version": 1, "lens": {"strength": 7}}');
    await refusal('/lens/strength');
    await own('strong').waitFor({ state: 'detached' });
  });
});
