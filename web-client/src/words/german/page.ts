import type { Words } from '../words.ts';

export const page: Words['page'] = {
  volumes_and_settings: 'Volumen und Einstellungen',
  showing: (title) => `${title} wird gezeigt`,

  links: {
    connecting: 'Verbindet',
    connected: 'Verbunden',
    queued: 'In der Warteschlange',
    gave_way: 'Unterbrochen',
    waiting: 'Getrennt',
  },
  bar: {
    view: 'Ansicht',
    follow: 'Linse folgt dem Zeiger',
    undo: 'Rückgängig',
    redo: 'Wiederholen',
    copy_link: 'Link zu dieser Ansicht kopieren',
    help: 'Hilfe und Tasten',
    hide_panel: 'Seitenleiste ausblenden',
    show_panel: 'Seitenleiste einblenden',
  },

  picture: '3-D-Bild',
  keys_in_short:
    'Pfeiltasten drehen, Plus und Minus zoomen, Umschalt und Pfeile bewegen die Linse. ' +
    'Das Fragezeichen zeigt alle Tasten.',
  no_volumes: 'Der Server hat keine Volumen.',
  looking_for_volumes: 'Volumen werden gesucht …',
  preparing: 'Das Bild wird vorbereitet …',
  connecting: 'Verbindung wird aufgebaut …',
  reconnecting: (reason) => `Verbindet neu: ${reason}.`,
  disconnected: (reason) => `Getrennt: ${reason}. Ein neuer Versuch läuft.`,
  stalled:
    'Seit einer Weile kein neues Bild: der Server ist beschäftigt oder die Verbindung stockt. Die Seite macht von selbst weiter.',
  try_now: 'Jetzt versuchen',
  queue: (place) =>
    `Der Server ist voll. ${
      place === 1 ? 'Sie sind als Nächstes an der Reihe' : `Sie stehen an Stelle ${place}`
    }; diese Seite macht von selbst weiter.`,
  gave_way:
    'Andere haben gewartet, und der Platz dieser Seite auf dem Server ging an sie. Sie macht weiter, sobald Sie zurück sind.',
  go_on: 'Weitermachen',
  link_reasons: {
    full: 'der Server ist voll',
    lost: 'die Verbindung ging verloren',
    no_answer: 'der Server antwortet nicht',
    too_large: 'eine Nachricht war weit größer, als der Server annimmt',
  },

  comparing: 'Voriger Stil',
  lens: 'Linse',
  lens_keys: 'Pfeiltasten bewegen die Linse über die Oberfläche, Plus und Minus ändern ihre Größe.',
  lens_size: 'Größe der Linse',
  lens_turn: 'Linse drehen',
  lens_follows: 'Die Linse folgt dem Zeiger. Escape beendet das.',
  lossy: 'verlustbehaftet',
  lossy_hint: 'JPEG-komprimiert',
  not_for_diagnosis: 'Nicht für diagnostische Zwecke',

  edges: { top: 'oben', right: 'rechts', bottom: 'unten', left: 'links' },
  directions: {
    A: 'Anterior',
    P: 'Posterior',
    R: 'Rechts',
    L: 'Links',
    S: 'Superior',
    I: 'Inferior',
  },

  opening_a_volume: 'Ein Volumen wird geöffnet',
  opening: (what) => `${what} wird geöffnet`,
  cancel: 'Abbrechen',
  stages: {
    read: 'Lesen',
    decode: 'Dekodieren',
    min_max: 'Analysieren',
    upload: 'Übertragen an den Renderer',
    ready: 'Bereit',
    cancelled: 'Abgebrochen',
    failed: 'Fehlgeschlagen',
  },
  dismiss: 'Schließen',

  status: {
    name: 'Status',
    frames_per_second: 'Bilder je Sekunde',
    at_rest: 'in Ruhe',
    latency: 'Latenz',
    bytes: 'Bild',
    scale: 'Auflösung',
    quality: 'Qualität',
    high: 'hoch',
    in_motion: 'in Bewegung',
    lossless: 'verlustfrei',
    renderer: 'Renderer',
  },
  hints: {
    name: 'Hinweise',
    turn: 'Ziehen dreht, das Rad zoomt',
    turn_by_touch: 'Ein Finger dreht, zwei zoomen',
    lens: 'Die Linse ziehen, um hineinzusehen',
    style: 'Stile und Volumen in der Leiste',
    got_it: 'Verstanden',
  },
};
