// Controls of single fields of the scene: the schema says their ranges, choices and defaults.
import { SCENE_FIELDS, type Scene } from '../protocol/messages.ts';
import type { FieldOfKind } from '../words/described_field.ts';
import { words } from '../words/words.ts';
import {
  choicesOf,
  roundStep,
  type BooleanControl,
  type ChoiceControl,
  type ColourControl,
  type ControlBase,
  type NumberControl,
} from './controls.ts';
import { nestedPatch, textOf, valueAt, type Json } from './merge_patch.ts';

/** As far as the schema says it. */
interface Facts {
  readonly description: string;
  readonly choices?: readonly string[];
  readonly minimum?: number;
  readonly maximum?: number;
  readonly step?: number;
  readonly unit?: string;
  readonly default?: unknown;
}

/** One field of the scene, at one of the places where the scene has it. */
interface Place<Kind extends string> {
  readonly field: FieldOfKind<Kind>;
  readonly path: readonly string[];
  readonly label: string;
}

const baseOf = <Kind extends string>({ field, path, label }: Place<Kind>): ControlBase => ({
  id: path.join('-').replaceAll('_', '-'),
  label,
  description: words().controls.description(field),
  toPatch: (value) => nestedPatch(path, value),
});

const said = (scene: Scene, path: readonly string[]): Json | undefined =>
  valueAt(scene as Json, path);

export function numberField(place: Place<'number'>, scene: Scene): NumberControl {
  const facts: Facts = SCENE_FIELDS[place.field];
  const { minimum = 0, maximum = 1, unit = '' } = facts;
  return {
    ...baseOf(place),
    kind: 'number',
    value: Number(said(scene, place.path) ?? facts.default ?? minimum),
    minimum,
    maximum,
    step: facts.step ?? roundStep(minimum, maximum),
    unit,
  };
}

/** The slider goes over what is of use; the rest of the range may be typed. */
export function withTravel(
  control: NumberControl,
  minimum: number,
  maximum: number,
): NumberControl {
  return { ...control, minimum, maximum, accepts: { minimum, maximum: control.maximum } };
}

export function booleanField(place: Place<'boolean'>, scene: Scene): BooleanControl {
  const facts: Facts = SCENE_FIELDS[place.field];
  const value = said(scene, place.path) ?? facts.default;
  return { ...baseOf(place), kind: 'boolean', value: value === true };
}

export function choiceField(place: Place<'choice'>, scene: Scene): ChoiceControl {
  const facts: Facts = SCENE_FIELDS[place.field];
  return {
    ...baseOf(place),
    kind: 'choice',
    value: textOf(said(scene, place.path) ?? (facts.default as Json)),
    choices: choicesOf(facts.choices ?? []),
  };
}

export function colourField(place: Place<'colour'>, scene: Scene): ColourControl {
  const facts: Facts = SCENE_FIELDS[place.field];
  const value = said(scene, place.path) ?? facts.default;
  return { ...baseOf(place), kind: 'colour', value: value as readonly number[] };
}
