import type { ServedWords } from '../served.ts';

export const filterParameters: ServedWords['parameters'] = {
  'filter.kuwahara.radius': {
    title: 'Radius',
    description:
      'Reichweite der Fenster; 0 ändert nichts. Das ganze Fenster ist 2 Radius + 1 Pixel breit.',
  },
  'filter.sobel.strength': {
    title: 'Stärke',
    description:
      'Deckkraft der Linien; 0 ändert nichts, 1 zeichnet die stärksten Kanten ganz schwarz oder weiß.',
  },
  'filter.sobel.mode': {
    title: 'Modus',
    description:
      'Aufhellen addiert die Kanten, Abdunkeln zieht sie ab, Multiplizieren dunkelt um die Helligkeit ' +
      'der Kante ab und behält den Farbton.',
  },
  'filter.sobel.source': {
    title: 'Kanten von',
    description:
      'Wovon Linien gezeichnet werden: Farbe (jeder Kanal für sich), Helligkeit, Tiefe (Abstand vom ' +
      'Auge) oder Normale (Richtung der Oberfläche).',
  },
  'filter.sobel.silhouettes': {
    title: 'Umrisse',
    description:
      'Ob auch der eigene Umriss gezeichnet wird; der Rand, den eine Linse schneidet, nie.',
  },
  'filter.sobel.depth_step_mm': {
    title: 'Tiefenstufe',
    description: 'Für Kanten der Tiefe: der Unterschied, der als eine Stufe zählt.',
  },
  'filter.sobel.norm': {
    title: 'Normierung',
    description:
      'Roh behält den Maßstab des Kerns, in dem eine Stufe von einem Viertel schon eine volle Kante ' +
      'ist; Einheit teilt durch vier, sodass es eine Stufe von eins ist.',
  },
  'filter.sobel.gradient': {
    title: 'Länge des Gradienten',
    description:
      'L1 summiert die Beträge beider Richtungen; L2 zieht die Wurzel ihrer Quadratsumme, sodass ' +
      'schräge Linien so viel wiegen wie gerade.',
  },
  'filter.anisotropic_kuwahara.radius': {
    title: 'Radius',
    description: 'Des Pinsels; 0 ändert nichts.',
  },
  'filter.anisotropic_kuwahara.anisotropy': {
    title: 'Anisotropie',
    description:
      'Wie weit sich der Pinsel entlang von Kanten streckt: 0 lässt ihn rund (der ' +
      'verallgemeinerte Kuwahara-Filter), bei 1 ist er an einer idealen Kante viermal so lang ' +
      'wie breit.',
  },
  'filter.anisotropic_kuwahara.sharpness': {
    title: 'Schärfe',
    description:
      'Wie viel mehr ein ruhiger Sektor zählt als ein unruhiger: 0 zeichnet weich, 8 hält ' +
      'Kanten hart.',
  },
  'filter.depth_lines.width': {
    title: 'Breite',
    description: 'Einer Linie vor einem großen Sprung; 0 ändert nichts.',
  },
  'filter.depth_lines.thinnest': {
    title: 'Dünnste Linie',
    description: 'Breite einer Linie vor dem kleinsten Sprung, als Anteil der Breite.',
  },
  'filter.depth_lines.gap_mm': {
    title: 'Kleinster Sprung',
    description:
      'Wie viel weiter weg die nächste Oberfläche liegen muss, über die Schrägen auf beiden ' +
      'Seiten hinaus.',
  },
  'filter.depth_lines.full_gap_mm': {
    title: 'Voller Sprung',
    description: 'Ab welchem Sprung eine Linie ihre volle Breite hat.',
  },
  'filter.depth_lines.silhouettes': {
    title: 'Umrisse',
    description:
      'Ob auch der eigene Umriss gezeichnet wird; der Rand, den eine Linse schneidet, nie.',
  },
  'filter.dog.threshold': {
    title: 'Schwelle',
    description: 'Wie viel dunkler als ihre Umgebung eine Linie mindestens ist.',
  },
  'filter.dog.tau': {
    title: 'Anteil des breiteren Gauß-Filters (tau)',
    description: '1 lässt gleichmäßige Flächen frei; weniger zeichnet nur stärkere Kanten.',
  },
  'filter.xdog.edges': {
    title: 'Kanten (p)',
    description: 'Wie viel Kanten neben der Helligkeit selbst zählen.',
  },
  'filter.xdog.threshold': {
    title: 'Schwelle (epsilon)',
    description: 'Helligkeit, unter der Tusche liegt.',
  },
  'filter.xdog.hardness': {
    title: 'Härte (phi)',
    description: 'Wie plötzlich die Tusche unter der Schwelle beginnt.',
  },
  'filter.fdog.length': {
    title: 'Länge',
    description: 'Wie weit eine Linie auf ihrem Weg geglättet wird.',
  },
  'filter.fdog.tau': {
    title: 'Anteil des breiteren Gauß-Filters (tau)',
    description: '1 zeichnet jede Kante; weniger nur stärkere.',
  },
  'filter.fdog.hardness': {
    title: 'Härte (phi)',
    description: 'Wie plötzlich die Tusche beginnt.',
  },
  'filter.canny.high': {
    title: 'Obere Schwelle',
    description: 'Höhe der Stufe in der Helligkeit, ab der eine Kante stark ist.',
  },
  'filter.canny.low': {
    title: 'Untere Schwelle',
    description: 'Höhe, ab der eine Kante schwach ist, als Anteil der oberen Schwelle.',
  },
  'filter.canny.trail': {
    title: 'Spur',
    description: 'Wie weit von einer starken Kante eine schwache höchstens verfolgt wird.',
  },
  'filter.hatching.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Zeichnung über den eigenen Farben; 0 ändert nichts.',
  },
  'filter.hatching.width': {
    title: 'Breite',
    description: 'Eines Strichs, wo das Papier zur Hälfte Tusche ist; 0 ändert nichts.',
  },
  'filter.hatching.length': {
    title: 'Länge',
    description: 'Eines Strichs; er ist mindestens zwei Breiten lang.',
  },
  'filter.hatching.direction': {
    title: 'Richtung',
    description:
      'Krümmung: Striche laufen quer über die Form, dort entlang, wo die Oberfläche am stärksten ' +
      'gekrümmt ist; wo sie fast eben oder überall gleich gekrümmt ist, parallel. Parallel: alle ' +
      'Striche.',
  },
  'filter.hatching.angle_degrees': {
    title: 'Winkel',
    description: 'Paralleler Striche gegen die Waagerechte, gegen den Uhrzeigersinn.',
  },
  'filter.hatching.cross_from': {
    title: 'Gekreuzt ab',
    description:
      'Dunkelheit, ab der eine zweite Schar von Strichen die erste kreuzt: 0 ist Weiß, 1 Schwarz, ' +
      'und bei 1 kreuzt keine.',
  },
  'filter.hatching.ink': {
    title: 'Tusche',
    description: 'Farbe der Striche. Anzeigekodiertes sRGB.',
  },
  'filter.hatching.paper': {
    title: 'Papier',
    description: 'Farbe zwischen den Strichen. Anzeigekodiertes sRGB.',
  },
  'filter.hatching.wash': {
    title: 'Lavierung',
    description: 'Wie viel von der eigenen Farbe auf dem Papier zwischen den Strichen liegt.',
  },
  'filter.hatching.wall_darker': {
    title: 'Dunklere Wand',
    description:
      'Wie viel von dem Licht, das die Wand der Linse noch hat, ihr genommen wird, damit sie das ' +
      'Innere von dem trennt, was davor liegt.',
  },
  'filter.luminance_quantisation.bins': {
    title: 'Stufen',
    description: 'Wie viele Stufen von Schwarz bis Weiß.',
  },
  'filter.luminance_quantisation.hardness': {
    title: 'Härte',
    description: 'Der Kanten zwischen den Stufen: 1 ändert kaum etwas, 14 macht sie hart.',
  },
  'filter.depth_lines.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Linien; 0 ändert nichts.',
  },
  'filter.depth_lines.colour': {
    title: 'Tusche',
    description: 'Farbe der Linien. Anzeigekodiertes sRGB.',
  },
  'filter.dog.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Linien; 0 ändert nichts.',
  },
  'filter.dog.colour': {
    title: 'Tusche',
    description: 'Farbe der Linien. Anzeigekodiertes sRGB.',
  },
  'filter.xdog.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Linien; 0 ändert nichts.',
  },
  'filter.xdog.colour': {
    title: 'Tusche',
    description: 'Farbe der Linien. Anzeigekodiertes sRGB.',
  },
  'filter.fdog.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Linien; 0 ändert nichts.',
  },
  'filter.fdog.colour': {
    title: 'Tusche',
    description: 'Farbe der Linien. Anzeigekodiertes sRGB.',
  },
  'filter.canny.strength': {
    title: 'Stärke',
    description: 'Deckkraft der Linien; 0 ändert nichts.',
  },
  'filter.canny.colour': {
    title: 'Tusche',
    description: 'Farbe der Linien. Anzeigekodiertes sRGB.',
  },
  'filter.dog.sigma': {
    title: 'Sigma',
    description: 'Des schmaleren der beiden Gauß-Filter; 0 ändert nichts.',
  },
  'filter.xdog.sigma': {
    title: 'Sigma',
    description: 'Des schmaleren der beiden Gauß-Filter; 0 ändert nichts.',
  },
  'filter.fdog.sigma': {
    title: 'Sigma',
    description: 'Des schmaleren der beiden Gauß-Filter; 0 ändert nichts.',
  },
  'filter.canny.sigma': {
    title: 'Sigma',
    description: 'Des Gauß-Filters, bevor nach Kanten gesucht wird; 0 ändert nichts.',
  },
};
