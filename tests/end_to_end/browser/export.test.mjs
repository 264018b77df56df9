// The view as a picture of any size, and as a film.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { differences, download, pictureFacts, videoFacts, zipEntries } from './support/files.mjs';
import { Slices } from './support/slices.mjs';
import { servedPage } from './support/suite.mjs';

const GERMAN = { ...DESKTOP, locale: 'de-DE' };

describe('the export', { skip }, () => {
  let viewer;
  servedPage(DESKTOP, (page) => (viewer = page));

  const button = (name) => viewer.page.getByRole('button', { name });
  const dialog = () => viewer.page.getByRole('dialog', { name: 'Export' });
  const outcome = () => viewer.page.locator('[data-part=export-outcome]');

  async function open(kind) {
    await button('Export a picture or a film').click();
    await viewer.page.getByRole('button', { name: kind, exact: true }).click();
  }

  async function setNumber(name, value) {
    const field = viewer.number(new RegExp(`^${name}`));
    await field.fill(String(value));
    await field.press('Enter');
  }

  async function setSize(width, height) {
    await viewer.toggle('Keep the view’s shape');
    await setNumber('Width', width);
    await setNumber('Height', height);
  }

  /** A short one, so that a slow machine makes it too. */
  async function shortTurntable() {
    await open('Film');
    await setSize(160, 120);
    await setNumber('Length', 1);
    await viewer.choose('Frames per second', '10');
  }

  /** A film that is refused has its reason in the dialog. */
  async function makeFilm() {
    const film = await download(viewer, async () => {
      await button('Make the film').click();
      await outcome().waitFor();
      assert.match(await outcome().textContent(), /Saved/);
    });
    return film;
  }

  it('saves a picture of 3000 by 2000, with its notice in the file', async () => {
    await open('Picture');
    await setSize(3000, 2000);
    await viewer.screenshot('desktop-export-picture');
    const { name, bytes } = await download(viewer, () => button('Save the picture').click());
    assert.match(name, /^cutaway .*\.png$/);
    const { width, height, others } = await pictureFacts(viewer, bytes);
    assert.deepEqual([width, height], [3000, 2000]);
    assert.ok(others > 20, `${others} of 400 places differ from the corner`);
    assert.match(bytes.toString('utf8', 0, 400), /Disclaimer\0+Not for diagnostic use/);
    await outcome().getByText(name).waitFor();
    await assertAccessible(viewer, 'a picture was saved');
  });

  it('keeps the view’s shape until told otherwise', async () => {
    await open('Picture');
    await setNumber('Width', 1500);
    const { width, height } = await viewer.stageBox();
    const made = Number(await viewer.number('Height').inputValue());
    assert.ok(Math.abs(made - (1500 * height) / width) <= 1, `${made} px high`);
    await setNumber('Height', 99_999);
    const sides = await Promise.all(
      ['Width', 'Height'].map(async (side) => Number(await viewer.number(side).inputValue())),
    );
    assert.equal(Math.max(...sides), 8192);
  });

  it('saves a slice in its own shape', async () => {
    const slices = new Slices(viewer);
    await slices.choose('focus');
    await slices.stage('coronal').focus();
    await viewer.page.keyboard.press('e');
    const choice = viewer.page.getByRole('combobox', { name: 'Picture of' });
    await choice.waitFor();
    assert.equal(await choice.inputValue(), 'Coronal', 'the view that has the focus');
    await setNumber('Width', 300);
    await viewer.screenshot('desktop-export-slice');
    const { name, bytes } = await download(viewer, () => button('Save the picture').click());
    assert.match(name, /^cutaway .* coronal\.png$/);
    const { width, height, others } = await pictureFacts(viewer, bytes);
    const shape = await slices.box('coronal');
    assert.equal(width, 300);
    assert.ok(Math.abs(height - (300 * shape.height) / shape.width) <= 1.5, `${height} px high`);
    assert.ok(others > 20, `${others} of 400 places differ from the corner`);
    await viewer.choose('Picture of', '3-D');
    const view = await viewer.stageBox();
    assert.equal(await viewer.number('Width').inputValue(), '300');
    const made = Number(await viewer.number('Height').inputValue());
    assert.ok(Math.abs(made - (300 * view.height) / view.width) <= 1.5, `${made} px high`);
  });

  it('draws the labels at the edges of a slice, and leaves the rest as the server made it', async () => {
    const slices = new Slices(viewer);
    await slices.choose('focus');
    await viewer.openTab('View');
    await viewer.choose('Slices: Convention', 'Neurological');
    await slices.settled();
    await slices.stage('axial').focus();
    await viewer.page.keyboard.press('e');
    await setSize(900, 700);
    const save = () => download(viewer, () => button('Save the picture').click());
    const labelled = await save();
    await viewer.keep('export-slice-labelled.png', labelled.bytes);
    await outcome().waitFor();
    await viewer.toggle('Labels in the picture');
    const bare = await save();
    const { edges, middle } = await differences(viewer, labelled.bytes, bare.bytes);
    assert.equal(middle, 0, 'the middle is the server’s, pixel for pixel');
    assert.ok(edges > 500, `${edges} pixels of labels`);
    for (const { bytes } of [labelled, bare])
      assert.match(bytes.toString('utf8', 0, 400), /Disclaimer\0+Not for diagnostic use/);
    await viewer.choose('Picture of', '3-D');
    await viewer.toggle('Labels in the picture');
    const volume = await save();
    await viewer.keep('export-volume-labelled.png', volume.bytes);
  });

  it('makes a WebM with every frame of a turntable', async () => {
    await shortTurntable();
    await viewer.choose('Format', 'WebM');
    await viewer.screenshot('desktop-export-film');
    await assertAccessible(viewer, 'the settings of a film');
    const before = await viewer.data('revision');
    const { name, bytes } = await makeFilm();
    assert.match(name, /^cutaway .*\.webm$/);
    const { width, height, frames, seconds } = await videoFacts(bytes);
    assert.deepEqual([width, height, frames], [160, 120, 10]);
    assert.ok(Math.abs(seconds - 1) < 0.01, `${seconds} s`);
    assert.equal(await viewer.data('revision'), before, 'the session’s scene is as it was');
  });

  it('makes numbered pictures in a ZIP, stored as they are', async () => {
    await shortTurntable();
    await viewer.choose('Format', 'Numbered PNG in a ZIP');
    const { name, bytes } = await makeFilm();
    assert.match(name, /^cutaway .*\.zip$/);
    const [notice, ...frames] = zipEntries(bytes);
    assert.match(notice.content.toString('utf8'), /Not for diagnostic use/);
    assert.deepEqual(
      frames.map((frame) => frame.name),
      Array.from({ length: 10 }, (_, at) => `frame_${String(at + 1).padStart(5, '0')}.png`),
    );
    assert.ok(frames.every(({ is_stored }) => is_stored));
    const { width, height } = await pictureFacts(viewer, frames[3].content);
    assert.deepEqual([width, height], [160, 120]);
    assert.notDeepEqual(frames[0].content, frames[3].content, 'the view has turned');
  });

  it('can be given up, and lets the user go on meanwhile', async () => {
    await open('Film');
    await setNumber('Length', 60);
    await button('Make the film').click();
    await viewer.page.locator('[data-part=export-progress]', { hasText: ' of 1,500' }).waitFor();
    await viewer.screenshot('desktop-export-progress');
    await assertAccessible(viewer, 'a film is made');
    await viewer.page.keyboard.press('Escape');
    await dialog().waitFor({ state: 'hidden' });
    await viewer.page.locator('[data-part=export-going-on]').waitFor();
    await viewer.screenshot('desktop-export-going-on');
    await viewer.after(async () => {
      await viewer.page.locator('[data-part=stage]').focus();
      await viewer.page.keyboard.press('ArrowRight');
    });
    await viewer.page.locator('[data-part=export-going-on]').getByRole('button').click();
    await button('Cancel').click();
    await button('Make the film').waitFor();
  });

  it('records the view with a red mark, and makes a film of that', async () => {
    const { keyboard } = viewer.page;
    await viewer.page.locator('[data-part=stage]').focus();
    await keyboard.press('Shift+E');
    await viewer.page.locator('[data-part=recording]', { hasText: 'Recording' }).waitFor();
    await viewer.screenshot('desktop-recording');
    await assertAccessible(viewer, 'the view is recorded');
    for (let press = 0; press < 4; press++) await keyboard.press('ArrowRight');
    await keyboard.press('e');
    await viewer.page.getByText('Recorded:').waitFor();
    await setSize(160, 120);
    await viewer.choose('Frames per second', '10');
    await viewer.choose('Format', 'WebM');
    const { bytes } = await makeFilm();
    const { frames } = await videoFacts(bytes);
    assert.ok(frames > 0, `${frames} frames`);
  });
});

