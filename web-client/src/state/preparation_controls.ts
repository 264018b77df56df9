// What the volume goes through before it is drawn, as switches.
import type { Scene } from '../protocol/messages.ts';
import { words } from '../words/words.ts';
import type { BooleanControl, Control } from './controls.ts';
import { nestedPatch } from './merge_patch.ts';

function preparationControl(name: 'hide_couch' | 'fill_context', scene: Scene): BooleanControl {
  return {
    kind: 'boolean',
    id: name.replace('_', '-'),
    label: words().controls[name],
    description: words().controls.description(`preparation.${name}`),
    value: scene.preparation?.[name] ?? false,
    toPatch: (value) => nestedPatch(['preparation', name], value),
  };
}

/** Of the context's section. */
export const preparationControls = (scene: Scene): readonly Control[] => [
  preparationControl('hide_couch', scene),
  preparationControl('fill_context', scene),
];
