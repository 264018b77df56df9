// Measuring: a known distance and a known value of a known volume, and the tools by mouse, keyboard
// and finger.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { metaImage } from './support/meta_image.mjs';
import { linkTo } from './support/scene_link.mjs';
import { isStandIn } from './support/server.mjs';
import { served, servedPage } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const VIEW_HEIGHT_MM = 130;
const SPACING_MM = [1.25, 2, 1.25];
const HALF_A_VOXEL_MM = 0.5 * Math.min(...SPACING_MM);
/** The right one lies higher and farther behind. */
const BALLS = {
  right: { centre_mm: [-30, 4, 12], radius_mm: 16 },
  left: { centre_mm: [28, -6, -14], radius_mm: 14 },
};
const SURFACE_HU = 300;
const CORE_HU = 700;
const HU_PER_MM = 100;

function valueAt(at_mm) {
  const depths = Object.values(BALLS).map(
    ({ centre_mm, radius_mm }) =>
      radius_mm - Math.hypot(...centre_mm.map((part, axis) => part - at_mm[axis])),
  );
  return Math.min(CORE_HU, Math.max(-1000, SURFACE_HU + HU_PER_MM * Math.max(...depths)));
}

/** Nearest to a viewer in front of the patient. */
const frontPole = ({ centre_mm: [x, y, z], radius_mm }) => [x, y - radius_mm, z];

const sceneOf = (volume, lens) => ({
  version: 1,
  volume,
  camera: {
    projection: 'orthographic',
    eye_mm: [0, -300, 0],
    target_mm: [0, 0, 0],
    up: [0, 0, 1],
    view_height_mm: VIEW_HEIGHT_MM,
  },
  focus: { surface: { iso_value: 5000 } },
  context: { surface: { iso_value: SURFACE_HU } },
  lens,
});

const tool = (viewer, name) => viewer.page.locator(`[data-tool=${name}]`);
const entry = (viewer, name) => viewer.page.locator(`li[data-measurement="${name}"]`);

async function download(viewer, button) {
  const coming = viewer.page.waitForEvent('download');
  await viewer.page.getByRole('button', { name: button }).click();
  const file = await coming;
  return [file.suggestedFilename(), await readFile(await file.path(), 'utf8')];
}

