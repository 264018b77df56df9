// A group of the panel back to what the style that was put on last says of it; what that leaves open
// the server chooses.
import type { CapabilitiesMessage, Style } from '../protocol/messages.ts';
import type { Json, JsonObject } from './merge_patch.ts';
import { stylePatch } from './style_patch.ts';

export type PanelGroup = 'lens' | 'focus' | 'context' | 'light';

/** What each group has, all of it left open. */
const LEFT_OPEN = {
  lens: {
    mode: null,
    shape: null,
    cap: null,
    strength: null,
    softness: null,
    strict: null,
    radius_mm: null,
    centre_mm: null,
  },
  focus: { surface: null, shading: null, filters: null },
  context: { surface: null, shading: null, filters: null },
  light: { frame: null, direction: null },
} as const;

/** `base` is the style's name; where it is none that the server has, the first one counts. */
export function groupReset(
  group: PanelGroup,
  { styles, modules }: Pick<CapabilitiesMessage, 'styles' | 'modules'>,
  base: string | undefined,
): JsonObject {
  const style: Style | undefined = styles.find(({ name }) => name === base) ?? styles[0];
  const look = style ? stylePatch(style, modules) : {};
  const fields = { ...LEFT_OPEN[group], ...(look[group] as JsonObject | undefined) };
  if (group !== 'light') return { [group]: fields };
  const background: Json = look['background'] ?? { colour: null };
  return { light: fields, background };
}
