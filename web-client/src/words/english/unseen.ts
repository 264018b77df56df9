// Why the picture shows nothing.
import type { UnseenReason } from '../../protocol/messages.ts';
import { valueIn } from '../plural.ts';

const number = valueIn('en');
const branch = (reason: UnseenReason): string =>
  reason.branch === 'focus' ? 'the focus' : 'the context';

type InWords = (reason: UnseenReason) => string;

export const unseen: Readonly<Record<UnseenReason['code'], InWords>> = {
  'volume-empty': ({ value }) =>
    `This volume is empty: every voxel has the value ${number(value)}.`,
  'above-all-values': (reason) =>
    `Nothing of ${branch(reason)} can be seen: its iso-value, ${number(reason.value)}, is above all values, which end at ${number(reason.limit)}.`,
  'below-all-values': (reason) =>
    `Nothing of ${branch(reason)} can be seen: its upper end, ${number(reason.value)}, is below all values, which begin at ${number(reason.limit)}.`,
  'fills-the-volume': (reason) =>
    `All of the volume is ${branch(reason)}: the iso-value, ${number(reason.value)}, is below all values, which begin at ${number(reason.limit)}.`,
  transparent: (reason) =>
    `Nothing of ${branch(reason)} can be seen: an opacity of ${number(reason.value)} per millimetre is too little for ${number(reason.limit)} mm.`,
  'lens-covered': () =>
    'The lens shows nothing: it lies inside of the context’s material, which covers it.',
  'lens-empty': () => 'The lens shows nothing: there is nothing of the focus in it.',
};
