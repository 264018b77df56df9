import type { Words } from '../words.ts';
import { descriptions } from './descriptions.ts';

export const controls: Words['controls'] = {
  description: (field) => descriptions[field],
  as_number: (label) => `${label}, Zahl`,

  mode: 'Modus',
  cut_surfaces: 'Schnittflächen',
  strength: 'Stärke',
  soft_rim: 'Weicher Rand',
  fade_everywhere: 'Kontext überall ausblenden',
  shape: 'Form',
  radius: 'Radius',
  centre_in_patient: 'Mitte im Patienten',
  centre_towards: {
    L: 'Mitte nach links (L)',
    P: 'Mitte nach posterior (P)',
    S: 'Mitte nach superior (S)',
  },

  lower_end: 'Unteres Ende (Isowert)',
  upper_end: 'Oberes Ende',
  upper_value: 'Oberer Wert',
  opacity: 'Deckkraft',
  hide_couch: 'Liege und Kopfstütze ausblenden',
  fill_context: 'Körper füllen',
  shading: 'Schattierung',

  light_turns_with: 'Licht dreht sich mit',
  light_from: 'Woher das Licht kommt, in Grad.',
  from_the_side: 'Von der Seite',
  from_above: 'Von oben',
  background: 'Hintergrund',
  background_hint: 'Hinter allem.',

  projection: 'Projektion',
  field_of_view: 'Sichtfeld',
};