describe('the export on a phone', { skip }, () => {
  let viewer;
  servedPage(PHONE, (page) => (viewer = page));

  it('fits, with its film', async () => {
    await viewer.page.getByRole('button', { name: 'Export a picture or a film' }).tap();
    await viewer.page.getByRole('button', { name: 'Save the picture' }).waitFor();
    await viewer.screenshot('phone-export-picture');
    await viewer.page.getByRole('button', { name: 'Film', exact: true }).tap();
    await viewer.page.getByRole('combobox', { name: 'Format' }).waitFor();
    await viewer.screenshot('phone-export-film');
    await assertAccessible(viewer, 'the settings of a film on a phone');
    const { width } = await viewer.page.locator('dialog[open]').boundingBox();
    assert.ok(width <= PHONE.viewport.width);
  });
});

describe('the export in German', { skip }, () => {
  let viewer;
  servedPage(GERMAN, (page) => (viewer = page));

  it('speaks it', async () => {
    await viewer.page.getByRole('button', { name: 'Bild oder Film exportieren' }).click();
    await viewer.page.getByRole('button', { name: 'Film', exact: true }).click();
    await viewer.page.getByRole('button', { name: 'Film herstellen' }).waitFor();
    await viewer.screenshot('desktop-export-german');
    await assertAccessible(viewer, 'the export in German');
  });
});
