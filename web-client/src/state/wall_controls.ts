// Controls of the wall of the cavity that a cutaway's lens makes.
import type { Scene } from '../protocol/messages.ts';
import { words } from '../words/words.ts';
import type { ColourControl, Control, NumberControl } from './controls.ts';
import { colourField, numberField, withTravel } from './field_controls.ts';
import type { ControlLevels } from './module_model.ts';

/** A wider one is no edge any more. */
const WIDEST_EDGE_MM = 10;

const at = (name: string): string[] => ['lens', 'wall', name];

function wallNumber(name: 'strength' | 'deepening' | 'edge_mm', scene: Scene): NumberControl {
  const label = words().controls.wall[name];
  return numberField({ field: `wall.${name}`, path: at(name), label }, scene);
}

function wallColour(name: 'colour' | 'edge_colour', scene: Scene): ColourControl {
  const label = words().controls.wall[name];
  return colourField({ field: `wall.${name}`, path: at(name), label }, scene);
}

/** An open surface has no face along which there could be one. */
function edgeControls(scene: Scene): readonly Control[] {
  if (scene.lens?.cap === 'open') return [];
  const width = withTravel(wallNumber('edge_mm', scene), 0, WIDEST_EDGE_MM);
  return width.value > 0 ? [width, wallColour('edge_colour', scene)] : [width];
}

/** What does nothing now is left out. */
export function wallControls(scene: Scene): ControlLevels {
  const strength = wallNumber('strength', scene);
  return {
    ramp: undefined,
    basic: strength.value > 0 ? [strength, wallColour('colour', scene)] : [strength],
    advanced: [wallNumber('deepening', scene), ...edgeControls(scene)],
  };
}
