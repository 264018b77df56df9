// The page's texts in the language that it shows now. A page has one language (its `lang`), so this
// is one place for all components; those draw anew when the state's `language` changes.
import { english } from './english.ts';
import type { Language } from './language.ts';

/** Another language has every text of the English one. */
export type Words = typeof english;

const CATALOGUES: Readonly<Record<Language, () => Promise<Words>>> = {
  en: () => Promise.resolve(english),
  de: async () => (await import('./german.ts')).german,
};

let current: Words = english;

export const words = (): Words => current;

/** Throws where the catalogue cannot be loaded; the language then stays. */
export async function speak(language: Language): Promise<void> {
  current = await CATALOGUES[language]();
}
