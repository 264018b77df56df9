import type { Words } from '../words.ts';

export const messages: Words['messages'] = {
  error_titles: {
    'unknown-volume': 'Dieses Volumen ist nicht auf dem Server',
    'volume-refused': 'Das Volumen konnte nicht geöffnet werden',
    'no-volume': 'Kein Volumen ist offen',
    'server-full': 'Der Server ist voll',
    'render-failed': 'Das Bild konnte nicht gerendert werden',
    'rate-limited': 'Zu viele Anfragen',
    'too-large': 'Zu groß für diesen Server',
    internal: 'Der Server hat einen Fehler gemacht',
  },
  refused_change: 'Der Server hat eine Änderung abgelehnt',
  field: (name) => `Feld: ${name}.`,
  expected: (what) => `Erwartet: ${what}.`,
  received: (what) => `Erhalten: ${what}.`,

  link_not_opened: 'Dieser Link konnte nicht geöffnet werden',
  new_view_instead: (reason) => `${reason}. Stattdessen wurde eine neue Ansicht geöffnet.`,
  link_faults: {
    too_large: 'der Link ist größer als jede Szene',
    damaged: 'der Link ist unvollständig oder beschädigt',
    unknown_form: 'der Link hat eine Form, die diese Version nicht kennt',
    no_scene: 'der Link enthält keine Szene',
  },
  view_not_restored: 'Die Ansicht vor der Unterbrechung konnte nicht wiederhergestellt werden',
  restored: 'Wieder verbunden',
  restored_detail: 'Die Ansicht ist wie zuvor.',
  opening_cancelled: 'Das Öffnen wurde abgebrochen',
  unexpected: 'Etwas Unerwartetes kam vom Server',
  nothing_to_compare: 'Es gibt noch keinen vorigen Stil zum Vergleichen',
  not_without_connection:
    'Ein anderes Volumen kann geöffnet werden, sobald wieder eine Verbindung besteht',
  part_missing: 'Ein Teil der Seite konnte nicht geladen werden',
  part_missing_detail:
    'Vielleicht wurde der Server erneuert. Bitte die Seite neu laden; die Ansicht bleibt erhalten.',
  picture_enlarged: 'Das Bild wird kleiner als dieses Fenster gezeichnet und vergrößert',
  picture_enlarged_detail: (drawn: string, place: string) =>
    `Dieser Server zeichnet höchstens ${drawn} Bildpunkte für einen Platz von ${place}.`,
  link_in_clipboard: 'Der Link zu dieser Ansicht ist in der Zwischenablage',
  link_in_address_bar: 'Der Link zu dieser Ansicht steht in der Adresszeile',
  picture: 'Bild',
  preferences_left_out: 'Ihre Einstellungen dieser Seite wurden ausgelassen',
  preference_faults: {
    damaged: 'Sie waren nicht lesbar. Die Seite beginnt wie beim ersten Besuch.',
    other_version:
      'Sie stammen von einer anderen Version. Die Seite beginnt wie beim ersten Besuch.',
  },
  preferences_not_kept:
    'Dieser Browser behält keine Einstellungen; sie gelten, bis die Seite geschlossen wird',
  language_not_loaded: 'Die Texte dieser Sprache konnten nicht geladen werden',
};
