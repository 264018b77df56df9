import type { ServedWords } from '../served.ts';

export const filters: ServedWords['modules'] = {
  'filter.kuwahara': {
    title: 'Kuwahara',
    description:
      'Glättet Textur und behält Kanten: jedes Pixel nimmt die mittlere Farbe des ruhigsten der ' +
      'vier Fenster um es herum.',
  },
  'filter.sobel': {
    title: 'Sobel-Linien',
    description: 'Zeichnet Linien, wo sich Farbe oder Deckung ändern.',
  },
  'filter.anisotropic_kuwahara': {
    title: 'Pinsel (anisotroper Kuwahara)',
    description:
      'Glättet Textur wie Pinselstriche, die den Kanten folgen: von acht Sektoren einer Ellipse ' +
      'um jedes Pixel zählen die ruhigen.',
  },
  'filter.depth_lines': {
    title: 'Tiefenlinien',
    description:
      'Zeichnet die Umrisse dessen, was vorn liegt, umso breiter, je weiter dahinter die ' +
      'nächste Oberfläche liegt; Schrägen und die Ringe von Schichten haben keine.',
  },
  'filter.dog': {
    title: 'Kanten (DoG)',
    description:
      'Zeichnet Linien auf der dunklen Seite von Kanten der Helligkeit, glatt und gleichmäßig ' +
      'breit: die Differenz von Gauß-Filtern.',
  },
  'filter.xdog': {
    title: 'Tusche (XDoG)',
    description:
      'Macht aus der Helligkeit des Bildes Tusche: Linien an Kanten und Schwarz, wo es dunkel ' +
      'ist. Es ist die erweiterte Differenz von Gauß-Filtern.',
  },
  'filter.fdog': {
    title: 'Zusammenhängende Linien (FDoG)',
    description:
      'Zeichnet Linien an Kanten der Helligkeit, die dem Fluss des Bildes folgen, ohne Lücken ' +
      'und Punkte: die Differenz von Gauß-Filtern im Fluss.',
  },
  'filter.canny': {
    title: 'Kanten (Canny)',
    description:
      'Zeichnet ein Pixel breite Linien auf dem Kamm jeder Kante der Helligkeit: starke, und ' +
      'schwache, zu denen eine starke führt.',
  },
  'filter.hatching': {
    title: 'Schraffur (Federzeichnung)',
    description:
      'Zeichnet in Tuschestrichen, die umso dichter liegen, je dunkler das Bild ist: entlang der ' +
      'Krümmung der Oberfläche oder parallel, gekreuzt, wo es dunkel ist, und mit einer eigenen ' +
      'Schar auf der Wand der Linse.',
  },
  'filter.luminance_quantisation': {
    title: 'Tontrennung',
    description:
      'Sammelt die Helligkeit in wenigen Stufen mit weichen Kanten dazwischen und behält den ' +
      'Farbton.',
  },
};
