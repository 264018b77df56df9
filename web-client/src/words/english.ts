// The English texts. The other catalogues have the same keys.
import { controls } from './english/controls.ts';
import { export_words } from './english/export.ts';
import { keys } from './english/keys.ts';
import { look, own_styles, volume_browser } from './english/look.ts';
import { measure } from './english/measure.ts';
import { messages } from './english/messages.ts';
import { page } from './english/page.ts';
import { panel } from './english/panel.ts';
import { slices } from './english/slices.ts';
import { unseen } from './english/unseen.ts';
import { numberIn } from './plural.ts';
import { AS_SERVED, type ServedWords } from './served.ts';

/** What the server sends is English already; beside a number its units are as short as can be. */
const served: ServedWords = {
  ...AS_SERVED,
  units: { degrees: '°', 'per mille of the height': '‰ of height' },
};

export const english = {
  language: 'en',
  number: numberIn('en'),
  controls,
  export: export_words,
  keys,
  look,
  measure,
  messages,
  own_styles,
  page,
  panel,
  served,
  slices,
  unseen,
  volume_browser,
};
