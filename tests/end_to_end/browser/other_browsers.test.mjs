// A first visit in Firefox and in WebKit: what is drawn, moved, copied and written differently there.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { OTHER_BROWSERS } from './support/other_browsers.mjs';
import { iconInks } from './support/icons.mjs';
import { Server } from './support/server.mjs';

const DESKTOP = { width: 1440, height: 900 };
/** Half of each is filled on purpose. */
const HALF_FILLED = ['styles', 'compare'];

for (const { name, open, skip } of OTHER_BROWSERS) {
  describe(`a first visit in ${name}`, { skip }, () => {
    let server;
    let page;
    before(async () => {
      server = await Server.start();
      page = await open(DESKTOP);
    });
    after(async () => {
      await page?.close();
      await server?.kill();
    });

    const preferences = (preferences) =>
      page.run(
        (text) => localStorage.setItem('cutaway.preferences', text),
        JSON.stringify(preferences),
      );
    const slider = () => page.until(sliderAt, -1e9);
    const toastTexts = () =>
      page.run(() => {
        const stack = document
          .querySelector('cutaway-app')
          .shadowRoot.querySelector('cutaway-toast-stack');
        return stack.shadowRoot.textContent;
      });

    it('shows a picture, and three hints', async () => {
      await page.goto(server.url);
      await page.settled();
      await page.box('.hint.turn');
      await page.keep(`${name}-first-visit`);
    });

    for (const theme of ['dark', 'light']) {
      it(`draws icons with holes and contrast, ${theme}`, async () => {
        await preferences({ version: 1, theme, hints_seen: true });
        await page.goto(server.url);
        await page.settled();
        await page.keep(`${name}-${theme}`);
        const icons = await iconInks(page);
        assert.ok(icons.length >= 12, `${icons.length} icons`);
        for (const { icon, share, contrast } of icons) {
          assert.ok(share > 0.02, `${icon} covers ${share} of its place`);
          assert.ok(contrast >= 3, `${icon} has a contrast of ${contrast}`);
          const most = HALF_FILLED.includes(icon) ? 0.45 : 0.35;
          assert.ok(share < most, `${icon} covers ${share} of its place`);
        }
      });
    }

    it('moves a slice by its slider', async () => {
      await page.click('[data-layout=grid]');
      const [before_mm, text] = await slider();
      const [x, y] = await page.middle('[data-part=slice-scroller]');
      const { height } = await page.box('[data-part=slice-scroller]');
      await page.drag([x, y], [x, y - height / 4]);
      await page.until(sliderAt, before_mm + 10);
      await page.keep(`${name}-slices`);
      const [, text_after] = await slider();
      assert.notEqual(text, text_after);
    });

    it('copies a link', async () => {
      await page.click('nav wa-icon[name=link]');
      await page.until(() =>
        /clipboard|address bar/.test(
          document.querySelector('cutaway-app').shadowRoot.querySelector('cutaway-toast-stack')
            .shadowRoot.textContent,
        ),
      );
      assert.match(await toastTexts(), /in the clipboard/);
      await page.run(() => {
        const field = document.body.appendChild(document.createElement('textarea'));
        field.style = 'position: fixed; inset: 0 auto auto 0; z-index: 1000';
        field.focus();
      });
      await page.press('Control', 'v');
      const link = await page.until(() => document.querySelector('textarea').value);
      await page.run(() => document.querySelector('textarea').remove());
      assert.ok(link.startsWith(`${server.url}#`), link);
    });

    it('says what films it can write, and lives on', async () => {
      await page.click('nav wa-icon[name=save]');
      await page.click('.kinds button:last-child');
      await page.box('cutaway-export-film');
      await page.box('.primary:not(:disabled)');
      await page.keep(`${name}-film`);
      await page.press('Escape');
      await page.settled();
    });
  });
}

/** Runs in the page: value and text of the first slice's slider, once its picture shows it. */
function sliderAt(least_mm) {
  const views = document
    .querySelector('cutaway-app')
    .shadowRoot.querySelector('cutaway-views').shadowRoot;
  const scroller = views
    .querySelector('cutaway-slice-view[data-settled=true]')
    ?.shadowRoot.querySelector('cutaway-slice-scroller');
  const input = scroller?.shadowRoot.querySelector('input');
  const is_there = input?.valueAsNumber >= least_mm;
  return is_there && [input.valueAsNumber, input.getAttribute('aria-valuetext')];
}