describe('measuring a known volume', { skip: skip || (isStandIn && 'needs files') }, () => {
  let viewer;
  const suite = served(async (folder) => {
    const image = metaImage({
      size: [88, 40, 88],
      spacing_mm: SPACING_MM,
      valueAt,
    });
    await writeFile(join(folder, 'balls.mha'), image);
    await writeFile(join(folder, 'cut.mha'), image.subarray(0, image.length / 2));
  });

  async function open(lens) {
    const scene = sceneOf('balls.mha', lens);
    viewer = await Viewer.open(suite.browser, `${suite.server.url}${linkTo(scene)}`, DESKTOP);
    await viewer.settled();
  }

  /** Where a patient point is on the screen: from the front, the patient's left is on the right. */
  async function onScreen([x, , z]) {
    const box = await viewer.stageBox();
    const scale = box.height / VIEW_HEIGHT_MM;
    return [box.x + box.width / 2 + x * scale, box.y + box.height / 2 - z * scale];
  }

  async function pressAt(point_mm) {
    await viewer.page.mouse.click(...(await onScreen(point_mm)));
  }

  it('finds the distance of two points within half a voxel', async () => {
    await open({ mode: 'none' });
    const [right, left] = [frontPole(BALLS.right), frontPole(BALLS.left)];
    await tool(viewer, 'distance').click();
    await pressAt(right);
    await viewer.page.getByText('Choose the second point').waitFor();
    await pressAt(left);
    await viewer.openTab('Measure');
    await entry(viewer, 'Distance 1').waitFor();
    const [name, text] = await download(viewer, 'Save as JSON');
    assert.match(name, /^cutaway balls.* measurements\.json$/);
    const [{ length_mm, points }] = JSON.parse(text).measurements;
    const expected_mm = Math.hypot(...right.map((part, axis) => part - left[axis]));
    assert.ok(Math.abs(length_mm - expected_mm) < HALF_A_VOXEL_MM, `${length_mm} mm`);
    points.forEach(({ position_mm, value }, index) => {
      const wanted = [right, left][index];
      const off_mm = Math.hypot(...position_mm.map((part, axis) => part - wanted[axis]));
      assert.ok(off_mm < HALF_A_VOXEL_MM, `${position_mm} is ${off_mm} mm from ${wanted}`);
      assert.ok(Math.abs(value - SURFACE_HU) < 20, `${value} HU at the surface`);
    });
    await viewer.screenshot('desktop-measured-balls');
    await viewer.close();
  });

  it('reads a known value inside, on the lens’ cut', async () => {
    const [x, y, z] = frontPole(BALLS.right);
    await open({
      mode: 'cutaway',
      cap: 'flat',
      centre_mm: [x, y, z],
      radius_mm: 9,
    });
    await tool(viewer, 'probe').click();
    await pressAt([x, y, z]);
    await viewer.openTab('Measure');
    await entry(viewer, 'Probe 1').getByText(`${CORE_HU} HU`).waitFor();
    // The lens reaches 9 mm in from the surface.
    await entry(viewer, 'Probe 1')
      .getByText(/R 30\.\d · A 3\.\d · S 1[12]\.\d mm/)
      .waitFor();
    await viewer.close();
  });

  it('says that there is no surface beside the volume', async () => {
    await open({ mode: 'none' });
    await tool(viewer, 'probe').click();
    await pressAt([0, 0, 55]);
    await viewer.page.locator('[data-part=toast]', { hasText: 'No surface here' }).waitFor();
    await viewer.close();
  });

  it('is found among other volumes, and a file that was refused has its reason', async () => {
    await open({ mode: 'none' });
    await viewer.openTab('Volumes');
    const entries = viewer.page.locator('[data-volume].entry');
    assert.ok((await entries.count()) > 1);
    await viewer.page.getByRole('searchbox', { name: 'Search volumes' }).fill('BALLS metaimage');
    await entries.nth(1).waitFor({ state: 'detached' });
    assert.equal(await entries.first().getAttribute('data-volume'), 'balls.mha');
    await viewer.page.locator('summary', { hasText: '1 could not be read' }).click();
    await viewer.page.getByText('cut.mha').waitFor();
    await viewer.screenshot('desktop-volume-search');
    await viewer.page.getByRole('searchbox', { name: 'Search volumes' }).fill('nothing such');
    await viewer.page.getByText('No volume matches.').waitFor();
    await viewer.close();
  });

  it('has a scale bar as long as it says', async () => {
    await open({ mode: 'none' });
    const scale = viewer.page.locator('[data-part=scale]');
    const length_mm = Number(await scale.getAttribute('data-length-mm'));
    const { width } = await scale.locator('.bar').boundingBox();
    const { height } = await viewer.stageBox();
    assert.ok(Math.abs((width * VIEW_HEIGHT_MM) / height - length_mm) < 0.1, `${width} px`);
    await viewer.close();
  });
});

