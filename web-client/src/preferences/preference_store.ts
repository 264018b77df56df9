// Keeps the preferences in the browser's storage. Where there is none, or it is full or forbidden,
// the page works as it does on a first visit.
import type { ViewerSession } from '../session/viewer_session.ts';
import { words } from '../words/words.ts';
import { storedText, storeText, type OpenStorage } from './browser_storage.ts';
import {
  preferencesFrom,
  preferencesText,
  type PreferenceFault,
  type Preferences,
  type ReadPreferences,
} from './preferences.ts';

const KEY = 'cutaway.preferences';

export class PreferenceStore {
  constructor(private readonly open: OpenStorage) {}

  read(defaults: Preferences): ReadPreferences {
    return preferencesFrom(storedText(this.open, KEY), defaults);
  }

  /** Whether they are kept. */
  write(preferences: Preferences): boolean {
    return storeText(this.open, KEY, preferencesText(preferences));
  }
}

/** Reads the preferences, keeps every change from then on, and says once where that fails. */
export function keepPreferences(
  session: ViewerSession,
  store: PreferenceStore,
  defaults: Preferences,
): PreferenceFault | undefined {
  const { preferences, fault } = store.read(defaults);
  session.store.update({ preferences });
  let works = true;
  session.store.subscribe((state, before) => {
    if (state.preferences === before.preferences || !works) return;
    works = store.write(state.preferences);
    if (!works) session.toasts.note(words().messages.preferences_not_kept);
  });
  return fault;
}

export function sayLeftOut(session: ViewerSession, fault: PreferenceFault | undefined): void {
  const { preferences_left_out, preference_faults } = words().messages;
  if (fault) session.toasts.problem(preferences_left_out, preference_faults[fault]);
}
