// Keys of the layout, and what links the slices with the volume: the same in every picture.
import { WINDOW_PRESET_NAMES } from '../state/value_window.ts';
import { isPlainKey, type KeyBinding } from './key_binding.ts';

const preset: KeyBinding['apply'] = (event, { slicing }) => {
  const name = isPlainKey(event, event.key) && WINDOW_PRESET_NAMES[Number(event.key) - 1];
  if (name) slicing.usePreset(name);
  return Boolean(name);
};

export const VIEW_KEYS: readonly KeyBinding[] = [
  {
    keys: 'g',
    meaning: 'next_layout',
    group: 'views',
    apply: (event, { layout }) => {
      if (!isPlainKey(event, 'g')) return false;
      layout.next();
      return true;
    },
  },
  {
    keys: 'z',
    meaning: 'enlarge',
    group: 'views',
    apply: (event, { layout }, { view }) => {
      if (!isPlainKey(event, 'z')) return false;
      layout.enlarge(view);
      return true;
    },
  },
  {
    keys: 'l',
    meaning: 'lens_at_crosshair',
    group: 'views',
    apply: (event, { slicing }) => {
      if (!isPlainKey(event, 'l')) return false;
      slicing.toggleLensAtCrosshair();
      return true;
    },
  },
  { keys: '1 – 5', meaning: 'window_presets', group: 'views', apply: preset },
];
