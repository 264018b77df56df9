// Messen: Werkzeuge, was sie sagen, und die Liste des Gemessenen.
import type { Words } from '../words.ts';

export const measure: Words['measure'] = {
  kinds: { distance: 'Strecke', angle: 'Winkel', probe: 'Messpunkt' },
  tools: 'Messwerkzeuge',
  tool_titles: {
    distance: 'Strecke zwischen zwei Punkten (m)',
    angle: 'Winkel zwischen drei Punkten (a)',
    probe: 'Wert und Lage an einem Punkt (v)',
  },
  steps: {
    distance: ['Strecke: ersten Punkt wählen', 'Zweiten Punkt wählen'],
    angle: ['Winkel: ersten Punkt wählen', 'Scheitel wählen', 'Letzten Punkt wählen'],
    probe: ['Messpunkt: Punkt wählen'],
  },
  surface_hint: 'Oberfläche anklicken oder antippen; Ziehen dreht',
  nothing_there: { volume: 'Hier ist keine Oberfläche', slice: 'Neben dem Volumen' },
  put_away: 'Werkzeug weglegen',
  take_back: 'Letzten Punkt zurücknehmen',

  none: 'In diesem Volumen wurde noch nichts gemessen.',
  how: 'Punkte liegen auf der gezeichneten Oberfläche oder in einer Schicht und bleiben an ihrer Stelle im Patienten.',
  list: 'Gemessen',
  rename: (name) => `Name von ${name}`,
  show: (name) => `${name} im Bild auswählen`,
  remove: (name) => `${name} löschen`,
  remove_all: 'Alle löschen',
  removed: (name) => `${name} wurde gelöscht`,
  all_removed: 'Alle Messungen dieses Volumens wurden gelöscht',
  unreadable: 'Ihre gespeicherten Messungen konnten nicht gelesen werden',
  unreadable_detail:
    'Sie sind beschädigt oder von einer anderen Version dieser Seite. Sie wurden beiseitegelegt, die Liste beginnt neu.',
  elsewhere: 'In einem anderen Volumen dieses Namens gemessen; nicht gezeigt',
  elsewhere_detail:
    'Diese Messungen bleiben erhalten und erscheinen, wenn jenes Volumen wieder geöffnet wird.',
  not_kept: 'Der Browser bewahrt Ihre Messungen nicht auf',
  not_kept_detail:
    'Sein Speicher ist voll oder abgeschaltet. Sie bleiben, bis diese Seite geschlossen wird.',
  as_json: 'Als JSON speichern',
  as_csv: 'Als CSV speichern',
  point: (name, number) => `${name}, Punkt ${number}`,
  point_hint: 'Pfeiltasten bewegen den Punkt, mit Umschalt um einzelne Pixel.',
  measured: (name, result) => `${name}: ${result}`,
  file: (volume) => `cutaway ${volume} Messungen`,

  at_target_depth: 'Maßstab in der Tiefe der Bildmitte; was näher liegt, ist größer',
  everywhere: 'Maßstab des ganzen Bildes',
  scale: (length) => `Maßstab: ${length}`,
};
