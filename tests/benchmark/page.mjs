// How a drag feels in the page: frames painted a second, and how long the main thread is away. And how soon after a
// server's return the page shows the same view again. Prints a table; with --json FILE the figures, too.
// usage: CUTAWAY_BINARY=build/release/cutaway node tests/benchmark/page.mjs [--json FILE] [--volume ID] [--data DIR]
import { writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { DESKTOP, openBrowser } from '../end_to_end/browser/support/browser.mjs';
import { Server } from '../end_to_end/browser/support/server.mjs';
import { Viewer } from '../end_to_end/browser/support/viewer.mjs';

const { values: options } = parseArgs({
  options: {
    json: { type: 'string' },
    volume: { type: 'string', default: 'phantom:head' },
    data: { type: 'string', multiple: true, default: [] },
    seconds: { type: 'string', default: '6' },
  },
});

const PICTURE = { width: 1280, height: 720 };
const ROUNDS = 3;
const MOVES_PER_SECOND = 60;
/** What the Long Tasks specification reports. */
const LONG_TASK_MS = 50;

/** Runs in the page before its own scripts: counts frames as they are told, and what blocks. */
function watchPage() {
  window.watched = { frames: 0, long_tasks_ms: [] };
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) window.watched.long_tasks_ms.push(duration);
  }).observe({ type: 'longtask' });
  document.addEventListener('DOMContentLoaded', () => {
    const app = document.querySelector('cutaway-app');
    const painted = new MutationObserver(() => (window.watched.frames += 1));
    painted.observe(app, { attributes: true, attributeFilter: ['data-frame'] });
  });
}

/** The window's size at which the picture has the size that was asked for. */
async function fitWindow(viewer) {
  const stage = await viewer.stageBox();
  const { width, height } = DESKTOP.viewport;
  await viewer.page.setViewportSize({
    width: width + PICTURE.width - Math.round(stage.width),
    height: height + PICTURE.height - Math.round(stage.height),
  });
  await viewer.settled();
}

/** A hand that goes round in circles, as fast as a pointer reports. */
async function drag(viewer, seconds) {
  const { mouse } = viewer.page;
  const { x, y, width, height } = await viewer.stageBox();
  const at = (turn) => [
    x + width * (0.5 + 0.3 * Math.cos(turn)),
    y + height * (0.85 + 0.08 * Math.sin(turn)),
  ];
  await mouse.move(...at(0));
  await mouse.down();
  const begun = performance.now();
  for (let turn = 0; performance.now() - begun < 1000 * seconds; turn += 0.05) {
    await mouse.move(...at(turn));
    const due = begun + (1000 * turn) / (0.05 * MOVES_PER_SECOND);
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, due - performance.now())));
  }
  await mouse.up();
}

async function measureDrag(viewer, seconds) {
  await viewer.page.evaluate(() => (window.watched = { frames: 0, long_tasks_ms: [] }));
  const begun = performance.now();
  await drag(viewer, seconds);
  const watched = await viewer.page.evaluate(() => window.watched);
  const spent_s = (performance.now() - begun) / 1000;
  return {
    frames_per_second: watched.frames / spent_s,
    longest_task_ms: Math.max(0, ...watched.long_tasks_ms),
    long_tasks: watched.long_tasks_ms.length,
  };
}

/** Killed in the middle of a drag: milliseconds from the address it says again to the first picture. */
async function measureReturn(viewer, server) {
  const { mouse } = viewer.page;
  const [x, y] = await viewer.stageMiddle();
  await mouse.move(x, y + 250);
  await mouse.down();
  await mouse.move(x + 40, y + 250, { steps: 5 });
  await server.kill();
  await viewer.app('[data-connection=waiting]').waitFor();
  await mouse.move(x + 80, y + 250, { steps: 5 });
  await server.startAgain();
  const returned = performance.now();
  await viewer.page.waitForFunction(() => {
    const { connection, loading, input, sent } = document.querySelector('cutaway-app').dataset;
    return connection === 'connected' && loading === undefined && input === sent;
  });
  const spent_ms = performance.now() - returned;
  await mouse.up();
  await viewer.settled();
  return spent_ms;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

async function measure(server, browser) {
  const viewer = await Viewer.open(browser, `${server.url}#volume=${options.volume}`, DESKTOP);
  await viewer.page.addInitScript(watchPage);
  await viewer.page.reload();
  await viewer.settled();
  await fitWindow(viewer);
  const drags = [];
  for (let round = 0; round < ROUNDS; round++)
    drags.push(await measureDrag(viewer, Number(options.seconds)));
  const returns_ms = [];
  for (let round = 0; round < ROUNDS; round++) returns_ms.push(await measureReturn(viewer, server));
  const renderer = await viewer.page.evaluate(() => navigator.userAgent);
  await viewer.closeAfterLoss();
  return {
    volume: options.volume,
    picture_px: PICTURE,
    browser: renderer,
    painted_frames_per_second: median(drags.map((each) => each.frames_per_second)),
    longest_main_thread_task_ms: Math.max(...drags.map((each) => each.longest_task_ms)),
    main_thread_tasks_over_50_ms: drags.reduce((sum, each) => sum + each.long_tasks, 0),
    back_in_the_same_view_ms: median(returns_ms),
    drags,
    returns_ms,
  };
}

const config = fileURLToPath(new URL('../../deploy/cutaway.toml', import.meta.url));
const server = await Server.start({ data: options.data, config });
const browser = await openBrowser();
try {
  const figures = await measure(server, browser);
  const longest = figures.longest_main_thread_task_ms;
  console.log(`${figures.volume}, ${PICTURE.width}x${PICTURE.height}, medians of ${ROUNDS}`);
  console.log(`painted frames a second      ${figures.painted_frames_per_second.toFixed(1)}`);
  console.log(
    `main thread's longest task   ${longest ? `${longest} ms` : `under ${LONG_TASK_MS} ms`}`,
  );
  console.log(`back after a server's return ${Math.round(figures.back_in_the_same_view_ms)} ms`);
  if (options.json) await writeFile(options.json, `${JSON.stringify(figures, null, 2)}\n`);
} finally {
  await browser.close();
  await server.kill();
}
