import type { NameWords, ServedWords } from '../served.ts';

const kuwahara = (pixels: number): NameWords => ({
  title: `Kuwahara ${pixels}`,
  description: `Comic-Kontext, geglättet mit einem Kuwahara-Fenster von ${pixels} Pixeln; der Fokus schlicht.`,
});

const sobel = (strength: string, bright: boolean): NameWords => ({
  title: `Sobel ${strength}, ${bright ? 'helle' : 'dunkle'} Linien`,
  description: `Sobel-Linien der Stärke ${strength} auf dem Fokus, ${bright ? 'hell' : 'dunkel'} gezeichnet; der Kontext schlicht.`,
});

const tone = (title: string, detail: string): NameWords => ({
  title,
  description: `Der Tonwert allein mit Detail ${detail} auf beiden Zweigen, ohne Filter.`,
});

export const styles: ServedWords['styles'] = {
  'anatomy-atlas': {
    title: 'Anatomieatlas',
    description:
      'Für Handzettel und Druck: elfenbeinfarbener Knochen mit Tuschelinien in weicher, rosiger Haut, auf Papier.',
  },
  'bone-blueprint': {
    title: 'Knochen-Blaupause',
    description:
      'Für die Form allein: helle Linien und blasser Knochen auf Dunkelblau, der Körper hebt sich kaum vom Blatt.',
  },
  flagship: {
    title: 'Flaggschiff',
    description:
      'Für den ersten Blick auf jedes Volumen: Knochen von warm nach kalt mit Tiefenlinien, ruhige Haut in weichen Stufen, und eine Höhle, deren Wand das geschnittene Gewebe zeigt.',
  },
  gooch: {
    title: 'Gooch',
    description:
      'Für technische Klarheit, nach Gooch 1998: kühle Schatten bis warmes Licht, über einem ruhigen grauen Kontext.',
  },
  'magic-lens': {
    title: 'Magische Linse',
    description:
      'Um ein Inneres ohne Schnitt zu zeigen: der ganze Fokus über die Haut geblendet, weich zum Rand hin.',
  },
  'pen-and-ink': {
    title: 'Federzeichnung',
    description:
      'Für den Druck in einer Farbe: weißer Knochen in Strichen entlang seiner Form, Haut in einer Schar von Strichen, und eine dunkle, gekreuzt schraffierte Höhle.',
  },
  porcelain: {
    title: 'Porzellan',
    description:
      'Für Folien: eine dunkelblaue Zeichnung in einer glatten, blassen Schale, auf Hellgrau.',
  },
  toon: {
    title: 'Comic',
    description:
      'Für kleine Bilder und Schilder: zwei flache Töne auf jedem Zweig mit kräftigen dunklen Umrissen.',
  },
  section: {
    title: 'Schnitt',
    description:
      'Um Gewebe zu lernen: der Schnitt zeigt Fett, Muskel, Organ und Knochen in ihren Farben, auf weißem Papier.',
  },
  brain: {
    title: 'Gehirn',
    description:
      'Für MR: Flächen in Rosa und Violett mit tiefem, weichem Schatten in den Falten, in einem stillen grauen Kopf.',
  },
  angiography: {
    title: 'Angiographie',
    description:
      'Für Gefäße unter Kontrastmittel: leuchtendes Rot vor blassem Grau, sodass sich Äste verfolgen lassen.',
  },
  night: {
    title: 'Nacht',
    description: 'Für den Beamer im dunklen Saal: leuchtender Knochen in einem tiefblauen Körper.',
  },
  dissertation: {
    title: 'Dissertation',
    description:
      'Die Einstellung im Wortlaut: Fokus weich von Violett nach Orange unter Sobel-Linien, Kontext in zwei flachen Tönen unter Kuwahara.',
  },
  isoluminant: {
    title: 'Warm und kalt, gleich hell',
    description:
      'Der Fokus allein am Farbton zu erkennen: warme und kalte Töne einer Leuchtdichte, ohne Linien.',
  },
  cutaway: {
    title: 'Ausschnitt allein',
    description:
      'Nur Tonwerte, sodass nichts als der Ausschnitt den Fokus vom Kontext unterscheidet.',
  },
  'gooch-classic': {
    title: 'Gooch, klassische Konstanten',
    description:
      'Licht von warm nach kühl mit den Konstanten von 1998 auf beiden Zweigen, ohne Filter.',
  },
  'phong-control': {
    title: 'Phong (Kontrolle)',
    description:
      'Schlichtes Phong-Licht auf beiden Zweigen ohne Linien oder Abstraktion: womit die ' +
      'Illustrationen verglichen werden.',
  },
  'toon-sobel': {
    title: 'Comic mit Sobel-Linien',
    description:
      'Zwei flache Töne mit dunklen Linien auf beiden Zweigen: das Aussehen eines gedruckten Comics.',
  },
  'kuwahara-2': kuwahara(2),
  'kuwahara-5': kuwahara(5),
  'kuwahara-7': kuwahara(7),
  'kuwahara-10': kuwahara(10),
  'sobel-03-bright': sobel('0,3', true),
  'sobel-03-dark': sobel('0,3', false),
  'sobel-07-bright': sobel('0,7', true),
  'sobel-07-dark': sobel('0,7', false),
  'sobel-10-bright': sobel('1,0', true),
  'sobel-10-dark': sobel('1,0', false),
  'tone-half': tone('Tonwert 0,5: dazwischen', '0,5'),
  'tone-smooth': tone('Tonwert 1: weich', '1'),
  'tone-toon': tone('Tonwert 0: Comic', '0'),
};
