// Why there is no connection, in words.
import type { LinkState } from '../stream/worker_messages.ts';
import { words } from '../words/words.ts';

type Waiting = Extract<LinkState, { phase: 'waiting' }>;

/** What the server itself said, where it did. */
export const linkReason = ({ reason, said }: Waiting): string =>
  said || words().page.link_reasons[reason];
