// The gallery of styles, with pictures that the server renders of the open volume.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const POLL_MS = 250;
const LIMIT_MS = 60_000;

/** The wire as the page uses it: what it asked for, and how much of that is still on its way. */
class Wire {
  sizes = [];
  /** Ids of those whose pictures were asked for. */
  volumes = [];
  most_outstanding = 0;
  #outstanding = new Set();

  get outstanding() {
    return this.#outstanding.size;
  }

  constructor(page) {
    page.on('websocket', (socket) => {
      socket.on('framesent', ({ payload }) => this.#sent(String(payload)));
      socket.on('framereceived', ({ payload }) => this.#received(payload));
    });
  }

  #sent(text) {
    const message = JSON.parse(text);
    if (message.type !== 'preview') return;
    if (message.volume) this.volumes.push(message.volume);
    this.sizes.push([message.width_px, message.height_px]);
    this.#outstanding.add(message.request);
    this.most_outstanding = Math.max(this.most_outstanding, this.#outstanding.size);
  }

  #received(payload) {
    if (typeof payload !== 'string' && payload.readUInt8(5) === 3)
      this.#outstanding.delete(payload.readUInt32LE(12));
  }
}

describe('the gallery of styles', { skip }, () => {
  let viewer, wire;
  const suite = served();

  async function open(options) {
    const context = await suite.browser.newContext(options);
    const page = await context.newPage();
    wire = new Wire(page);
    viewer = new Viewer(page, suite.server.url);
    await page.goto(suite.server.url);
    await viewer.settled();
    await viewer.openTab('Styles');
  }

  const card = (style) => viewer.page.locator(`[data-style=${style}]`);
  const cardPixels = (style) =>
    card(style).locator('cutaway-style-picture').screenshot({ animations: 'disabled' });

  async function until(is_so, otherwise) {
    const deadline = Date.now() + LIMIT_MS;
    while (!(await is_so())) {
      assert.ok(Date.now() < deadline, otherwise);
      await viewer.page.waitForTimeout(POLL_MS);
    }
  }

  const untilChanged = (style, before_pixels) =>
    until(
      async () => !before_pixels.equals(await cardPixels(style)),
      `the picture of ${style} was not renewed`,
    );
  const untilAsked = () => until(() => wire.outstanding > 0, 'no picture was asked for');

  describe('on a desktop', () => {
    beforeEach(() => open(DESKTOP));
    afterEach(() => viewer.close());

    it('shows the volume in each illustration, a few asked for at a time', async () => {
      await viewer.pictured('flagship', 'anatomy-atlas', 'section', 'brain', 'night');
      assert.ok(wire.most_outstanding <= 2, `${wire.most_outstanding} were outstanding`);
      const [[width_px, height_px]] = wire.sizes;
      assert.ok(width_px > 120 && width_px <= 512, `${width_px} pixels wide`);
      assert.ok(Math.abs(width_px / height_px - 4 / 3) < 0.03, `${width_px} by ${height_px}`);
    });

    it('asks for a study only once it can be seen, and opens by keyboard', async () => {
      await viewer.pictured('porcelain');
      const before_studies = wire.sizes.length;
      assert.ok(before_studies <= 14, `${before_studies} pictures for twelve illustrations`);
      const heading = viewer.page.locator('summary', {
        hasText: 'Technique studies',
      });
      await heading.focus();
      await viewer.page.keyboard.press('Enter');
      await card('toon-sobel').scrollIntoViewIfNeeded();
      await viewer.pictured('toon-sobel');
      await viewer.screenshot('desktop-studies');
      await viewer.after(() => card('toon-sobel').press('Enter'));
      await viewer.page.locator('[data-style=toon-sobel][aria-pressed=true]').waitFor();
    });

    // A browser makes no click of a press on what is gone by its end.
    it('takes a click during which the picture comes', async () => {
      await viewer.pictured('flagship', 'anatomy-atlas', 'section', 'brain', 'night');
      await card('magic-lens').scrollIntoViewIfNeeded();
      await viewer.pictured('gooch', 'toon', 'magic-lens'); // nothing else waits for its picture
      const study = viewer.page.locator('cutaway-section [data-style]').first();
      const sent = await viewer.data('sent');
      suite.server.stall();
      try {
        await viewer.openStudies();
        await study.scrollIntoViewIfNeeded();
        await untilAsked();
        await study.locator('cutaway-style-picture').hover();
        await viewer.page.mouse.down();
        assert.equal(await study.getAttribute('data-picture'), 'drawn');
      } finally {
        suite.server.goOn();
      }
      const style = `[data-style=${await study.getAttribute('data-style')}]`;
      await viewer.page.locator(`${style}[data-picture=rendered]`).waitFor();
      await viewer.page.mouse.up();
      await viewer.page.locator(`${style}[aria-pressed=true]`).waitFor();
      assert.notEqual(await viewer.data('sent'), sent);
      await viewer.settled();
    });

    it('renews the pictures after the camera has moved and rests', async () => {
      await viewer.pictured('flagship');
      const first = await cardPixels('flagship');
      const [x, y] = await viewer.stageMiddle();
      await viewer.after(() => viewer.drag([x - 150, y + 200], [x + 150, y + 200]));
      await untilChanged('flagship', first);
    });

    it('shows the volume in an own style, which keeps its picture under a new name', async () => {
      await viewer.page.getByRole('textbox', { name: 'Name of the look' }).fill('Mine');
      await viewer.page.getByRole('button', { name: 'Save', exact: true }).click();
      const own = (title) => viewer.page.locator(`[data-own-style=${title}]`);
      await own('Mine').scrollIntoViewIfNeeded();
      await viewer.page.locator('[data-own-style=Mine][data-picture=rendered]').waitFor();
      await viewer.screenshot('desktop-own-style-picture');
      await assertAccessible(viewer, 'an own style with its picture');
      await viewer.page.getByRole('textbox', { name: 'Rename Mine' }).fill('Yours');
      await viewer.page.keyboard.press('Enter');
      await viewer.page.locator('[data-own-style=Yours][data-picture=rendered]').waitFor();
    });

    it('shows another volume in its pictures', async () => {
      await viewer.pictured('flagship');
      const first = await cardPixels('flagship');
      await viewer.openTab('Volumes');
      const id = 'phantom:knees';
      await viewer.after(async () => {
        await viewer.page.locator(`[data-volume="${id}"]`).click();
        await viewer.app(`[data-volume="${id}"]`).waitFor();
      });
      await viewer.openTab('Styles');
      await viewer.pictured('flagship', 'anatomy-atlas');
      await untilChanged('flagship', first);
    });
  });

  it('asks for device pixels on a phone', async () => {
    await open(PHONE);
    await viewer.pictured('flagship', 'anatomy-atlas');
    const [[width_px]] = wire.sizes;
    const { width } = await card('flagship').locator('cutaway-style-picture').boundingBox();
    assert.equal(width_px, Math.round(width * PHONE.deviceScaleFactor));
    await viewer.close();
  });

  it('has a picture of each volume in the list, asked for one at a time and once', async () => {
    await open(DESKTOP);
    assert.deepEqual(wire.volumes, [], 'none before the list is looked at');
    await viewer.openTab('Volumes');
    const entries = viewer.page.locator('.entry');
    await viewer.page.waitForFunction(
      () => {
        const list = document
          .querySelector('cutaway-app')
          .shadowRoot.querySelector('cutaway-panel')
          .shadowRoot.querySelector('cutaway-volume-list');
        const pictures = [...(list?.shadowRoot.querySelectorAll('.picture') ?? [])];
        return pictures.length > 1 && pictures.every((one) => one.dataset.picture === 'rendered');
      },
      undefined,
      { timeout: LIMIT_MS },
    );
    await viewer.screenshot('desktop-volume-pictures');
    await assertAccessible(viewer, 'volumes with pictures');
    const count = await entries.count();
    assert.equal(new Set(wire.volumes).size, count);
    await viewer.openTab('Styles');
    await viewer.openTab('Volumes');
    await viewer.page.locator('[data-picture=rendered]').first().waitFor();
    assert.equal(wire.volumes.length, count);
    await viewer.close();
  });
});
