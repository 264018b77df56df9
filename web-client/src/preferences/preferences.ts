// What the page remembers of a user, and its form in the browser's storage.
import { isObject } from '../state/merge_patch.ts';
import { LANGUAGES, type LanguageChoice } from '../words/language.ts';
import { LAYOUTS, VIEW_NAMES, type Layout, type ViewName } from '../state/views.ts';
import { parsedJson } from './browser_storage.ts';

export const THEMES = ['dark', 'light'] as const;

export type Theme = (typeof THEMES)[number];

/** `system`: what the operating system asks for. */
export type ThemeChoice = Theme | 'system';

export const CONVENTIONS = ['radiological', 'neurological'] as const;

/** Which side of a slice is the patient's right: the scene has it, and a new one begins with this. */
export type Convention = (typeof CONVENTIONS)[number];

export interface Preferences {
  readonly language: LanguageChoice;
  readonly theme: ThemeChoice;
  readonly panel_open: boolean;
  /** The hints of the first visit have been seen, or sent away. */
  readonly hints_seen: boolean;
  /** Frames per second, latency and the like, under the picture. */
  readonly status_line: boolean;
  readonly layout: Layout;
  /** The view that is alone, or large. */
  readonly main_view: ViewName;
  readonly convention: Convention;
  /** Exported pictures have their labels drawn on them. */
  readonly picture_labels: boolean;
}

export const DEFAULT_PREFERENCES: Preferences = {
  language: 'auto',
  theme: 'system',
  panel_open: true,
  hints_seen: false,
  status_line: false,
  layout: 'single',
  main_view: '3d',
  convention: 'radiological',
  picture_labels: true,
};

/** Goes up when a field's meaning changes; a new field needs none, it has its default. */
const VERSION = 1;

export type PreferenceFault = 'damaged' | 'other_version';

export interface ReadPreferences {
  readonly preferences: Preferences;
  /** Why they are the defaults although something was stored. */
  readonly fault?: PreferenceFault;
}

const flag = (value: unknown, otherwise: boolean): boolean =>
  typeof value === 'boolean' ? value : otherwise;

function oneOf<Choice extends string>(
  choices: readonly Choice[],
  value: unknown,
  otherwise: Choice,
): Choice {
  return choices.find((choice) => choice === value) ?? otherwise;
}

/** `text` as stored; a field that says nothing sensible has its default. */
export function preferencesFrom(text: string | null, defaults: Preferences): ReadPreferences {
  if (text === null) return { preferences: defaults };
  const stored = parsedJson(text);
  if (!isObject(stored)) return { preferences: defaults, fault: 'damaged' };
  if (stored['version'] !== VERSION) return { preferences: defaults, fault: 'other_version' };
  const preferences: Preferences = {
    language: oneOf([...LANGUAGES, 'auto'], stored['language'], defaults.language),
    theme: oneOf([...THEMES, 'system'], stored['theme'], defaults.theme),
    panel_open: flag(stored['panel_open'], defaults.panel_open),
    hints_seen: flag(stored['hints_seen'], defaults.hints_seen),
    status_line: flag(stored['status_line'], defaults.status_line),
    layout: oneOf(LAYOUTS, stored['layout'], defaults.layout),
    main_view: oneOf(VIEW_NAMES, stored['main_view'], defaults.main_view),
    convention: oneOf(CONVENTIONS, stored['convention'], defaults.convention),
    picture_labels: flag(stored['picture_labels'], defaults.picture_labels),
  };
  return { preferences };
}

export const preferencesText = (preferences: Preferences): string =>
  JSON.stringify({ version: VERSION, ...preferences });
