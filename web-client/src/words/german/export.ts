// Bilder und Filme exportieren.
import { numberIn, pluralIn } from '../plural.ts';
import type { Words } from '../words.ts';

const number = numberIn('de');
const plural = pluralIn('de');

export const export_words: Words['export'] = {
  heading: 'Export',
  open: 'Bild oder Film exportieren (e)',
  kinds: { picture: 'Bild', film: 'Film' },
  kind: 'Was exportiert wird',

  picture_of: 'Bild der Ansicht',
  size: 'Größe',
  width: 'Breite',
  height: 'Höhe',
  keep_shape: 'Form der Ansicht behalten',
  free_shape_hint: 'Ein breiteres Bild zeigt an den Seiten mehr, ein schmaleres weniger.',
  presets: {
    view: 'Wie die Ansicht',
    double: 'Doppelte Ansicht',
    hd: 'HD',
    full_hd: 'Full HD',
    '4k': '4K',
    '8k': '8K',
    a4: 'A4 gedruckt, 300 dpi',
    a3: 'A3 gedruckt, 300 dpi',
    own: 'Eigene Größe',
  },
  preset: (name, size) => `${name} · ${size}`,
  pixels: (width, height) => `${width} × ${height}`,
  labels: 'Beschriftung im Bild',
  labels_hint:
    'Die Richtungen des Patienten, ein Maßstab, der Name des Volumens, was eine Schicht zeigt, und der Hinweis.',
  at_target_depth: (length) => `${length} in mittlerer Tiefe`,
  labels_left_out: 'Ohne Beschriftung gespeichert',
  labels_left_out_detail:
    'Dieser Browser kann in ein Bild dieser Größe nicht zeichnen. Ein kleineres kann sie haben.',
  picture_note: (notice) => `Verlustfreies PNG. „${notice}“ steht im Bild und in der Datei.`,
  bare_picture_note: (notice) =>
    `Verlustfreies PNG, ohne Zeichen darauf. „${notice}“ steht in der Datei, nicht im Bild.`,
  save_picture: 'Bild speichern',

  motion: 'Bewegung',
  motions: { turntable: 'Drehteller', path: 'Aufgezeichnet' },
  axis: 'Dreht um',
  axes: { superior: 'Kopf–Fuß', view_up: 'Senkrecht im Bild' },
  direction: 'Vorderseite geht',
  directions: { right: 'Nach rechts', left: 'Nach links' },
  angle: 'Drehung',
  seconds: 'Dauer',
  frames_per_second: 'Bilder je Sekunde',
  format: 'Format',
  formats: { mp4: 'MP4', webm: 'WebM', zip: 'Nummerierte PNG im ZIP' },
  format_with: (format, codec) => `${format} (${codec})`,
  codecs: { avc: 'H.264', hevc: 'H.265', vp9: 'VP9', av1: 'AV1', vp8: 'VP8' },
  looking: 'Es wird geprüft, was dieser Browser schreiben kann …',
  missing: {
    insecure:
      'Browser kodieren Video nur für Seiten, die über HTTPS oder von diesem Rechner kommen',
    no_encoder: 'dieser Browser hat keinen Videokodierer',
    no_codec: 'dieser Browser hat dafür bei dieser Größe keinen Kodierer',
  },
  format_missing: (format, reason) => `Kein ${format}: ${reason}.`,
  film_facts: (frames, seconds) =>
    `${plural(frames, { one: '# Bild', other: '# Bilder' })}, ${number(seconds, 1)} s`,
  film_note: (notice) => `„${notice}“ steht in jedem Bild.`,
  bare_film_note: (notice) =>
    `„${notice}“ steht klein in jedem Bild; nummerierte Bilder bleiben, wie der Server sie gemacht hat, und haben es in der Datei.`,
  save_film: 'Film herstellen',

  record: 'Ansicht aufzeichnen',
  record_anew: 'Neu aufzeichnen',
  record_hint:
    'Bewegen Sie die Ansicht, die Linse, was Sie wollen, und halten Sie an. Der Film zeigt es wieder, ohne Ruckeln.',
  recorded: (seconds) => `Aufgezeichnet: ${number(seconds, 1)} s`,
  recording: 'Aufzeichnung',
  stop: 'Anhalten',

  making: { picture: 'Das Bild entsteht', film: 'Der Film entsteht' },
  waiting: 'Wartet auf den Server…',
  go_on: 'Sie können dies schließen und inzwischen weiterarbeiten.',
  frame_of: (done, frames) => `Bild ${number(done)} von ${number(frames)}`,
  seconds_left: (seconds) => plural(seconds, { one: 'noch # Sekunde', other: 'noch # Sekunden' }),
  minutes_left: (minutes) =>
    plural(minutes, { one: 'noch etwa # Minute', other: 'noch etwa # Minuten' }),
  cancel: 'Abbrechen',
  saved: (name) => `Gespeichert: ${name}`,
  megabytes: (megabytes) => `${number(megabytes, 1)} MB`,

  failed: 'Der Export ist gescheitert',
  other_volume: 'Der Export wurde aufgegeben',
  other_volume_detail: 'Inzwischen wurde ein anderes Volumen geöffnet.',
};
