// Names that the server sends in English.
import type { ServedWords } from '../served.ts';
import { modules, parameters } from './modules.ts';
import { styles } from './styles.ts';

export const served: ServedWords = {
  modules,
  parameters,
  styles,
  choices: {
    perspective: 'Perspektivisch',
    orthographic: 'Orthografisch',
    none: 'Keine',
    cutaway: 'Ausschnitt',
    magic: 'Magisch',
    flat: 'Flach',
    gradient: 'Nach dem Gradienten',
    section: 'Anatomischer Schnitt',
    closed: 'Geschlossen',
    funnel: 'Trichter zum Auge',
    open: 'Offen',
    camera: 'Kamera',
    patient: 'Patient',
    half: 'Halb',
    clamped: 'Begrenzt',
    brighten: 'Aufhellen',
    darken: 'Abdunkeln',
    multiply: 'Multiplizieren',
    colour: 'Farbe',
    luma: 'Helligkeit',
    depth: 'Tiefe',
    normal: 'Normale',
    raw: 'Roh',
    unit: 'Einheit',
    linear: 'Linear',
    cubic: 'Kubisch',
    curvature: 'Krümmung',
    parallel: 'Parallel',
  },
  units: { degrees: '°', 'per mm': 'je mm', 'per mille of the height': '‰ der Höhe' },
  volumes: {
    'phantom:head': 'Kopfphantom',
    'phantom:abdomen': 'Bauchphantom',
    'phantom:knees': 'Kniephantom',
  },
  notices: { 'Not for diagnostic use.': 'Nicht für diagnostische Zwecke.' },
};
