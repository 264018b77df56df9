// Hints of a first visit, none of which covers another one or what else lies on the picture.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { DESKTOP, openBrowser, skip } from './support/browser.mjs';
import { linkTo } from './support/scene_link.mjs';
import { isStandIn, Server } from './support/server.mjs';
import { Viewer } from './support/viewer.mjs';

const SIZES = [
  [1440, 900],
  [1024, 768],
  [1920, 1080],
  [2560, 1440],
  [390, 844],
  [844, 390],
];
const HEAD = 'phantom:head';
const LENSES = {
  'small, high': [[0, -90, 90], 15],
  'at the left, low': [[80, -60, -90], 40],
  huge: [[0, 0, 0], 400],
};

const real = process.env.CUTAWAY_TEST_DATA;
const folders = ['chest_ct_lidc0314_dicom', 'head_mr_seg3d_nii'].map((name) =>
  join(real ?? '', name),
);
const data = real && !isStandIn ? folders.filter((folder) => existsSync(folder)) : [];

describe('the hints of a first visit', { skip }, () => {
  let server;
  let browser;
  before(async () => {
    server = await Server.start({ data });
    browser = await openBrowser();
  });
  after(async () => {
    await browser?.close();
    await server?.kill();
  });

  async function open(locale, address) {
    const options = { ...DESKTOP, locale, storageState: undefined };
    const viewer = await Viewer.open(browser, `${server.url}${address}`, options);
    await viewer.settled();
    await viewer.page.locator('[data-part=hints]').waitFor();
    return viewer;
  }

  async function assertApart(viewer, what) {
    for (const [width, height] of SIZES) {
      await viewer.page.setViewportSize({ width, height });
      await viewer.page.waitForFunction(fitsThePage, [width, height]);
      await viewer.settled();
      const state = `${what}, ${width} x ${height}`;
      const boxes = await viewer.page.evaluate(boxesOnPicture);
      assert.ok(
        boxes.some(({ name }) => name === 'button'),
        state,
      );
      for (const [at, one] of boxes.entries())
        for (const other of boxes.slice(at + 1))
          assert.ok(!meet(one, other), `${state}: ${one.name} covers ${other.name}`);
      const outside = boxes.filter(({ is_inside }) => !is_inside).map(({ name }) => name);
      assert.deepEqual(outside, [], `${state}: beyond the picture`);
      await viewer.screenshot(`hints-${state.replaceAll(/\W+/g, '-')}`);
    }
  }

  for (const locale of ['en-GB', 'de-DE']) {
    for (const [name, [centre_mm, radius_mm]] of Object.entries(LENSES))
      it(`do not cover each other: a lens ${name}, ${locale}`, async () => {
        const lens = { mode: 'cutaway', centre_mm, radius_mm };
        const viewer = await open(locale, linkTo({ volume: HEAD, lens }));
        await assertApart(viewer, `${name}, ${locale}`);
        await viewer.close();
      });

    it(`do not cover each other: each volume, ${locale}`, async () => {
      const { volumes } = await (await fetch(`${server.url}api/volumes`)).json();
      for (const { id } of volumes) {
        const viewer = await open(locale, linkTo({ volume: id }));
        await assertApart(viewer, `${id}, ${locale}`);
        await viewer.close();
      }
    });
  }
});

const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Runs in the page. */
function fitsThePage([width, height]) {
  return innerWidth === width && innerHeight === height;
}

/** Runs in the page: of the hints, and of what else there is to read or to press on the picture. */
function boxesOnPicture() {
  const views = document
    .querySelector('cutaway-app')
    .shadowRoot.querySelector('cutaway-views').shadowRoot;
  const picture = views.querySelector('cutaway-viewport');
  const all = (host, selector) => [...(host?.shadowRoot?.querySelectorAll(selector) ?? [])];
  const within = (name, selector) => all(picture.shadowRoot.querySelector(name), selector);
  const shown = [
    ...within('cutaway-hints', '.hint, button'),
    ...within('cutaway-picture-notices', 'span'),
    ...within('cutaway-scale-bar', '.scale'),
    picture.shadowRoot.querySelector('cutaway-orientation-cube'),
  ];
  const bounds = picture.getBoundingClientRect();
  return shown
    .filter((one) => one.getBoundingClientRect().width > 0)
    .map((one) => {
      const { left, top, right, bottom } = one.getBoundingClientRect();
      const is_inside =
        left >= bounds.left &&
        right <= bounds.right &&
        top >= bounds.top &&
        bottom <= bounds.bottom;
      return {
        name: one.className || one.localName,
        left,
        top,
        right,
        bottom,
        is_inside,
      };
    });
}
