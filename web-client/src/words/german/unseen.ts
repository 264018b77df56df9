import type { UnseenReason } from '../../protocol/messages.ts';
import { valueIn } from '../plural.ts';
import type { Words } from '../words.ts';

const number = valueIn('de');
const branch = (reason: UnseenReason): string => (reason.branch === 'focus' ? 'Fokus' : 'Kontext');

export const unseen: Words['unseen'] = {
  'volume-empty': ({ value }) =>
    `Dieses Volumen ist leer: jedes Voxel hat den Wert ${number(value)}.`,
  'above-all-values': (reason) =>
    `Vom ${branch(reason)} ist nichts zu sehen: sein Isowert, ${number(reason.value)}, liegt über allen Werten, die bei ${number(reason.limit)} enden.`,
  'below-all-values': (reason) =>
    `Vom ${branch(reason)} ist nichts zu sehen: sein oberes Ende, ${number(reason.value)}, liegt unter allen Werten, die bei ${number(reason.limit)} beginnen.`,
  'fills-the-volume': (reason) =>
    `Das ganze Volumen ist ${branch(reason)}: der Isowert, ${number(reason.value)}, liegt unter allen Werten, die bei ${number(reason.limit)} beginnen.`,
  transparent: (reason) =>
    `Vom ${branch(reason)} ist nichts zu sehen: eine Deckkraft von ${number(reason.value)} pro Millimeter ist für ${number(reason.limit)} mm zu wenig.`,
  'lens-covered': () =>
    'Die Linse zeigt nichts: sie liegt im Material des Kontexts, das sie verdeckt.',
  'lens-empty': () => 'Die Linse zeigt nichts: in ihr ist nichts vom Fokus.',
};
