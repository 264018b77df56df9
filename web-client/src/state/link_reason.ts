// Why there is no connection, in words.
import type { LinkState } from '../stream/worker_messages.ts';
import { words } from '../words/words.ts';

/**
 * What the server itself said, where nothing more is known than that the connection was lost. The
 * same from one attempt to the next; nothing while there is a connection, or the first is made.
 */
export function lossInWords(link: LinkState): string | undefined {
  if (link.phase !== 'waiting' && link.phase !== 'connecting') return undefined;
  const { reason, said } = link;
  return reason && ((reason === 'lost' && said) || words().page.link_reasons[reason]);
}
