// The English texts. The other catalogues have the same keys.
import { controls } from './english/controls.ts';
import { keys } from './english/keys.ts';
import { messages } from './english/messages.ts';
import { page } from './english/page.ts';
import { panel } from './english/panel.ts';
import { numberIn } from './plural.ts';
import { AS_SERVED, type ServedWords } from './served.ts';

/** What the server sends is English already. */
const served: ServedWords = AS_SERVED;

export const english = {
  language: 'en',
  number: numberIn('en'),
  controls,
  keys,
  messages,
  page,
  panel,
  served,
};
