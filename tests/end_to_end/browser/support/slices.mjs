// The slices on the page, as a test sees and moves them.

import assert from 'node:assert/strict';

const ANSWER_LIMIT_MS = 60_000;
const NAMES = ['axial', 'coronal', 'sagittal'];

export class Slices {
  constructor(viewer) {
    this.viewer = viewer;
    this.page = viewer.page;
  }

  of(name) {
    return this.page.locator(`cutaway-slice-view[data-slice=${name}]`);
  }

  part(name, part) {
    return this.of(name).locator(`[data-part=${part}]`);
  }

  stage(name) {
    return this.part(name, 'slice-stage');
  }

  async choose(layout) {
    await this.page.locator(`cutaway-layout-choice [data-layout="${layout}"]`).click();
    await this.page.locator(`[data-part=views][data-layout="${layout}"]`).waitFor();
    await this.settled();
  }

  /** Until each slice on the page is the refined picture of what the scene says. */
  async settled() {
    await this.page.waitForFunction(
      () => {
        const app = document.querySelector('cutaway-app').shadowRoot;
        const views = app.querySelector('cutaway-views').shadowRoot;
        const wanted = views.querySelector('[data-part=views]').dataset.layout;
        const slices = [...views.querySelectorAll('cutaway-slice-view')];
        const some = slices.length > 0 || wanted === 'single' || wanted === '3d';
        return some && slices.every(({ dataset }) => dataset.settled === 'true');
      },
      undefined,
      { timeout: 60_000 },
    );
  }

  /**
   * Until a condition holds of the settled slices. For what leaves a part of them to the server, as
   * straightening does: until it has answered, they still show what the scene says.
   */
  async until(holds) {
    for (const begun = performance.now(); performance.now() - begun < ANSWER_LIMIT_MS;) {
      await this.settled();
      if (await holds()) return;
    }
    assert.fail(`not so within ${ANSWER_LIMIT_MS} ms: ${holds}`);
  }

  /** Text of each slice's position: { axial: 'S 12.5 mm', ... }. */
  async positions() {
    const texts = await Promise.all(
      NAMES.map((name) => this.part(name, 'slice-position').textContent()),
    );
    return Object.fromEntries(NAMES.map((name, index) => [name, texts[index].trim()]));
  }

  async windowText(name) {
    return (await this.part(name, 'slice-window').textContent()).trim();
  }

  /** Top, right, bottom, left. */
  async letters(name) {
    const marks = this.of(name).locator('cutaway-orientation-marks span');
    return (await marks.allTextContents()).map((text) => text.trim()).join(' ');
  }

  async box(name) {
    return this.of(name).boundingBox();
  }

  /** By shares of its picture, from the upper left corner. */
  async at(name, across, down) {
    const { x, y, width, height } = await this.box(name);
    return [x + width * across, y + height * down];
  }

  /** Where the crosshair's lines meet, on the screen. */
  async crosshair(name) {
    const { x, y } = await this.box(name);
    const mark = this.part(name, 'crosshair');
    const [left, top] = await Promise.all(
      ['x', 'y'].map((axis) => mark.getAttribute(`data-${axis}`)),
    );
    return [x + Number(left), y + Number(top)];
  }

  /** CSS pixels of a millimetre, by the slice's own scale bar. */
  async pixelsPerMm(name) {
    const scale = this.part(name, 'scale');
    const { width } = await scale.locator('.bar').boundingBox();
    return width / Number(await scale.getAttribute('data-length-mm'));
  }

  /** Mean brightness of a small square about a point of the screen, 0..255. */
  async brightness([x, y]) {
    const greys = await this.greys({ x: x - 3, y: y - 3, width: 6, height: 6 });
    return greys.reduce((sum, grey) => sum + grey, 0) / greys.length;
  }

  /** The brightness of each pixel of the screen from a point on to the right. */
  async row([x, y], length_px) {
    return this.greys({ x, y, width: length_px, height: 1 });
  }

  async greys({ x, y, width, height }) {
    const clip = { x: Math.round(x), y: Math.round(y), width, height };
    const png = await this.page.screenshot({ clip, animations: 'disabled' });
    return this.page.evaluate(greysOf, png.toString('base64'));
  }
}

/** Runs in the page. */
async function greysOf(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const greys = [];
  for (let at = 0; at < data.length; at += 4)
    greys.push((data[at] + data[at + 1] + data[at + 2]) / 3);
  return greys;
}
