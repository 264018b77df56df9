// The panel's controls, made from what the server says it can do. A control knows its range and the
// change of the scene that a new value means; a component only draws it.
import type { ParameterDescription } from '../protocol/messages.ts';
import { textOf, type Json, type JsonObject } from './merge_patch.ts';
import { words } from '../words/words.ts';

export interface ControlBase {
  readonly id: string;
  readonly label: string;
  readonly description: string;
  readonly toPatch: (value: Json) => JsonObject;
}

export interface NumberControl extends ControlBase {
  readonly kind: 'number';
  readonly value: number;
  /** The slider's travel. */
  readonly minimum: number;
  readonly maximum: number;
  /** What may be typed; left out, no more than the slider's travel. */
  readonly accepts?: { readonly minimum: number; readonly maximum: number };
  readonly step: number;
  readonly unit: string;
}

export interface Choice {
  readonly value: string;
  readonly label: string;
}

export interface ChoiceControl extends ControlBase {
  readonly kind: 'choice';
  readonly value: string;
  readonly choices: readonly Choice[];
}

export interface BooleanControl extends ControlBase {
  readonly kind: 'boolean';
  readonly value: boolean;
}

export interface ColourControl extends ControlBase {
  readonly kind: 'colour';
  /** Display-encoded sRGB, 0..1. */
  readonly value: readonly number[];
}

export type Control = NumberControl | ChoiceControl | BooleanControl | ColourControl;

/** 'half_vector' and 'half-vector' read 'Half vector'. */
export function readable(name: string): string {
  const words = name.replaceAll(/[_-]+/g, ' ').trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** About two hundred places over the range, on a round number. */
export function roundStep(minimum: number, maximum: number): number {
  const step = 10 ** Math.floor(Math.log10(Math.max(maximum - minimum, Number.EPSILON) / 200));
  return Number(step.toPrecision(1));
}

function numberControl(
  base: ControlBase,
  parameter: ParameterDescription,
  value: Json,
): NumberControl {
  const minimum = parameter.minimum ?? 0;
  const maximum = parameter.maximum ?? 1;
  const step = parameter.step ?? (parameter.type === 'integer' ? 1 : roundStep(minimum, maximum));
  return {
    ...base,
    kind: 'number',
    value: Number(value),
    minimum,
    maximum,
    step,
    unit: parameter.unit ?? '',
  };
}

export const choicesOf = (values: readonly string[]): Choice[] =>
  values.map((value) => ({ value, label: words().served.choices[value] ?? readable(value) }));

/**
 * `module` is the module's part of the scene; what it does not say shows the parameter's default.
 */
export function parameterControl(
  parameter: ParameterDescription,
  module: JsonObject,
  toPatch: (value: Json) => JsonObject,
  id: string,
): Control {
  const base = {
    id: `${id}-${parameter.name}`,
    label: parameter.title,
    description: parameter.description,
    toPatch,
  };
  const value = module[parameter.name] ?? parameter.default;
  switch (parameter.type) {
    case 'number':
    case 'integer':
      return numberControl(base, parameter, value);
    case 'boolean':
      return { ...base, kind: 'boolean', value: value === true };
    case 'choice':
      return {
        ...base,
        kind: 'choice',
        value: textOf(value),
        choices: choicesOf(parameter.choices ?? []),
      };
    case 'colour':
      return { ...base, kind: 'colour', value: value as readonly number[] };
  }
}
