// Wie etwas aussieht: Wertebereiche, Töne und eigene Stile.
import type { Words } from '../words.ts';

export const look: Words['look'] = {
  detail: 'Detail',
  detail_range: 'Detail, von Comic bis weich',
  tones: 'Töne, dunkel bis hell',

  tissues: {
    skin: 'Haut',
    muscle: 'Muskel',
    contrast_vessels: 'Gefäße mit Kontrastmittel',
    bone: 'Knochen',
  },
  tissue_presets: 'Gewebe',
  from: (lower) => `ab ${lower}`,
  between: (lower, upper) => `${lower} bis ${upper}`,
  not_in_volume: 'Kein Wert dieses Volumens liegt dort',
  histogram: 'Histogramm des Volumens, logarithmisch',
};

export const own_styles: Words['own_styles'] = {
  heading: 'Eigene Stile',
  none: 'Speichern Sie das jetzige Aussehen unter einem Namen, um es hier wiederzufinden.',
  name: 'Name des Aussehens',
  save: 'Speichern',
  replace: 'Ersetzen',
  import: 'Datei importieren',
  rename: (title) => `${title} umbenennen`,
  remove: (title) => `${title} löschen`,
  export: (title) => `${title} als Datei exportieren`,
  hint: 'Einer Ihrer eigenen Stile.',
  untitled: 'Importiertes Aussehen',

  file_refused: (name) => `${name} konnte nicht importiert werden`,
  not_json: (reason) => `Das ist kein JSON: ${reason}`,
  not_an_object: 'Ein Szenendokument ist ein JSON-Objekt, und das ist keines.',
  other_version: (came, expected) =>
    `Die Version ist ${came}; diese Seite liest Version ${expected}.`,
  unknown_field: (field) => `Ein Szenendokument hat kein Feld „${field}“.`,
  no_look: 'Es sagt nichts über das Aussehen: weder Fokus, Kontext, Linse, Licht noch Hintergrund.',
  too_large: (bytes, most) => `Die Datei hat ${bytes} Bytes, erlaubt sind ${most}.`,

  unreadable: 'Ihre gespeicherten Stile konnten nicht gelesen werden',
  unreadable_detail:
    'Sie sind beschädigt oder von einer anderen Version dieser Seite. Sie wurden beiseitegelegt, die Liste beginnt neu.',
  not_kept: 'Der Browser bewahrt Ihre Stile nicht auf',
  not_kept_detail:
    'Sein Speicher ist voll oder abgeschaltet. Sie bleiben, bis diese Seite geschlossen wird.',
};

export const volume_browser: Words['volume_browser'] = {
  search: 'Volumen suchen',
  modality: 'Modalität',
  any: 'Alle',
  none_found: 'Kein Volumen passt.',
  cancel: (title) => `Öffnen von ${title} abbrechen`,
};
