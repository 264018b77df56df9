// Keeps the page in the theme that is preferred: the classes of the document, and what the browser
// draws itself.
import type { ViewerSession } from './viewer_session.ts';
import type { Theme, ThemeChoice } from '../preferences/preferences.ts';

/** Of the bar, which on a phone goes on into the browser's own. */
const BAR_COLOURS: Readonly<Record<Theme, string>> = { dark: '#12171b', light: '#ffffff' };

function show(page: Document, theme: Theme): void {
  page.documentElement.classList.toggle('wa-dark', theme === 'dark');
  page.documentElement.classList.toggle('wa-light', theme === 'light');
  page.querySelector('meta[name=color-scheme]')?.setAttribute('content', theme);
  page.querySelector('meta[name=theme-color]')?.setAttribute('content', BAR_COLOURS[theme]);
}

/** `prefers_light` is the operating system's wish, which may change. */
export function keepLook(
  session: ViewerSession,
  page: Document,
  prefers_light: MediaQueryList,
): void {
  const themeOf = (choice: ThemeChoice): Theme => {
    if (choice !== 'system') return choice;
    return prefers_light.matches ? 'light' : 'dark';
  };
  const follow = (): void => show(page, themeOf(session.store.state.preferences.theme));
  session.store.subscribe((state, before) => {
    if (state.preferences.theme !== before.preferences.theme) follow();
  });
  prefers_light.addEventListener('change', follow);
  follow();
}
