// The German texts, loaded when they are wanted.
import { controls } from './german/controls.ts';
import { export_words } from './german/export.ts';
import { keys } from './german/keys.ts';
import { look, own_styles, volume_browser } from './german/look.ts';
import { measure } from './german/measure.ts';
import { messages } from './german/messages.ts';
import { page } from './german/page.ts';
import { panel } from './german/panel.ts';
import { slices } from './german/slices.ts';
import { served } from './german/served.ts';
import { unseen } from './german/unseen.ts';
import { numberIn } from './plural.ts';
import type { Words } from './words.ts';

export const german: Words = {
  language: 'de',
  number: numberIn('de'),
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
