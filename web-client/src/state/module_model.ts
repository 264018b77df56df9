// Controls of the modules that a scene is made of, from the registries in `capabilities`.
import type { ModuleDescription, ParameterDescription, Scene } from '../protocol/messages.ts';
import { parameterControl, type ChoiceControl, type Control } from './controls.ts';
import { toneRamp, type ToneRamp } from './tone_ramp.ts';
import {
  isObject,
  nestedPatch,
  textOf,
  valueAt,
  type Json,
  type JsonObject,
} from './merge_patch.ts';

export interface ControlLevels {
  /** The two colours of a module that has a dark and a light one; they are no controls below. */
  readonly ramp: ToneRamp | undefined;
  readonly basic: readonly Control[];
  readonly advanced: readonly Control[];
}

export const NO_CONTROLS: ControlLevels = { ramp: undefined, basic: [], advanced: [] };

/** A length in the unit in which the module says it: pixels, or relative to the picture's height. */
function asSaid(parameter: ParameterDescription, module: JsonObject): ParameterDescription {
  const { relative } = parameter;
  return relative && relative.name in module
    ? { ...parameter, ...relative, type: 'number' }
    : parameter;
}

export function controlLevels(
  description: ModuleDescription,
  module: JsonObject,
  toPatch: (parameter: string, value: Json) => JsonObject,
  id: string,
): ControlLevels {
  const controlOf = (described: ParameterDescription): Control => {
    const parameter = asSaid(described, module);
    return parameterControl(parameter, module, (value) => toPatch(parameter.name, value), id);
  };
  const ramp = toneRamp((name) => {
    const parameter = description.parameters.find((one) => one.name === name);
    return parameter && controlOf(parameter);
  });
  const in_ramp = [ramp?.dark.id, ramp?.light.id];
  const level = (wanted: ParameterDescription['level']): Control[] =>
    description.parameters
      .filter((one) => one.level === wanted)
      .map(controlOf)
      .filter(({ id: control }) => !in_ramp.includes(control));
  return { ramp, basic: level('basic'), advanced: level('advanced') };
}

const moduleAt = (scene: Scene, path: readonly string[]): JsonObject => {
  const module = valueAt(scene as Json, path);
  return isObject(module) ? module : {};
};

export interface ModuleModel {
  readonly choice: ChoiceControl;
  readonly description: string;
  readonly controls: ControlLevels;
}

/**
 * A place in the scene that takes one module of a registry: a branch's shading, the lens' shape.
 */
export function moduleModel(
  label: string,
  path: readonly string[],
  registry: readonly ModuleDescription[],
  scene: Scene,
): ModuleModel {
  const module = moduleAt(scene, path);
  const name = textOf(module['name'], registry[0]?.name);
  const description = registry.find((entry) => entry.name === name);
  const id = path.join('-');
  const choices = registry.map((entry) => ({ value: entry.name, label: entry.title }));
  const toPatch = (value: Json): JsonObject => nestedPatch([...path, 'name'], value);
  return {
    choice: {
      kind: 'choice',
      id: `${id}-name`,
      label,
      description: '',
      value: name,
      choices,
      toPatch,
    },
    description: description?.description ?? '',
    controls: description
      ? controlLevels(
          description,
          module,
          (parameter, value) => nestedPatch([...path, parameter], value),
          id,
        )
      : NO_CONTROLS,
  };
}
