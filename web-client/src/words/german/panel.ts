import { pluralIn } from '../plural.ts';
import type { Words } from '../words.ts';

const plural = pluralIn('de');

export const panel: Words['panel'] = {
  name: 'Seitenleiste',
  tabs: {
    volumes: 'Volumen',
    styles: 'Stile',
    adjust: 'Anpassen',
    measure: 'Messen',
    view: 'Ansicht',
  },
  reset: (group) => `${group}: zurücksetzen`,
  advanced: 'Erweitert',

  volumes: {
    none: 'Noch keine Volumen.',
    scanning: 'Weitere Volumen werden gesucht …',
    refused: (count) =>
      plural(count, {
        one: '# konnte nicht gelesen werden',
        other: '# konnten nicht gelesen werden',
      }),
  },

  styles: {
    waiting: 'Warten auf den Server …',
    illustrations: 'Illustrationen',
    studies: 'Technikstudien',
    hold_to_compare: 'Zum Vergleichen halten',
    hold_to_compare_hint: 'Zeigt den vorigen Stil, solange gehalten wird',
    own_look: 'Ihr eigener Stil.',
    own_look_hint: 'Kein benannter Stil hat diese Einstellungen.',
  },

  adjust: {
    later: 'Öffnet sich mit dem ersten Bild.',
    focus: 'Fokus',
    focus_hint: 'in der Linse',
    context: 'Kontext',
    context_hint: 'um sie herum',
    lens: 'Linse',
    wall: 'Wand der Höhlung',
    surface_and_light: 'Oberfläche und Licht',
    only_opaque:
      'Nur auf undurchsichtigen Oberflächen: wo Fokus und Kontext beide die Deckkraft 1 haben.',
    light: 'Licht',
    light_and_background: 'Licht und Hintergrund',
    filters: 'Filter, in ihrer Reihenfolge',
    add: (filter) => `${filter} hinzufügen`,
    earlier: (filter) => `${filter}: früher`,
    later_in_order: (filter) => `${filter}: später`,
    remove: (filter) => `${filter}: entfernen`,
  },

  view: {
    look_from: 'Blick von',
    reset: 'Ansicht zurücksetzen',
    projection: 'Projektion',
    view: 'Ansicht',
    status: 'Status',
    software:
      'Der Server hat keinen Grafikprozessor: Bilder entstehen in Software, und das langsam.',
    server: 'Server',
    renderer: 'Renderer',
    picture: 'Bild',
    picture_size: (rendered, shown) => `${rendered} von ${shown}`,
    quality: 'Qualität',
    still: 'ruhend',
    in_motion: 'in Bewegung',
    size: 'Größe',
    render_encode: 'Rendern, Kodieren',
    latency: 'Eingabe bis Bild',
    frames_per_second: 'Bilder in der letzten Sekunde',
  },

  settings: {
    heading: 'Diese Seite',
    language: 'Sprache',
    as_browser: 'Wie der Browser',
    status_line: 'Statuszeile unter dem Bild',
    theme: 'Farbschema',
    themes: { system: 'Wie das System', dark: 'Dunkel', light: 'Hell' },
  },
};
