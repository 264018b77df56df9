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
  opening: 'Öffnung',
  funnel_angle: 'Trichterwinkel',
  wall: {
    strength: 'Stärke ihrer Farbe',
    colour: 'Farbe',
    deepening: 'Dunkler mit der Tiefe',
    edge_mm: 'Heller Rand',
    edge_colour: 'Farbe des Randes',
  },
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
  islands: 'Teile weglassen unter',
  shading: 'Schattierung',

  smoothing: 'Glättung',
  smoothing_hint:
    'Beruhigt die Form, auf die Licht fällt, und lässt das Bild scharf. Automatisch passt zu den Voxeln dieses Volumens.',
  smoothings: { off: 'Aus', auto: 'Automatisch', mm: 'In Millimetern' },
  smoothing_width: 'Breite der Glättung',
  reconstruction: 'Zwischen Voxeln',
  occlusion: 'Umgebungsverdeckung',
  occlusion_near: 'Verdeckung: kleine Formen',
  occlusion_colour: 'Verdeckung: Farbe',
  shadow: 'Schatten',
  shadow_softness: 'Schatten: Weichheit',

  light_turns_with: 'Licht dreht sich mit',
  light_from: 'Woher das Licht kommt, in Grad.',
  from_the_side: 'Von der Seite',
  from_above: 'Von oben',
  background: 'Hintergrund',
  background_hint: 'Hinter allem.',

  projection: 'Projektion',
  field_of_view: 'Sichtfeld',
};
