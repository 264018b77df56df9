// Keeps the preferences of a session from one visit to the next.
import type { PreferenceStore } from '../preferences/preference_store.ts';
import type { PreferenceFault, Preferences } from '../preferences/preferences.ts';
import { words } from '../words/words.ts';
import type { ViewerSession } from './viewer_session.ts';

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
