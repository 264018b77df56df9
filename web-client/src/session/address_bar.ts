// Keeps the scene in the page's address, a moment after it came to rest.
import type { JsonObject } from '../state/merge_patch.ts';
import { sceneToAddress } from '../state/scene_address.ts';
import type { ViewerSession } from './viewer_session.ts';

const REST_MS = 400;

export function keepSceneInAddress(session: ViewerSession): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const write = async (): Promise<void> => {
    const { scene, comparing } = session.store.state;
    if (!scene || comparing) return;
    const address = await sceneToAddress(scene as JsonObject);
    if (session.store.state.scene !== scene || session.store.state.comparing) return;
    history.replaceState(null, '', address);
    session.store.update({ address_current: true });
  };
  session.store.subscribe((state, before) => {
    if (state.scene === before.scene) return;
    session.store.update({ address_current: false });
    clearTimeout(timer);
    timer = setTimeout(() => void write(), REST_MS);
  });
  window.addEventListener('hashchange', () => void session.openAddress());
}
