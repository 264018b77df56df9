// Keeps the preferences in the browser's storage. Where there is none, or it is full or forbidden,
// the page works as it does on a first visit.
import { storedText, storeText, type OpenStorage } from './browser_storage.ts';
import {
  preferencesFrom,
  preferencesText,
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
