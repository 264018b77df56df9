// Keys of the export: its dialog, and a recording of the view.
import type { Exporting } from '../session/exporting.ts';
import type { KeyBinding } from './key_binding.ts';

const plainKey =
  (name: string, action: (exporting: Exporting) => void): KeyBinding['apply'] =>
  (event, { exporting }) => {
    if (event.key !== name || event.ctrlKey || event.metaKey || event.altKey) return false;
    action(exporting);
    return true;
  };

export const EXPORT_KEYS: readonly KeyBinding[] = [
  { keys: 'e', meaning: 'export', group: 'page', apply: plainKey('e', (e) => e.show(true)) },
  {
    keys: 'Shift + E',
    meaning: 'record',
    group: 'page',
    apply: plainKey('E', ({ recorder }) => recorder.toggle()),
  },
];
