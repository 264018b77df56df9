// Keeps the page in the language that is preferred.
import type { ViewerSession } from './viewer_session.ts';
import { languageFor } from '../words/language.ts';
import { speak, words } from '../words/words.ts';

/** Ends once the page speaks the language that is preferred now. */
export async function keepSpeaking(
  session: ViewerSession,
  page: HTMLElement,
  wanted: readonly string[],
): Promise<void> {
  const follow = async (): Promise<void> => {
    const { language: choice } = session.store.state.preferences;
    const language = languageFor(choice, wanted);
    try {
      await speak(language);
    } catch {
      return session.toasts.problem(words().messages.language_not_loaded, '');
    }
    if (session.store.state.preferences.language !== choice) return;
    page.lang = language;
    session.spoken(language);
  };
  session.store.subscribe((state, before) => {
    if (state.preferences.language !== before.preferences.language) void follow();
  });
  await follow();
}
