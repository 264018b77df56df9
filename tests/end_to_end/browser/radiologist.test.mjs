// A radiologist's day: a series is opened, its slices are scrolled, windowed and measured, and left
// is checked to be left, whatever the plane in which the scanner took the images.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, skip } from './support/browser.mjs';
import { writeDicomSeries } from './support/dicom_series.mjs';
import { isStandIn } from './support/server.mjs';
import { Slices } from './support/slices.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const COS_30 = Math.cos(Math.PI / 6);
const SIN_30 = 0.5;
/** Directions of columns, rows and images; the last one turns about two axes. */
const ACQUISITIONS = {
  axial: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  coronal: [
    [1, 0, 0],
    [0, 0, -1],
    [0, 1, 0],
  ],
  sagittal: [
    [0, 1, 0],
    [0, 0, -1],
    [-1, 0, 0],
  ],
  oblique: [
    [COS_30, SIN_30, 0],
    [-SIN_30 * COS_30, COS_30 * COS_30, -SIN_30],
    [-SIN_30 * SIN_30, SIN_30 * COS_30, COS_30],
  ],
};
const SPACING_MM = [1.25, 1.25, 2];
const HALF_A_VOXEL_MM = 0.5 * Math.min(...SPACING_MM);

const BODY = { radius_mm: 50, value: 40 };
const BALLS = {
  L: { centre_mm: [30, 0, 0], radius_mm: 7, value: 700 },
  A: { centre_mm: [0, -30, 0], radius_mm: 7, value: 400 },
};
/** A bar across, near the top of the head. */
const BAR = { half_mm: [20, 5, 4], centre_mm: [0, 0, 30], value: 1000 };

const distance_mm = (a, b) => Math.hypot(...a.map((part, axis) => part - b[axis]));

function valueAt(at_mm) {
  const in_bar = BAR.half_mm.every(
    (half, axis) => Math.abs(at_mm[axis] - BAR.centre_mm[axis]) <= half,
  );
  if (in_bar) return BAR.value;
  for (const { centre_mm, radius_mm, value } of Object.values(BALLS))
    if (distance_mm(at_mm, centre_mm) <= radius_mm) return value;
  return Math.hypot(...at_mm) <= BODY.radius_mm ? BODY.value : -1000;
}

/** What each slice shows, as the letters' directions, and how far from its middle: mm. */
const LANDMARKS = {
  axial: { L: 30, A: 30 },
  coronal: { L: 30, S: 30 },
  sagittal: { A: 30, S: 30 },
};
const TOWARDS = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
];

