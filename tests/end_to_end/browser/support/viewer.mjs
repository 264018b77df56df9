// The page as a test sees it: waits for its state, never for time.
import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

const LIMIT_MS = 60_000;
const OVERLAYS =
  'cutaway-lens-overlay, cutaway-orientation-marks, cutaway-orientation-cube, cutaway-picture-notices, ' +
  'cutaway-hints, cutaway-toast-stack';
const screenshotFolder = process.env.CUTAWAY_SCREENSHOTS;

export class Viewer {
  /** What the page must not have said by the end of a test. */
  complaints = [];

  constructor(page, url) {
    this.page = page;
    page.setDefaultTimeout(LIMIT_MS);
    page.on('pageerror', (error) => this.complaints.push(String(error)));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) this.complaints.push(message.text());
    });
    page.on('request', (request) => {
      const { origin, protocol } = new URL(request.url());
      if (protocol.startsWith('http') && origin !== new URL(url).origin)
        this.complaints.push(`asks ${request.url()}`);
    });
  }

  /** As on a later visit: what a first visit is told has been seen. */
  static async open(browser, url, options) {
    const preferences = { name: 'cutaway.preferences', value: '{"version":1,"hints_seen":true}' };
    const origins = [{ origin: new URL(url).origin, localStorage: [preferences] }];
    const context = await browser.newContext({
      storageState: { cookies: [], origins },
      ...options,
    });
    const viewer = new Viewer(await context.newPage(), url);
    await viewer.page.goto(url);
    return viewer;
  }

  async close() {
    await this.page.context().close();
    assert.deepEqual(this.complaints, []);
  }

  /** Where a connection was lost on purpose, of which the browser itself complains. */
  async closeAfterLoss() {
    const due_to_it = /WebSocket connection|ERR_CONNECTION_(REFUSED|RESET)/;
    this.complaints = this.complaints.filter((text) => !due_to_it.test(text));
    await this.close();
  }

  app(condition = '') {
    return this.page.locator(`cutaway-app${condition}`);
  }

  /** Until the refined picture of the last input is on the screen. */
  async settled() {
    await this.page.waitForFunction(
      () => {
        const { connection, still, input, sent, loading } =
          document.querySelector('cutaway-app')?.dataset ?? {};
        return (
          connection === 'connected' &&
          still === 'true' &&
          Number(input) >= Number(sent) &&
          loading === undefined
        );
      },
      undefined,
      { timeout: LIMIT_MS },
    );
  }

  /** Carries out an action that changes the picture, and waits for the picture. */
  async after(action) {
    const sentBefore = await this.data('sent');
    await action();
    await this.page.waitForFunction(
      (before) => document.querySelector('cutaway-app').dataset.sent !== before,
      sentBefore,
      { timeout: LIMIT_MS },
    );
    await this.settled();
  }

  data(name) {
    return this.page.evaluate((key) => document.querySelector('cutaway-app').dataset[key], name);
  }

  async openTab(name) {
    const tab = this.page.getByRole('tab', { name });
    if ((await tab.getAttribute('aria-selected')) !== 'true') await tab.click();
    await this.page.locator('#tabpanel').waitFor();
  }

  /** Until the server's picture is on the style's card. */
  async pictured(...styles) {
    for (const style of styles)
      await this.page.locator(`[data-style=${style}][data-picture=rendered]`).waitFor();
  }

  async openStudies() {
    await this.page.locator('summary', { hasText: 'Technique studies' }).click();
  }

  /** Of the panel, by whose it is and what it sets: 'Focus: Opacity'. */
  number(name) {
    return this.page.getByRole('spinbutton', { name });
  }

  /** By keyboard: the switch's own input lies under what is drawn. */
  async toggle(name) {
    await this.page.getByRole('switch', { name }).press('Space');
  }

  /** The name of a choice is that of its control. */
  async choose(name, option) {
    await this.page.getByRole('combobox', { name }).click();
    await this.page.getByRole('option', { name: option }).click();
  }

  async lensMiddle() {
    const { x, y, width, height } = await this.page
      .locator('cutaway-lens-overlay polygon')
      .last()
      .boundingBox();
    return [x + width / 2, y + height / 2];
  }

  async stageBox() {
    return this.page.locator('[data-part=stage]').boundingBox();
  }

  async stageMiddle() {
    const { x, y, width, height } = await this.stageBox();
    return [x + width / 2, y + height / 2];
  }

  async drag([from_x, from_y], [to_x, to_y], { button = 'left', steps = 8 } = {}) {
    const { mouse } = this.page;
    await mouse.move(from_x, from_y);
    await mouse.down({ button });
    await mouse.move(to_x, to_y, { steps });
    await mouse.up({ button });
  }

  /** Top, right, bottom, left: 'S L I R' from the front. */
  async edgeLetters() {
    const letters = await this.page.locator('cutaway-orientation-marks span').allTextContents();
    return letters.map((text) => text.trim()).join(' ');
  }

  async gripMiddle(part = 'lens-grip') {
    const { x, y, width, height } = await this.page.locator(`[data-part=${part}]`).boundingBox();
    return [x + width / 2, y + height / 2];
  }

  async lensWidth() {
    return (await this.page.locator('cutaway-lens-overlay polygon').last().boundingBox()).width;
  }

  /** The picture's pixels, as the screen shows them, without what lies over it. */
  async pixels() {
    const clip = await this.stageBox();
    const overlays = this.page.locator(OVERLAYS);
    const show = (display) =>
      overlays.evaluateAll(
        (all, value) => all.forEach((one) => (one.style.display = value)),
        display,
      );
    await show('none');
    const png = await this.page.screenshot({ clip, animations: 'disabled' });
    await show('');
    return this.page.evaluate(decodePixels, png.toString('base64'));
  }

  /** Both at rest: full light comes a moment after the still, to each in its own time. */
  async looksLike(other, most) {
    const deadline = Date.now() + LIMIT_MS;
    let off = Infinity;
    while (off >= most && Date.now() < deadline)
      off = meanDifference(await this.pixels(), await other.pixels());
    assert.ok(off < most, `the pictures differ by ${off} of 255`);
  }

  /** Share of the picture that is not background. */
  async coverage() {
    const { data, width, height } = await this.pixels();
    const corner = data.slice(0, 3);
    let covered = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (corner.some((part, index) => Math.abs(data[at + index] - part) > 24)) covered += 1;
    }
    return covered / (width * height);
  }

  /** A file that the page made, to be looked at beside the screenshots. */
  async keep(name, bytes) {
    if (!screenshotFolder) return;
    await mkdir(screenshotFolder, { recursive: true });
    await writeFile(join(screenshotFolder, name), bytes);
  }

  async screenshot(name) {
    if (!screenshotFolder) return;
    await mkdir(screenshotFolder, { recursive: true });
    await this.page.screenshot({
      path: join(screenshotFolder, `${name}.png`),
      animations: 'disabled',
    });
  }
}

/** Runs in the page. Every fourth pixel each way is enough, and quicker to hand over. */
async function decodePixels(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const width = Math.ceil(bitmap.width / 4);
  const height = Math.ceil(bitmap.height / 4);
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context.imageSmoothingEnabled = false;
  context.drawImage(bitmap, 0, 0, width, height);
  return {
    data: [...context.getImageData(0, 0, width, height).data],
    width,
    height,
  };
}

/** Mean difference of two pictures of the same size, in steps of 255. */
export function meanDifference(a, b) {
  assert.deepEqual([a.width, a.height], [b.width, b.height]);
  const sum = a.data.reduce((total, part, index) => total + Math.abs(part - b.data[index]), 0);
  return sum / a.data.length;
}
