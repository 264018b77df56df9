// What the stand-in server knows of scenes: merging, and choosing what is left open.
import { modules } from './schemas.mjs';

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

export function mergePatch(base, patch) {
  const merged = { ...base };
  for (const [key, value] of Object.entries(patch)) {
    const old = merged[key];
    const otherModule =
      isObject(value) && isObject(old) && 'name' in value && value.name !== old.name;
    if (value === null) delete merged[key];
    else if (isObject(value))
      merged[key] = mergePatch(isObject(old) && !otherModule ? old : {}, value);
    else merged[key] = value;
  }
  return merged;
}

function whole(kind, module) {
  const { parameters } = modules[kind].find(({ name }) => name === module.name);
  return {
    ...Object.fromEntries(parameters.map((parameter) => [parameter.name, parameter.default])),
    ...module,
  };
}

function branch(document, defaults) {
  return {
    surface: { iso_value: document?.surface?.iso_value ?? defaults.iso_value },
    shading: whole('shading', document?.shading ?? { name: 'tone' }),
    filters: (document?.filters ?? [{ name: defaults.filter }]).map((filter) =>
      whole('filter', filter),
    ),
  };
}

export function resolve(document, volume, viewport) {
  const radius_mm = volume.radii_mm;
  const front = {
    projection: 'perspective',
    eye_mm: [0, -620, 0],
    target_mm: [0, 0, 0],
    up: [0, 0, 1],
    vertical_fov_degrees: 30,
    view_height_mm: 330,
  };
  const lens = {
    mode: 'cutaway',
    shape: { name: 'sphere' },
    centre_mm: [18, -radius_mm[1] * 0.9, 22],
    radius_mm: 48,
    cap: 'flat',
  };
  return {
    version: 1,
    volume: volume.entry.id,
    viewport: { kind: '3d', ...viewport },
    camera: { ...front, ...document.camera },
    focus: branch(document.focus, { iso_value: 250, filter: 'sobel' }),
    context: branch(document.context, { iso_value: -200, filter: 'kuwahara' }),
    lens: { ...lens, ...document.lens },
    light: { frame: 'camera', direction: [-0.5, 0.7, 0.5], ...document.light },
    background: { colour: [0.04, 0.05, 0.06], ...document.background },
  };
}
