// Named styles: putting one on, and telling which one a scene wears.
import type { ModuleDescription, ModuleRegistries, Scene, Style } from '../protocol/messages.ts';
import { isObject, nestedPatch, valueAt, type Json, type JsonObject } from './merge_patch.ts';

const SAME_NUMBER = 1e-6;

/** Whether everything that `part` says is so in `whole`. */
function says(whole: Json | undefined, part: Json): boolean {
  if (isObject(part))
    return Object.entries(part).every(([key, value]) =>
      says(isObject(whole) ? whole[key] : undefined, value),
    );
  if (Array.isArray(part)) {
    const [there, wanted] = [whole as readonly Json[], part as readonly Json[]];
    return (
      Array.isArray(whole) &&
      there.length === wanted.length &&
      wanted.every((item, index) => says(there[index], item))
    );
  }
  if (typeof part === 'number')
    return typeof whole === 'number' && Math.abs(whole - part) < SAME_NUMBER;
  return whole === part;
}

export function matchingStyle(
  scene: Scene | undefined,
  styles: readonly Style[],
): Style | undefined {
  if (!scene) return undefined;
  return styles.find(({ scene: look }) => {
    const { version: _version, ...fields } = look;
    return says(scene as Json, fields as Json);
  });
}

/** A module that says all of its parameters: what it leaves out goes back to its default. */
function wholeModule(module: JsonObject, registry: readonly ModuleDescription[]): JsonObject {
  const parameters = registry.find(({ name }) => name === module['name'])?.parameters ?? [];
  const names = parameters.flatMap(({ name, relative }) => [name, relative?.name ?? name]);
  return { ...Object.fromEntries(names.map((name) => [name, null])), ...module };
}

/** The change that puts a style on, whatever was changed before. */
export function stylePatch(style: Style, modules: ModuleRegistries): JsonObject {
  const { version: _version, volume: _volume, ...fields } = style.scene;
  let patch = fields as JsonObject;
  for (const branch of ['focus', 'context']) {
    const shading = valueAt(patch, [branch, 'shading']);
    if (!isObject(shading)) continue;
    const whole = nestedPatch(['shading'], wholeModule(shading, modules.shading));
    patch = { ...patch, [branch]: { ...(patch[branch] as JsonObject), ...whole } };
  }
  return patch;
}
