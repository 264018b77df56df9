// What the stand-in server knows of scenes: merging, and choosing what is left open.
import { modules, sceneDefault, withoutAliases } from './schemas.mjs';

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
    ...withoutAliases(kind, module),
  };
}

function branchLook(branch) {
  return {
    shading: whole('shading', branch?.shading ?? { name: 'tone' }),
    filters: (branch?.filters ?? []).map((filter) => whole('filter', filter)),
  };
}

const filled = (group, fields, said) =>
  Object.fromEntries(fields.map((field) => [field, said?.[field] ?? sceneDefault(group, field)]));

/** What makes a look, said whole. */
export function look({ focus, context, lens, light, background }) {
  return {
    focus: branchLook(focus),
    context: branchLook(context),
    lens: filled('lens', ['mode', 'cap', 'strength', 'softness', 'strict'], lens),
    light: filled('light', ['frame', 'direction'], light),
    background: filled('background', ['colour'], background),
  };
}

const surface = (said, iso_value) => ({
  iso_value,
  opacity: sceneDefault('surface', 'opacity'),
  ...said,
});

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
  const place = {
    shape: { name: 'sphere' },
    centre_mm: [18, -radius_mm[1] * 0.9, 22],
    radius_mm: 48,
  };
  const { focus, context, lens, light, background } = look(document);
  const middle = { centre_mm: [0, 0, 0] };
  const { slices } = document;
  return {
    version: 1,
    volume: volume.entry.id,
    viewport: { kind: '3d', ...viewport },
    camera: { ...front, ...document.camera },
    focus: { surface: surface(document.focus?.surface, 250), ...focus },
    context: { surface: surface(document.context?.surface, -200), ...context },
    lens: { ...place, ...document.lens, ...lens },
    light,
    background,
    slices: {
      ...filled('slices', ['superior', 'anterior', 'convention'], slices),
      crosshair_mm: [0, 0, 0],
      ...slices,
      window: { centre: 40, width: 400, ...slices?.window },
      axial: { ...middle, ...slices?.axial },
      coronal: { ...middle, ...slices?.coronal },
      sagittal: { ...middle, ...slices?.sagittal },
    },
  };
}
