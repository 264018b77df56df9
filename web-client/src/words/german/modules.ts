import type { ServedWords } from '../served.ts';
import { filterParameters } from './filter_parameters.ts';
import { filters } from './filters.ts';

export const modules: ServedWords['modules'] = {
  ...filters,
  'shading.tone': {
    title: 'Tonwert',
    description:
      'Zwei Farben, von zwei flachen Tönen (Detail 0: Comic) bis zum weichen Verlauf von warm nach ' +
      'kühl (Detail 1: Gooch).',
  },
  'shading.gooch': {
    title: 'Gooch',
    description:
      'Das klassische Licht von warm nach kühl: Gelb zum Licht hin, Blau von ihm weg, je mit einem ' +
      'Anteil der eigenen Farbe der Oberfläche.',
  },
  'shading.ramp': {
    title: 'Verlauf',
    description:
      'Sechs Farben von der lichtabgewandten zur lichtzugewandten Seite, gemischt, wie das Auge sie ' +
      'sieht: der Ton einer gemalten Tafel.',
  },
  'shading.phong': {
    title: 'Phong',
    description:
      'Umgebungslicht, diffuses Licht und Glanz auf einer Farbe: die Kontrolle für Vergleiche.',
  },
  'lens_shape.sphere': {
    title: 'Kugel',
    description: 'Alle Punkte im Umkreis des Radius um die Mitte der Linse, im Patientenraum.',
  },
  'lens_shape.ellipsoid': {
    title: 'Ellipsoid',
    description: 'Eine Kugel, gestreckt in drei Richtungen, die senkrecht aufeinander stehen.',
  },
  'lens_shape.box': {
    title: 'Quader',
    description: 'Alle Punkte zwischen drei Paaren gleichlaufender Flächen.',
  },
  'lens_shape.cylinder': {
    title: 'Zylinder',
    description: 'Ein runder Stab mit flachen Enden, so dick wie die Linse.',
  },
  'lens_shape.cone': {
    title: 'Kegel',
    description:
      'Er weitet sich von der Spitze zu einer flachen Grundfläche, so breit wie die Linse, auf der ' +
      'Seite, zu der er zeigt.',
  },
};

