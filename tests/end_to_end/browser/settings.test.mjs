// What the page remembers: language, theme, panel; and a store that it cannot use.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { assertAccessible } from './support/accessible.mjs';
import { DESKTOP, PHONE, skip } from './support/browser.mjs';
import { served } from './support/suite.mjs';
import { Viewer } from './support/viewer.mjs';

const TABS = { de: ['Volumen', 'Stile', 'Anpassen', 'Ansicht'] };
const KEY = 'cutaway.preferences';

describe('the page in German and in the light', { skip }, () => {
  const suite = served();

  for (const [name, options] of Object.entries({
    desktop: DESKTOP,
    phone: PHONE,
  })) {
    it(`${name}: every tab and the help`, async () => {
      const viewer = await Viewer.open(suite.browser, suite.server.url, {
        ...options,
        locale: 'de-AT',
        colorScheme: 'light',
      });
      await viewer.settled();
      assert.equal(await viewer.page.locator('html').getAttribute('lang'), 'de');
      await viewer.page.getByText('Nicht für diagnostische Zwecke').first().waitFor();
      for (const tab of TABS.de) {
        await viewer.openTab(tab);
        await viewer.settled();
        await assertAccessible(viewer, tab);
        await viewer.screenshot(`${name}-light-${tab.toLowerCase()}`);
      }
      await viewer.page.getByRole('button', { name: 'Hilfe und Tasten' }).click();
      await viewer.page.getByRole('dialog', { name: 'Hilfe' }).waitFor();
      await assertAccessible(viewer, 'Hilfe');
      await viewer.screenshot(`${name}-light-help`);
      await viewer.close();
    });
  }
});

describe('preferences', { skip }, () => {
  const suite = served();
  const open = async (stored) => {
    const context = await suite.browser.newContext(DESKTOP);
    if (stored !== undefined)
      await context.addInitScript(([key, text]) => localStorage.setItem(key, text), [KEY, stored]);
    const viewer = new Viewer(await context.newPage(), suite.server.url);
    await viewer.page.goto(suite.server.url);
    return viewer;
  };

  it('change language and theme at once, and are there after a reload', async () => {
    const viewer = await open();
    await viewer.settled();
    const html = viewer.page.locator('html');
    await viewer.openTab('View');
    await viewer.choose('Theme', 'Light');
    assert.match(await html.getAttribute('class'), /wa-light/);
    await viewer.choose('Language', 'Deutsch');
    await viewer.page.getByRole('tab', { name: 'Ansicht' }).waitFor();
    assert.equal(await html.getAttribute('lang'), 'de');
    await viewer.page.getByRole('button', { name: 'Seitenleiste ausblenden' }).click();
    await viewer.page.reload();
    await viewer.settled();
    await viewer.app('[data-panel=closed]').waitFor();
    await viewer.page.getByRole('button', { name: 'Seitenleiste einblenden' }).click();
    await viewer.page.getByRole('tab', { name: 'Ansicht' }).waitFor();
    assert.match(await html.getAttribute('class'), /wa-light/);
    await viewer.close();
  });

  for (const [name, stored] of [
    ['another version', '{"version":99,"theme":"light"}'],
    ['broken', '{"version":1,'],
  ]) {
    it(`of a store that is ${name} are left out, with a message`, async () => {
      const viewer = await open(stored);
      const toast = viewer.page.locator('[data-part=toast]');
      await toast.filter({ hasText: 'Your settings for this page were left out' }).waitFor();
      await viewer.settled();
      assert.match(await viewer.page.locator('html').getAttribute('class'), /wa-dark/);
      await viewer.close();
    });
  }

  it('are not needed: a browser that refuses its storage shows the page', async () => {
    const context = await suite.browser.newContext(DESKTOP);
    await context.addInitScript(() =>
      Object.defineProperty(globalThis, 'localStorage', {
        get() {
          throw new DOMException('refused', 'SecurityError');
        },
      }),
    );
    const viewer = new Viewer(await context.newPage(), suite.server.url);
    await viewer.page.goto(suite.server.url);
    await viewer.settled();
    await viewer.page.getByRole('button', { name: 'Hide the panel' }).click();
    await viewer.page
      .locator('[data-part=toast]', {
        hasText: 'This browser keeps no settings',
      })
      .waitFor();
    await viewer.close();
  });
});
