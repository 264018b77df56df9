// Firefox and WebKit, each with one page: places on it, pointer, keys, pixels.
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { missing } from './browser.mjs';
import { Firefox, FIREFOX_NEEDS } from './firefox.mjs';
import { WebKit, WEBKIT_NEEDS } from './webkit.mjs';

const LIMIT_MS = 120_000;
const MOVES = 8;
const screenshotFolder = process.env.CUTAWAY_SCREENSHOTS;

/** Of WebDriver's keyboard. */
const KEYS = { Control: '\uE009', Escape: '\uE00C' };

const SCRIPT = (action) => `
  const answer = arguments[arguments.length - 1];
  Promise.resolve().then(() => (${action})(...JSON.parse(arguments[0])))
    .then((value) => answer(JSON.stringify({ value })))
    .catch((error) => answer(JSON.stringify({ error: String(error) })));`;

class Page {
  constructor(browser) {
    this.browser = browser;
  }

  goto(url) {
    return this.browser.goto(url);
  }

  /** Calls a function in the page; values and result pass as JSON. */
  async run(action, ...values) {
    const said = await this.browser.script(SCRIPT(action), [JSON.stringify(values)]);
    const { value, error } = JSON.parse(said);
    if (error) throw new Error(error);
    return value;
  }

  /** Until `condition`, a function that runs in the page, gives something; that is the result. */
  async until(condition, ...values) {
    for (const begun = performance.now(); performance.now() - begun < LIMIT_MS; await wait(100)) {
      const result = await this.run(condition, ...values);
      if (result) return result;
    }
    throw new Error(`not so within ${LIMIT_MS} ms: ${condition} ${values}`);
  }

  /** Of the first element of the page or of any component, within which the selector stays. */
  box(selector) {
    return this.until(boxOf, selector);
  }

  async middle(selector) {
    const { x, y, width, height } = await this.box(selector);
    return [x + width / 2, y + height / 2];
  }

  async click(selector) {
    const place = await this.middle(selector);
    await this.drag(place, place);
  }

  async drag([from_x, from_y], [to_x, to_y]) {
    const at = (share) => ({
      type: 'pointerMove',
      duration: 0,
      x: Math.round(from_x + share * (to_x - from_x)),
      y: Math.round(from_y + share * (to_y - from_y)),
    });
    const moves = Array.from({ length: MOVES }, (_, step) => at((step + 1) / MOVES));
    const [down, up] = ['pointerDown', 'pointerUp'].map((type) => ({
      type,
      button: 0,
    }));
    const actions = [at(0), down, ...moves, up];
    const parameters = { pointerType: 'mouse' };
    await this.browser.perform([{ type: 'pointer', id: 'mouse', parameters, actions }]);
  }

  async press(...names) {
    const keys = names.map((name) => KEYS[name] ?? name);
    const downs = keys.map((value) => ({ type: 'keyDown', value }));
    const ups = keys.toReversed().map((value) => ({ type: 'keyUp', value }));
    await this.browser.perform([{ type: 'key', id: 'keys', actions: [...downs, ...ups] }]);
  }

  /** Until the refined picture of the last input is on the screen. */
  async settled() {
    await this.until(() => {
      const { connection, still, input, sent } =
        document.querySelector('cutaway-app')?.dataset ?? {};
      return connection === 'connected' && still === 'true' && Number(input) >= Number(sent);
    });
  }

  /** A PNG, in base 64. */
  png() {
    return this.browser.screenshot();
  }

  async keep(name) {
    if (!screenshotFolder) return;
    await mkdir(screenshotFolder, { recursive: true });
    await writeFile(join(screenshotFolder, `${name}.png`), Buffer.from(await this.png(), 'base64'));
  }

  close() {
    return this.browser.close();
  }
}

/** Runs in the page. */
function boxOf(selector) {
  const found = (root) => {
    const hit = root.querySelector(selector);
    if (hit) return hit;
    for (const { shadowRoot } of root.querySelectorAll('*')) {
      const inside = shadowRoot && found(shadowRoot);
      if (inside) return inside;
    }
    return undefined;
  };
  const { x, y, width, height } = found(document)?.getBoundingClientRect() ?? {};
  return width > 0 ? { x, y, width, height } : undefined;
}

const open = (Browser) => async (size) => new Page(await Browser.start(size));

export const OTHER_BROWSERS = [
  { name: 'Firefox', open: open(Firefox), skip: missing(FIREFOX_NEEDS) },
  { name: 'WebKit', open: open(WebKit), skip: missing(WEBKIT_NEEDS) },
];
