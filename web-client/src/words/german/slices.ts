import type { Words } from '../words.ts';

export const slices: Words['slices'] = {
  heading: 'Schichten',
  names: { '3d': '3-D', axial: 'Axial', coronal: 'Koronal', sagittal: 'Sagittal' },
  picture: (name) => `Schicht ${name.toLowerCase()}`,
  keys_in_short:
    'Pfeiltasten blättern durch die Schichten, Umschalt und Pfeile bewegen das Fadenkreuz, Plus und ' +
    'Minus zoomen. Das Fragezeichen zeigt alle Tasten.',
  scroller: (name) => `${name}: Lage`,
  window: (width, centre) => `W ${width} · C ${centre}`,
  window_drag: 'Ziehen ändert das Fenster (w)',
  tilted: 'schräg',
  tilt_handle: (name) => `Ebene ${name.toLowerCase()} kippen`,
  move_lens: 'Linse in dieser Schicht',
  lens_keys: 'Pfeiltasten bewegen die Linse in dieser Schicht, Plus und Minus ändern ihre Größe.',
  enlarge: (name) => `${name}: vergrößern (z)`,
  shrink: (name) => `${name}: zurück zu allen Ansichten (z)`,

  layout: 'Anordnung',
  layouts: {
    single: '3-D allein',
    grid: '3-D und drei Schichten',
    focus: 'Eine große, drei kleine',
  },
  show: 'Schichten zeigen',

  window_centre: 'Fenstermitte',
  window_width: 'Fensterbreite',
  presets_heading: 'Fenster',
  presets: {
    soft_tissue: 'Weichteile',
    lung: 'Lunge',
    bone: 'Knochen',
    brain: 'Gehirn',
    liver: 'Leber',
  },
  preset_hint: (key, centre, width) => `Mitte ${centre}, Breite ${width} (${key})`,
  presets_need_hu: 'Vorgegebene Fenster brauchen Hounsfield-Einheiten',
  convention: 'Konvention',
  convention_hint:
    'Radiologisch: die rechte Seite des Patienten ist links im Bild. Neurologisch: rechts.',
  conventions: { radiological: 'Radiologisch', neurological: 'Neurologisch' },
  lens_at_crosshair: 'Die Linse folgt dem Fadenkreuz',
  lens_at_crosshair_hint: 'Mit dem Fadenkreuz bewegt sich die Linse (l).',
  reset_tilt: 'Ebenen gerade richten',
  reset_views: 'Ganze Schichten',
};
