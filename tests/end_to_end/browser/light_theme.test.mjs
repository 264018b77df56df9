// The light theme breaks no rule of axe-core either, wherever the page has a face of its own.
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, skip } from './support/browser.mjs';
import { Slices } from './support/slices.mjs';
import { servedPage } from './support/suite.mjs';

describe('the light theme', { skip }, () => {
  let viewer, slices;
  servedPage({ ...DESKTOP, colorScheme: 'light' }, (page) => {
    viewer = page;
    slices = new Slices(page);
  });

  for (const layout of ['grid', 'focus'])
    it(`is readable with the slices: ${layout}`, async () => {
      await slices.choose(layout);
      await viewer.screenshot(`light-${layout}`);
      await assertAccessible(viewer, layout);
    });

  it('is readable in the export', async () => {
    await viewer.page.getByRole('button', { name: 'Export a picture or a film' }).click();
    await viewer.page.getByRole('button', { name: 'Save the picture' }).waitFor();
    await viewer.screenshot('light-export');
    await assertAccessible(viewer, 'the export');
  });

  it('is readable with measurements', async () => {
    await viewer.openTab('Measure');
    await viewer.page.locator('[data-tool=distance]').click();
    const { x, y, width, height } = await viewer.stageBox();
    await viewer.page.mouse.click(x + width * 0.5, y + height * 0.45);
    await viewer.page.getByText('Choose the second point').waitFor();
    await viewer.page.mouse.click(x + width * 0.52, y + height * 0.5);
    await viewer.page.locator('cutaway-measure-tab [data-measurement]').waitFor();
    await viewer.screenshot('light-measure');
    await assertAccessible(viewer, 'the measurements');
  });

  it('is readable in the list of volumes', async () => {
    await viewer.openTab('Volumes');
    await viewer.page.locator('cutaway-volume-list .entry').first().waitFor();
    await viewer.screenshot('light-volumes');
    await assertAccessible(viewer, 'the volumes');
  });
});
