// A style's own colours, for the drawing that stands in until the server has rendered its picture.
import type { ModuleRegistries, Scene, Style } from '../protocol/messages.ts';
import { toHex } from './colour.ts';
import { isObject, type Json, type JsonObject } from './merge_patch.ts';

export interface Tones {
  readonly dark: string;
  readonly light: string;
  /** A step between the two, as against a ramp. */
  readonly flat: boolean;
}

export interface Swatch {
  readonly background: string;
  readonly context: Tones;
  readonly focus: Tones;
  /** The focus' share in the lens, 0 without one. */
  readonly focus_share: number;
}

type Colour = readonly number[];

const GREY: Colour = [0.5, 0.5, 0.5];
const SHADOW = 0.35;
const FLAT_DETAIL = 0.2;

/** The module with its parameters' defaults for what it leaves out. */
function withDefaults(module: JsonObject, registry: ModuleRegistries['shading']): JsonObject {
  const description = registry.find(({ name }) => name === module['name']);
  const parameters = description?.parameters ?? [];
  const defaults: [string, Json][] = parameters.map((one) => [one.name, one.default]);
  return { ...Object.fromEntries(defaults), ...module };
}

const colourOf = (value: Json | undefined): Colour =>
  Array.isArray(value) ? (value as Colour) : GREY;
const numberOf = (value: Json | undefined): number => (typeof value === 'number' ? value : 0);

/** Gooch's two ends: blue, and yellow, each with a share of the surface's colour. */
function goochTones(module: JsonObject): Tones {
  const [blue, yellow, alpha, beta] = ['blue', 'yellow', 'alpha', 'beta'].map((name) =>
    numberOf(module[name]),
  ) as [number, number, number, number];
  const mixed = (tint: Colour, share: number): string =>
    toHex(colourOf(module['colour']).map((part, index) => part * share + (tint[index] ?? 0)));
  return { dark: mixed([0, 0, blue], alpha), light: mixed([yellow, yellow, 0], beta), flat: false };
}

function tonesOf(branch: Scene['focus'], registry: ModuleRegistries['shading']): Tones {
  const shading = branch?.shading as Json | undefined;
  const module = withDefaults(isObject(shading) ? shading : {}, registry);
  if (module['name'] === 'gooch') return goochTones(module);
  if (module['name'] === 'tone') {
    const [dark, light] = [toHex(colourOf(module['dark'])), toHex(colourOf(module['light']))];
    return { dark, light, flat: numberOf(module['detail']) < FLAT_DETAIL };
  }
  const colour = colourOf(module['colour']);
  return { dark: toHex(colour.map((part) => part * SHADOW)), light: toHex(colour), flat: false };
}

const FOCUS_SHARES = { none: 0, cutaway: 1 } as const;

export function swatchOf({ scene }: Style, { shading }: ModuleRegistries): Swatch {
  const { mode = 'cutaway', strength = 1 } = scene.lens ?? {};
  return {
    background: toHex(scene.background?.colour ?? [0, 0, 0]),
    context: tonesOf(scene.context, shading),
    focus: tonesOf(scene.focus, shading),
    focus_share: mode === 'magic' ? strength : FOCUS_SHARES[mode],
  };
}
