// Keys of the export: its dialog, and a recording of the view.
import type { Exporting } from '../session/exporting.ts';
import type { ViewName } from '../state/views.ts';
import { isPlainKey, type KeyBinding } from './key_binding.ts';

const plainKey =
  (name: string, action: (exporting: Exporting, view: ViewName) => void): KeyBinding['apply'] =>
  (event, { exporting }, { view }) => {
    if (!isPlainKey(event, name)) return false;
    action(exporting, view);
    return true;
  };

export const EXPORT_KEYS: readonly KeyBinding[] = [
  { keys: 'e', meaning: 'export', group: 'page', apply: plainKey('e', (e, view) => e.open(view)) },
  {
    keys: 'Shift + E',
    meaning: 'record',
    group: 'page',
    apply: plainKey('E', ({ recorder }) => recorder.toggle()),
  },
];
