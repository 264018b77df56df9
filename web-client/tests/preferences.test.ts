import { describe, expect, it } from 'vitest';
import { PreferenceStore } from '../src/preferences/preference_store.ts';
import {
  DEFAULT_PREFERENCES,
  preferencesFrom,
  preferencesText,
  type Preferences,
} from '../src/preferences/preferences.ts';
import { keepPreferences, sayLeftOut } from '../src/session/kept_preferences.ts';
import { Harness } from './harness.ts';

const CHOSEN: Preferences = {
  language: 'de',
  theme: 'light',
  panel_open: false,
  hints_seen: true,
  status_line: true,
  layout: 'focus',
  main_view: 'axial',
  convention: 'neurological',
  picture_labels: false,
};

function storage(text: string | null = null) {
  const kept = { text };
  const setItem = (_key: string, value: string): void => void (kept.text = value);
  return { kept, store: new PreferenceStore(() => ({ getItem: () => kept.text, setItem })) };
}

const refusing = new PreferenceStore(() => {
  throw new DOMException('The operation is insecure.', 'SecurityError');
});

function begin(store: PreferenceStore): Harness {
  const harness = new Harness();
  const fault = keepPreferences(harness.session, store, DEFAULT_PREFERENCES);
  sayLeftOut(harness.session, fault);
  return harness;
}

describe('stored preferences', () => {
  it('come back as they were', () => {
    expect(preferencesFrom(preferencesText(CHOSEN), DEFAULT_PREFERENCES)).toEqual({
      preferences: CHOSEN,
    });
  });

  it.each([
    ['nothing', null, undefined],
    ['no JSON', '{"version":1', 'damaged'],
    ['no object', '[1]', 'damaged'],
    ['another version', '{"version":2,"theme":"light"}', 'other_version'],
    ['no version', '{"theme":"light"}', 'other_version'],
  ])('%s: the defaults', (_name, text, fault) => {
    const read = preferencesFrom(text, DEFAULT_PREFERENCES);
    expect(read.preferences).toEqual(DEFAULT_PREFERENCES);
    expect(read.fault).toBe(fault);
  });

  it('have the default where a field makes no sense, and keep the others', () => {
    const text = '{"version":1,"theme":"mauve","language":7,"hints_seen":"yes","panel_open":false}';
    expect(preferencesFrom(text, DEFAULT_PREFERENCES).preferences).toEqual({
      ...DEFAULT_PREFERENCES,
      panel_open: false,
    });
  });
});

describe('the page', () => {
  it('remembers each change for the next visit', () => {
    const { kept, store } = storage();
    const first = begin(store);
    expect(kept.text).toBeNull();
    first.session.commands.prefer({ theme: 'light' });
    first.session.commands.togglePanel();
    const second = begin(store);
    expect(second.state.preferences).toEqual({
      ...DEFAULT_PREFERENCES,
      theme: 'light',
      panel_open: false,
    });
  });

  it('says that those of another version were left out, and works', () => {
    const { kept, store } = storage('{"version":9}');
    const { state, session } = begin(store);
    expect(state.preferences).toEqual(DEFAULT_PREFERENCES);
    expect(state.toasts.map(({ detail }) => detail)).toEqual([
      'They are of another version. The page starts as on a first visit.',
    ]);
    session.commands.prefer({ theme: 'dark' });
    expect(preferencesFrom(kept.text, DEFAULT_PREFERENCES).preferences.theme).toBe('dark');
  });

  it('works where the browser refuses its storage, and says so once', () => {
    const { session } = begin(refusing);
    expect(session.store.state.toasts).toEqual([]);
    session.commands.prefer({ theme: 'light' });
    session.commands.prefer({ theme: 'dark' });
    expect(session.store.state.preferences.theme).toBe('dark');
    expect(session.store.state.toasts.map(({ title }) => title)).toEqual([
      'This browser keeps no settings; they last until the page is closed',
    ]);
  });
});
