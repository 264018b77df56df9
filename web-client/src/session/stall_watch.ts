// Notices that an input waits long for its picture although there is a connection.
import type { Store } from '../state/store.ts';
import { awaitsPicture, type ViewerState } from '../state/viewer_state.ts';

const LONG_MS = 6_000;

/** A picture may show later inputs, too: those of slices, which change nothing in it. */
const waits = (state: ViewerState): boolean =>
  state.link.phase === 'connected' &&
  !state.loading &&
  state.volume !== undefined &&
  awaitsPicture(state);

/** Any picture, however old its input, shows that the stream goes on. */
export function watchForStalls(store: Store<ViewerState>): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  store.subscribe((state, before) => {
    const goes_on = !waits(state) || state.shown !== before.shown;
    if (goes_on) {
      clearTimeout(timer);
      timer = undefined;
      store.update({ stalled: false });
    }
    if (waits(state)) timer ??= setTimeout(() => store.update({ stalled: true }), LONG_MS);
  });
}