export const parameters: ServedWords['parameters'] = {
  ...filterParameters,
  'shading.tone.detail': {
    title: 'Detail',
    description: '0 zeichnet zwei flache Töne mit einer Stufe am Terminator, 1 den ganzen Verlauf.',
  },
  'shading.tone.dark': {
    title: 'Dunkle Farbe',
    description: 'Vom Licht weg. Anzeigekodiertes sRGB.',
  },
  'shading.tone.light': {
    title: 'Helle Farbe',
    description: 'Zum Licht hin. Anzeigekodiertes sRGB.',
  },
  'shading.tone.lambert': {
    title: 'Lambert-Term',
    description:
      'Halb liest (1 + n·l) / 2, so behält die abgewandte Seite ihren Verlauf; begrenzt liest ' +
      'max(0, n·l).',
  },
  'shading.tone.terminator': {
    title: 'Terminator',
    description:
      'Das n·l, bei dem die Mitte des Verlaufs liegt; bei 0 wendet sich die Oberfläche vom Licht ab. ' +
      'Nur beim halben Lambert.',
  },
  'shading.tone.softness': {
    title: 'Weichheit der Stufe',
    description:
      'Breite der Stufe zwischen den beiden Tönen auf einer undurchsichtigen Oberfläche: bei 0 bleibt ' +
      'sie hart, sonst ist sie mindestens ein Pixel des Bildes breit, sodass ihre Treppen verschwinden.',
  },
  'shading.gooch.colour': {
    title: 'Farbe',
    description: 'Der Oberfläche selbst. Anzeigekodiertes sRGB.',
  },
  'shading.gooch.blue': { title: 'Blau (b)', description: 'Stärke des Blaus im kühlen Ton.' },
  'shading.gooch.yellow': { title: 'Gelb (y)', description: 'Stärke des Gelbs im warmen Ton.' },
  'shading.gooch.alpha': {
    title: 'Farbe im kühlen Ton (alpha)',
    description: 'Anteil der Farbe der Oberfläche im kühlen Ton.',
  },
  'shading.gooch.beta': {
    title: 'Farbe im warmen Ton (beta)',
    description: 'Anteil der Farbe der Oberfläche im warmen Ton.',
  },
  'shading.ramp.deepest': { title: 'Tiefste Farbe', description: 'Am weitesten vom Licht weg.' },
  'shading.ramp.deep': { title: 'Tiefe Farbe', description: 'Anzeigecodiertes sRGB.' },
  'shading.ramp.middle': { title: 'Mittlere Farbe', description: 'Anzeigecodiertes sRGB.' },
  'shading.ramp.light': { title: 'Helle Farbe', description: 'Anzeigecodiertes sRGB.' },
  'shading.ramp.lighter': { title: 'Hellere Farbe', description: 'Anzeigecodiertes sRGB.' },
  'shading.ramp.lightest': { title: 'Hellste Farbe', description: 'Dem Licht zugewandt.' },
  'shading.ramp.gamma': {
    title: 'Gamma',
    description:
      'Exponent des Halb-Lambert-Terms (1 + n·l) / 2, der den Verlauf durchläuft: über 1 wird die ' +
      'Mitte dunkler.',
  },
  'shading.ramp.step': {
    title: 'Stufe',
    description:
      'Anteil einer weichen Stufe von der tiefsten zur hellsten Farbe; bei 0 wird der Verlauf ' +
      'gleichmäßig durchlaufen.',
  },
  'shading.ramp.step_at': {
    title: 'Ort der Stufe',
    description: 'Wo auf dem Halb-Lambert-Term die Stufe ihre Mitte hat.',
  },
  'shading.ramp.step_width': {
    title: 'Breite der Stufe',
    description: 'Von ihrem Anfang bis zu ihrem Ende auf diesem Term.',
  },
  'shading.phong.model': {
    title: 'Glanzmodell',
    description:
      'Phong spiegelt das Licht an der Normalen; Blinn nimmt den Halbvektor, dessen Exponent für ' +
      'einen gleich großen Glanz etwa viermal so groß ist.',
  },
  'shading.phong.colour': {
    title: 'Farbe',
    description: 'Der Oberfläche. Anzeigekodiertes sRGB.',
  },
  'shading.phong.ambient': {
    title: 'Umgebungslicht',
    description: 'Anteil der Farbe, der nicht vom Licht abhängt.',
  },
  'shading.phong.diffuse': { title: 'Diffus', description: 'Anteil der Farbe, der n·l folgt.' },
  'shading.phong.specular': { title: 'Glanz', description: 'Helligkeit des weißen Glanzlichts.' },
  'shading.phong.exponent': { title: 'Exponent', description: 'Schärfe des Glanzlichts.' },
  'lens_shape.ellipsoid.width': {
    title: 'Breite',
    description: 'Ihre halbe Breite, in Radien der Linse.',
  },
  'lens_shape.ellipsoid.height': {
    title: 'Höhe',
    description: 'Ihre halbe Höhe, in Radien der Linse.',
  },
  'lens_shape.ellipsoid.depth': {
    title: 'Tiefe',
    description: 'Ihre halbe Tiefe, in Radien der Linse.',
  },
  'lens_shape.ellipsoid.azimuth_degrees': {
    title: 'Nach links gedreht',
    description:
      'Wohin die Form zeigt, um die Längsachse: 0 nach vorn, 90 zur linken Seite des Patienten.',
  },
  'lens_shape.ellipsoid.elevation_degrees': {
    title: 'Nach oben geneigt',
    description: 'Wie weit die Form nach oben zeigt: 90 zum Kopf, -90 zu den Füßen.',
  },
  'lens_shape.ellipsoid.roll_degrees': {
    title: 'Gerollt',
    description: 'Wie weit die Form um ihre eigene Richtung gedreht ist.',
  },
  'lens_shape.box.width': {
    title: 'Breite',
    description: 'Ihre halbe Breite, in Radien der Linse.',
  },
  'lens_shape.box.height': {
    title: 'Höhe',
    description: 'Ihre halbe Höhe, in Radien der Linse.',
  },
  'lens_shape.box.depth': {
    title: 'Tiefe',
    description: 'Ihre halbe Tiefe, in Radien der Linse.',
  },
  'lens_shape.box.azimuth_degrees': {
    title: 'Nach links gedreht',
    description:
      'Wohin die Form zeigt, um die Längsachse: 0 nach vorn, 90 zur linken Seite des Patienten.',
  },
  'lens_shape.box.elevation_degrees': {
    title: 'Nach oben geneigt',
    description: 'Wie weit die Form nach oben zeigt: 90 zum Kopf, -90 zu den Füßen.',
  },
  'lens_shape.box.roll_degrees': {
    title: 'Gerollt',
    description: 'Wie weit die Form um ihre eigene Richtung gedreht ist.',
  },
  'lens_shape.cylinder.length': {
    title: 'Länge',
    description: 'Ihre halbe Länge, in Radien der Linse.',
  },
  'lens_shape.cylinder.azimuth_degrees': {
    title: 'Nach links gedreht',
    description:
      'Wohin die Form zeigt, um die Längsachse: 0 nach vorn, 90 zur linken Seite des Patienten.',
  },
  'lens_shape.cylinder.elevation_degrees': {
    title: 'Nach oben geneigt',
    description: 'Wie weit die Form nach oben zeigt: 90 zum Kopf, -90 zu den Füßen.',
  },
  'lens_shape.cone.length': {
    title: 'Länge',
    description: 'Ihre halbe Länge, in Radien der Linse.',
  },
  'lens_shape.cone.azimuth_degrees': {
    title: 'Nach links gedreht',
    description:
      'Wohin die Form zeigt, um die Längsachse: 0 nach vorn, 90 zur linken Seite des Patienten.',
  },
  'lens_shape.cone.elevation_degrees': {
    title: 'Nach oben geneigt',
    description: 'Wie weit die Form nach oben zeigt: 90 zum Kopf, -90 zu den Füßen.',
  },
};
