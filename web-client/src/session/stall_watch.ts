// Notices that an input waits long for its picture although there is a connection.
import { isAfter } from '../protocol/counter.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';

const LONG_MS = 6_000;

/** A picture may show later inputs, too: those of slices, which change nothing in it. */
const waits = ({ link, loading, volume, sent_input, shown_input }: ViewerState): boolean =>
  link.phase === 'connected' &&
  !loading &&
  volume !== undefined &&
  isAfter(sent_input, shown_input);

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
