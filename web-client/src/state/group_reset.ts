// A group of the panel back to what the style that was put on last says of it; what that leaves open
// the server chooses.
import type { CapabilitiesMessage, Style } from '../protocol/messages.ts';
import { layered, pick, type JsonObject } from './merge_patch.ts';
import { fieldsUnder, leftOpen } from './scene_fields.ts';
import { stylePatch } from './style_patch.ts';

export type PanelGroup = 'lens' | 'focus' | 'context' | 'light';

/** The parts of the scene that a group shows. */
const PARTS: Readonly<Record<PanelGroup, readonly string[]>> = {
  lens: ['lens'],
  focus: ['focus'],
  context: ['context'],
  light: ['light', 'background'],
};

/** What the volume goes through is shown where it is seen. */
const preparedFor = (group: PanelGroup) =>
  fieldsUnder('preparation').filter(([, name]) => {
    const shown_in = name === 'focus_islands_ml' ? 'focus' : 'context';
    return shown_in === group;
  });

/** Where no style was put on, the server's first one counts. */
export function groupReset(
  group: PanelGroup,
  { styles, modules }: Pick<CapabilitiesMessage, 'styles' | 'modules'>,
  base: Style | undefined,
): JsonObject {
  const style = base ?? styles[0];
  const look = style ? stylePatch(style, modules) : {};
  const parts = PARTS[group];
  return layered(
    leftOpen([...parts.flatMap(fieldsUnder), ...preparedFor(group)]),
    pick(look, parts),
  );
}
