// The oldest browsers that the page has to work in: Safari 17.4, and the Firefox ESR (128) of its
// time. What Web Awesome needs is no older: `:state()`. Vite's target lowers the syntax of scripts
// and of style sheets, but neither what a script calls nor the styles inside of scripts.
import { parse } from 'acorn';

export const BUILD_TARGET = ['es2022', 'safari17.4', 'firefox128', 'chrome125'];
const ECMA_VERSION = 2022;

/** Without which a page does not work; what only looks plainer without it may be used. */
const NEWER = {
  'light-dark(': 'Safari 17.5',
  '@starting-style': 'Safari 17.5',
  'allow-discrete': 'Safari 18',
  'style(--': 'Safari 18, Firefox 151',
  'anchor-name:': 'Safari 26',
  'position-area:': 'Safari 26',
  'position-try': 'Safari 26',
  'anchor(': 'Safari 26',
  'calc-size(': 'Chromium alone',
  'contrast-color(': 'Safari 26',
  'sibling-index(': 'Safari 26.2',
  '@scope': 'Firefox 146',
  '@function': 'Chromium alone',
  'animation-timeline:': 'Safari 26',
  'Promise.try(': 'Safari 18.2, Firefox 134',
  'RegExp.escape(': 'Safari 18.2, Firefox 134',
  'Iterator.from(': 'Safari 18.4, Firefox 131',
  'Error.isError(': 'Safari 26, Firefox 138',
  'Math.sumPrecise(': 'Safari 26.2, Firefox 137',
  'URL.parse(': 'Safari 18',
  '.fromBase64(': 'Safari 18.2, Firefox 133',
  '.toBase64(': 'Safari 18.2, Firefox 133',
  '.moveBefore(': 'Firefox 144, no Safari',
  '.startViewTransition(': 'Safari 18, Firefox 144',
  'new Float16Array(': 'Safari 18.2, Firefox 129',
  'new CloseWatcher(': 'no Safari',
  'requestIdleCallback(': 'no Safari',
  'scheduler.postTask(': 'no Safari',
};

function syntaxError(text) {
  try {
    parse(text, { ecmaVersion: ECMA_VERSION, sourceType: 'module' });
    return undefined;
  } catch (error) {
    return `syntax newer than ES${ECMA_VERSION}: ${error.message}`;
  }
}

/** What a built script or style sheet holds that the oldest browsers lack, in words. */
export function newerThanFloor(text, is_script) {
  const found = Object.entries(NEWER).filter(([feature]) => text.includes(feature));
  const problems = found.map(([feature, since]) => `${feature} needs ${since}`);
  const error = is_script && syntaxError(text);
  return error ? [error, ...problems] : problems;
}
