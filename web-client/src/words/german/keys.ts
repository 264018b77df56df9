import type { Words } from '../words.ts';

export const keys: Words['keys'] = {
  help: 'Hilfe',
  close: 'Schließen',
  gestures_heading: 'Maus, Touchpad, Finger',
  keys_heading: 'Tasten, während das Bild den Fokus hat',
  about: (notice) =>
    `${notice} Die Buchstaben an den Bildrändern sind die Richtungen des Patienten: R und L, A und ` +
    'P, S und I.',

  caps: { Shift: 'Umschalt', Alt: 'Alt', Ctrl: 'Strg', Esc: 'Esc' },

  gestures: {
    rotate: ['Ziehen, oder ein Finger', 'Drehen'],
    pan: ['Umschalt oder mittlere Taste + Ziehen, oder zwei Finger', 'Verschieben'],
    zoom: ['Rad oder rechte Taste + Ziehen, oder Spreizen', 'Zoomen'],
    move_lens: ['Am Griff in der Linse ziehen', 'Die Linse über die Oberfläche bewegen'],
    resize_lens: ['Alt oder Umschalt + Rad, oder am Rand ziehen', 'Größe der Linse ändern'],
    place_point: ['Mit Messwerkzeug klicken oder tippen', 'Punkt auf die Oberfläche setzen'],
  },

  groups: {
    view: 'Ansicht',
    lens: 'Linse',
    measure: 'Messen',
    style: 'Stil und Schritte',
    page: 'Seite',
  },
  meanings: {
    rotate: 'Drehen',
    pan: 'Verschieben',
    move_lens: 'Die Linse über die Oberfläche bewegen',
    zoom_in: 'Vergrößern',
    zoom_out: 'Verkleinern',
    larger_lens: 'Größere Linse',
    smaller_lens: 'Kleinere Linse',
    toggle_lens: 'Linse an oder aus',
    follow: 'Linse folgt dem Zeiger, bis f, Esc oder Ziehen',
    roll_left: 'Nach links rollen',
    roll_right: 'Nach rechts rollen',
    compare: 'Den vorigen Stil zeigen, solange gehalten',
    undo: 'Rückgängig',
    redo: 'Wiederholen',
    measure_distance: 'Strecke messen',
    measure_angle: 'Winkel messen',
    measure_probe: 'Wert und Lage an einem Punkt lesen',
    move_point: 'Mit Werkzeug: Punkt bewegen, mit Umschalt fein',
    rotate_with_tool: 'Mit Werkzeug: Ansicht drehen, mit Umschalt verschieben',
    place_point: 'Mit Werkzeug: Punkt setzen',
    take_back_point: 'Mit Werkzeug: letzten Punkt zurücknehmen',
    cancel_measuring: 'Messung aufgeben, dann das Werkzeug',
    reset_view: 'Ansicht zurücksetzen',
    export: 'Bild oder Film exportieren; beendet eine Aufzeichnung',
    record: 'Ansicht für einen Film aufzeichnen, oder das beenden',
    status_line: 'Statuszeile an oder aus',
    toggle_panel: 'Seitenleiste ein- oder ausblenden',
    help: 'Diese Übersicht',
  },
};
