// A group of the panel back to what the style that was put on last says of it; what that leaves open
// the server chooses.
import type { CapabilitiesMessage, Style } from '../protocol/messages.ts';
import { isObject, pick, type Json, type JsonObject } from './merge_patch.ts';
import { stylePatch } from './style_patch.ts';

export type PanelGroup = 'lens' | 'focus' | 'context' | 'light';

/** Field by field: a style may say one of them alone. */
const SURFACE = { iso_value: null, upper_value: null, opacity: null };

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
  focus: { surface: SURFACE, shading: null, filters: null },
  context: { surface: SURFACE, shading: null, filters: null },
  light: { frame: null, direction: null },
} as const;

/** Where no style was put on, the server's first one counts. */
export function groupReset(
  group: PanelGroup,
  { styles, modules }: Pick<CapabilitiesMessage, 'styles' | 'modules'>,
  base: Style | undefined,
): JsonObject {
  const style = base ?? styles[0];
  const look = style ? stylePatch(style, modules) : {};
  const fields = mergeSaid(LEFT_OPEN[group], look[group]);
  if (group !== 'light') return { [group]: fields };
  const background: Json = look['background'] ?? { colour: null };
  return { light: fields, background };
}

/** `said` on top of what is left open. */
function mergeSaid(open: JsonObject, said: Json | undefined): JsonObject {
  const fields = isObject(said) ? said : {};
  const surface = open['surface'];
  if (!isObject(surface)) return { ...open, ...fields };
  return {
    ...open,
    ...fields,
    surface: { ...surface, ...pick(fields['surface'], Object.keys(surface)) },
  };
}
