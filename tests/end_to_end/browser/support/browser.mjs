// Debian's Chromium, through the client's own copy of playwright-core.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';

const clientRequire = createRequire(
  new URL('../../../../web-client/package.json', import.meta.url),
);
const { chromium } = clientRequire('playwright-core');
export const axeSource = clientRequire('axe-core').source;

const executablePath = process.env.CUTAWAY_CHROMIUM ?? '/usr/bin/chromium';

/** Why no test can run here; false where they can. Where CI runs they have to, and fail. */
export function missing(paths) {
  const absent = paths.filter((path) => !existsSync(path));
  return absent.length > 0 && process.env.CI !== 'true' ? `no ${absent.join(', ')}` : false;
}

export const skip = missing([executablePath]);

const OPTIONS = [
  '--no-sandbox',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-default-apps',
  '--disable-sync',
  '--no-first-run',
];

export const openBrowser = () => chromium.launch({ executablePath, args: OPTIONS });

/** What the browser asks for; the page follows it. */
const WISHES = { locale: 'en-GB', colorScheme: 'dark' };

export const DESKTOP = { ...WISHES, viewport: { width: 1440, height: 900 } };
export const TABLET = { ...WISHES, viewport: { width: 1024, height: 768 }, hasTouch: true };
export const PHONE = {
  ...WISHES,
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};