describe('a radiologist’s day', { skip: skip || (isStandIn && 'needs files') }, () => {
  let viewer, slices;
  const suite = served(async (folder) => {
    const planes = Object.entries(ACQUISITIONS);
    for (const [number, [plane, axes]] of planes.entries()) {
      const series = { number: number + 1, title: `${plane} series`, axes, valueAt };
      await writeDicomSeries(join(folder, plane), {
        ...series,
        size: [96, 96, 60],
        spacing_mm: SPACING_MM,
      });
    }
  });

  /** From the list of volumes, as on the first day. */
  async function openSeries(plane) {
    viewer = await Viewer.open(suite.browser, suite.server.url, DESKTOP);
    await viewer.settled();
    if (!(await viewer.data('volume')).includes(plane)) {
      await viewer.openTab('Volumes');
      await viewer.page.getByRole('button', { name: new RegExp(`^${plane} series`) }).click();
      await viewer.app(`[data-volume*=${plane}]`).waitFor();
      await viewer.settled();
    }
    slices = new Slices(viewer);
    await slices.choose('grid');
  }

  /** On the screen: so many millimetres from the crosshair to a letter's side. */
  async function towards(slice, letter, length_mm) {
    const side = (await slices.letters(slice)).split(' ').indexOf(letter);
    assert.notEqual(side, -1, `${slice} has no ${letter} at an edge`);
    const [x, y] = await slices.crosshair(slice);
    const length_px = length_mm * (await slices.pixelsPerMm(slice));
    return [x + TOWARDS[side][0] * length_px, y + TOWARDS[side][1] * length_px];
  }

  for (const plane of Object.keys(ACQUISITIONS)) {
    it(`finds each side where its letter is: ${plane} images`, async () => {
      await openSeries(plane);
      await slices.stage('axial').focus();
      await viewer.page.keyboard.press('3');
      await slices.settled();
      for (const [slice, marks] of Object.entries(LANDMARKS)) {
        for (const [letter, length_mm] of Object.entries(marks)) {
          const there = await slices.brightness(await towards(slice, letter, length_mm));
          const opposite = await slices.brightness(await towards(slice, letter, -length_mm));
          assert.ok(there > opposite + 30, `${slice}, ${letter}: ${there} against ${opposite}`);
        }
      }
      await viewer.screenshot(`radiologist-${plane}`);
      await viewer.close();
    });
  }

  it('scrolls with the wheel, sets the bone window with a key, reads a value', async () => {
    await openSeries('coronal');
    const before = await slices.positions();
    await viewer.page.mouse.move(...(await slices.at('coronal', 0.4, 0.6)));
    for (let step = 0; step < 3; step++) await viewer.page.mouse.wheel(0, -100);
    await slices.settled();
    const scrolled = await slices.positions();
    assert.notEqual(scrolled.coronal, before.coronal);
    assert.deepEqual([scrolled.axial, scrolled.sagittal], [before.axial, before.sagittal]);
    await viewer.page.keyboard.press('Control+z');
    await slices.stage('axial').focus();
    await viewer.page.keyboard.press('3');
    await slices.settled();
    assert.equal(await slices.windowText('axial'), 'W 1,800 · C 400');
    for (const [letter, { value }] of Object.entries(BALLS)) {
      await viewer.page.mouse.move(...(await towards('axial', letter, 30)));
      await slices
        .part('axial', 'slice-hover')
        .getByText(new RegExp(`^\\s*${value} HU`))
        .waitFor();
    }
    await assertAccessible(viewer, 'a value read');
    await viewer.close();
  });

  it('measures the bar within half a voxel, as the picture shows it', async () => {
    await openSeries('axial');
    await slices.stage('coronal').focus();
    await viewer.page.keyboard.press('3');
    await slices.settled();
    const [right_end, left_end] = await barEnds();
    await viewer.page.locator('[data-tool=distance]').click();
    await viewer.page.mouse.click(...right_end);
    await viewer.page.getByText('Choose the second point').waitFor();
    await viewer.page.mouse.click(...left_end);
    const label = slices.of('coronal').locator('cutaway-measure-overlay [data-measurement]');
    await label.waitFor();
    const length_mm = Number.parseFloat(/: ([\d.]+) mm/.exec(await label.getAttribute('title'))[1]);
    const expected_mm = 2 * BAR.half_mm[0];
    assert.ok(Math.abs(length_mm - expected_mm) <= HALF_A_VOXEL_MM, `${length_mm} mm`);
    await viewer.page.keyboard.press('Escape');
    await viewer.screenshot('radiologist-measures');
    await assertAccessible(viewer, 'a distance measured');
    await viewer.close();
  });

  /** Where the bar's picture is half as bright as in its middle: the patient's right end first. */
  async function barEnds() {
    const [x, y] = await towards('coronal', 'S', BAR.centre_mm[2] - 2);
    const half = await halfBright([x + 6, y]);
    const reach_px = Math.round(1.6 * BAR.half_mm[0] * (await slices.pixelsPerMm('coronal')));
    const begin = Math.round(x - reach_px);
    const row = await slices.row([begin, y], 2 * reach_px);
    const first = row.findIndex((grey) => grey > half);
    const last = row.findLastIndex((grey) => grey > half);
    return [
      [begin + first, y],
      [begin + last + 1, y],
    ];
  }

  /** Between the bar and the body around it. */
  async function halfBright(in_bar) {
    const in_body = await towards('coronal', 'S', 10);
    return (
      ((await slices.brightness(in_bar)) +
        (await slices.brightness([in_body[0] + 9, in_body[1]]))) /
      2
    );
  }
});
