// The colours between a shading's dark and light one, in the order that light goes over them: what
// server/render/shaders/shade_tone.glsl makes of them.
import { toHex } from './colour.ts';
import type { ColourControl, Control, NumberControl } from './controls.ts';

export interface ToneRamp {
  readonly dark: ColourControl;
  readonly light: ColourControl;
  /** From two flat tones to the whole ramp; nothing where the module always draws all of it. */
  readonly detail: NumberControl | undefined;
}

/** Of a module with the parameters `dark` and `light`; nothing for others. */
export function toneRamp(
  controlNamed: (parameter: string) => Control | undefined,
): ToneRamp | undefined {
  const [dark, light, detail] = ['dark', 'light', 'detail'].map(controlNamed);
  if (dark?.kind !== 'colour' || light?.kind !== 'colour') return undefined;
  return { dark, light, detail: detail?.kind === 'number' ? detail : undefined };
}

const mixed = (from: readonly number[], to: readonly number[], share: number): string =>
  toHex(from.map((part, index) => part + ((to[index] ?? part) - part) * share));

/** As CSS, dark to light. Colours mix as they are displayed, here as in the shader. */
export function rampGradient({ dark, light, detail }: ToneRamp): string {
  const piece = (detail?.value ?? 1) / 2;
  const at = (share: number): string => mixed(dark.value, light.value, share);
  return `linear-gradient(to right, ${at(0)}, ${at(piece)} 50%, ${at(1 - piece)} 50%, ${at(1)})`;
}