describe('the measuring tools', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, (page) => (viewer = page));

  it('measure with the keyboard alone, and stay with the patient as the camera turns', async () => {
    const { keyboard } = viewer.page;
    await viewer.page.locator('[data-part=stage]').focus();
    await keyboard.press('m');
    await keyboard.press('ArrowUp');
    await keyboard.press('Enter');
    await viewer.page.getByText('Choose the second point').waitFor();
    for (let presses = 0; presses < 4; presses++) await keyboard.press('ArrowDown');
    await keyboard.press('Enter');
    const label = viewer.page.locator('cutaway-measure-overlay [data-measurement="Distance 1"]');
    await label.waitFor();
    const before = await label.boundingBox();
    const length = /[\d.]+ mm/.exec(await label.textContent())[0];
    await keyboard.press('Escape');
    await viewer.after(() => keyboard.press('ArrowRight'));
    const turned = await label.boundingBox();
    assert.ok(Math.abs(turned.x - before.x) > 2, 'the label moves with the patient');
    assert.match(await label.textContent(), new RegExp(length));
    const handle = viewer.page.getByRole('button', {
      name: 'Distance 1, point 2',
    });
    await handle.focus();
    await keyboard.press('ArrowDown');
    await viewer.page
      .locator('cutaway-measure-overlay [data-measurement]', {
        hasNotText: length,
      })
      .waitFor();
  });

  it('give up with Escape and leave the camera’s drag alone', async () => {
    const [x, y] = await viewer.stageMiddle();
    await tool(viewer, 'angle').click();
    await viewer.page.mouse.click(x, y - 40);
    await viewer.page.getByText('Choose the vertex').waitFor();
    const letters = await viewer.edgeLetters();
    await viewer.after(() => viewer.drag([x - 150, y], [x + 150, y]));
    assert.notEqual(await viewer.edgeLetters(), letters);
    await viewer.page.getByText('Choose the vertex').waitFor();
    await viewer.page.locator('[data-part=stage]').focus();
    await viewer.page.keyboard.press('Escape');
    await viewer.page.getByText('Angle: choose the first point').waitFor();
    await viewer.page.keyboard.press('Escape');
    await viewer.page.locator('[data-part=measure-readout]').waitFor({ state: 'detached' });
  });

  it('name, delete and forget nothing of another volume', async () => {
    const [x, y] = await viewer.stageMiddle();
    await tool(viewer, 'probe').click();
    await viewer.page.mouse.click(x, y);
    await viewer.openTab('Measure');
    const name = viewer.page.getByRole('textbox', { name: 'Name of Probe 1' });
    await name.fill('Apex');
    await name.press('Enter');
    const volume = await viewer.data('volume');
    await viewer.openTab('Volumes');
    await viewer.after(async () => {
      await viewer.page.locator(`[data-volume]:not([data-volume="${volume}"])`).first().click();
      await viewer.app(`:not([data-volume="${volume}"])`).waitFor();
    });
    await viewer.openTab('Measure');
    await viewer.page.getByText('Nothing measured in this volume yet.').waitFor();
    await viewer.openTab('Volumes');
    await viewer.after(async () => {
      await viewer.page.locator(`[data-volume="${volume}"]`).click();
      await viewer.app(`[data-volume="${volume}"]`).waitFor();
    });
    await viewer.openTab('Measure');
    await entry(viewer, 'Apex').waitFor();
    const [file, csv] = await download(viewer, 'Save as CSV');
    assert.match(file, /\.csv$/);
    assert.match(csv, /\r\nApex,probe,/);
    await viewer.page.getByRole('button', { name: 'Delete Apex' }).click();
    await viewer.page.getByText('Nothing measured in this volume yet.').waitFor();
  });
});

describe('what was measured', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, (page) => (viewer = page));

  it('is there after a reload, and comes back when a deletion is undone', async () => {
    const [x, y] = await viewer.stageMiddle();
    await tool(viewer, 'probe').click();
    await viewer.page.mouse.click(x, y);
    await viewer.openTab('Measure');
    await entry(viewer, 'Probe 1').waitFor();
    await viewer.page.reload();
    await viewer.settled();
    await viewer.openTab('Measure');
    await entry(viewer, 'Probe 1').waitFor();
    await viewer.page.getByRole('button', { name: 'Delete Probe 1' }).click();
    const toast = viewer.page.locator('[data-part=toast]', { hasText: 'Probe 1 was deleted' });
    await toast.waitFor();
    await viewer.screenshot('desktop-measurement-deleted');
    await assertAccessible(viewer, 'a measurement was deleted');
    await toast.getByRole('button', { name: 'Undo' }).click();
    await entry(viewer, 'Probe 1').waitFor();
  });

  it('with a tool in hand, Alt and arrows turn the view', async () => {
    await tool(viewer, 'distance').click();
    await viewer.page.locator('[data-part=stage]').focus();
    const letters = await viewer.edgeLetters();
    await viewer.after(async () => {
      for (let press = 0; press < 6; press++) await viewer.page.keyboard.press('Alt+ArrowRight');
    });
    assert.notEqual(await viewer.edgeLetters(), letters);
  });
});

describe('measuring with a finger', { skip }, () => {
  let viewer;
  servedPage(PHONE, (page) => (viewer = page));

  it('places a point with a tap', async () => {
    const [x, y] = await viewer.stageMiddle();
    await tool(viewer, 'distance').tap();
    await viewer.page.touchscreen.tap(x, y - 60);
    await viewer.page.getByText('Choose the second point').waitFor();
    await viewer.page.touchscreen.tap(x, y + 50);
    await viewer.page.locator('cutaway-measure-overlay [data-measurement="Distance 1"]').waitFor();
    await viewer.screenshot('phone-measured');
  });
});
