// A user of the keyboard alone: after each key the focus is somewhere, and is seen there.
import assert from 'node:assert/strict';

/** More than the page has places for the focus. */
const MOST_TABS = 150;

export class Keyboard {
  constructor(viewer) {
    this.viewer = viewer;
    this.page = viewer.page;
  }

  async press(key, times = 1) {
    for (let time = 0; time < times; time++) {
      await this.page.keyboard.press(key);
      await this.assertFocusSeen(key);
    }
  }

  async type(text) {
    await this.page.keyboard.type(text);
    await this.assertFocusSeen(text);
  }

  /** With Tab, or back with Shift+Tab, past whatever lies between. */
  async goTo(target, key = 'Tab') {
    for (let tab = 0; tab < MOST_TABS; tab++) {
      if (await this.isOn(target)) return;
      await this.press(key);
    }
    assert.fail(`no ${key} leads to ${target}`);
  }

  /** Goes there and presses it. */
  async use(target, key = 'Tab') {
    await this.goTo(target, key);
    await this.press('Enter');
  }

  async isOn(target) {
    const places = await target.all();
    const focused = await Promise.all(
      places.map((place) => place.evaluate((element) => element.matches(':focus-within'))),
    );
    return focused.includes(true);
  }

  /** Waits a little: what had the focus may go, and hand it on once the page is drawn anew. */
  async assertFocusSeen(after) {
    try {
      await this.page.waitForFunction(isFocusSeen, undefined, {
        timeout: 2000,
        polling: 50,
      });
    } catch {
      assert.fail(`after ${after} the focus is not seen on ${await this.page.evaluate(focusPath)}`);
    }
  }
}

/** Runs in the page. Some controls draw the ring on a part beside the one that has the focus. */
function isFocusSeen() {
  const isRinged = (element) => {
    const { outlineStyle, outlineWidth, outlineColor } = getComputedStyle(element);
    const drawn = outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 1;
    return drawn && !/(transparent|, 0\))$/.test(outlineColor);
  };
  const isOnScreen = (element) => {
    const { left, top, right, bottom, width, height } = element.getBoundingClientRect();
    const is_inside = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
    return width > 0 && height > 0 && is_inside;
  };
  let at = document.activeElement;
  if (!at || at === document.body) return false;
  while (at.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
  const root = at.getRootNode();
  const beside = root instanceof ShadowRoot ? [...root.querySelectorAll('*'), root.host] : [at];
  return beside.some((element) => isRinged(element) && isOnScreen(element));
}

/** Runs in the page. */
function focusPath() {
  const path = [];
  for (let at = document.activeElement; at; at = at.shadowRoot?.activeElement) {
    const name = at.getAttribute('aria-label') ?? at.dataset.part ?? at.className;
    path.push(`${at.localName}${name ? ` “${name}”` : ''}`);
  }
  return path.join(' › ');
}
