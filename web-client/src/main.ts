// Wiring only: the canvases, the session that paints on them, and the page around them.
import './styles/theme.css';
import './icons/register.ts';
import { CutawayApp } from './components/app.ts';
import { isPhone } from './components/phone.ts';
import { listenToKeys } from './interaction/keyboard.ts';
import { keepFocus } from './interaction/kept_focus.ts';
import { observeHeldPointer } from './interaction/held_pointer.ts';
import { keepSceneInAddress } from './session/address_bar.ts';
import { pageSight } from './session/presence.ts';
import { openViewerSession } from './session/viewer_session.ts';
import { webSocketUrl } from './stream/stream.ts';
import { keepLook } from './session/kept_look.ts';
import type { WatchStorage } from './preferences/browser_storage.ts';
import { keepPreferences, sayLeftOut } from './session/kept_preferences.ts';
import { PreferenceStore } from './preferences/preference_store.ts';
import { DEFAULT_PREFERENCES } from './preferences/preferences.ts';
import { keepSpeaking } from './session/kept_speech.ts';
import { VIEW_NAMES } from './state/views.ts';

/** An address that is revoked before the browser has read it saves nothing. */
const SAVING_TAKES_MS = 60_000;

function saveFile(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), SAVING_TAKES_MS);
}

const canvases = VIEW_NAMES.map(() => document.createElement('canvas'));
const openStorage = () => localStorage;
const watchStorage: WatchStorage = (changed) =>
  window.addEventListener('storage', ({ key }) => changed(key));
const sight = pageSight(document, window);
const page = { saveFile, openStorage, watchStorage, sight };
const session = openViewerSession(canvases, webSocketUrl(location), page);
const defaults = { ...DEFAULT_PREFERENCES, panel_open: !isPhone() };
const fault = keepPreferences(session, new PreferenceStore(openStorage), defaults);
keepLook(session, document, matchMedia('(prefers-color-scheme: light)'));
keepSceneInAddress(session);
listenToKeys(window, session);
keepFocus(document, session.store);
observeHeldPointer((pointer_held) => session.store.update({ pointer_held }));

await keepSpeaking(session, document.documentElement, navigator.languages);
sayLeftOut(session, fault);
session.own_styling.restore();
session.measured.restore();

const app = new CutawayApp();
app.session = session;
app.canvases = canvases;
document.body.append(app);
