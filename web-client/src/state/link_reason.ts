// Why there is no connection, in words.
import type { LinkState } from '../stream/worker_messages.ts';
import { words } from '../words/words.ts';

type Waiting = Extract<LinkState, { phase: 'waiting' }>;

/** What the server itself said, where nothing more is known than that the connection was lost. */
export const linkReason = ({ reason, said }: Waiting): string =>
  (reason === 'lost' && said) || words().page.link_reasons[reason];
