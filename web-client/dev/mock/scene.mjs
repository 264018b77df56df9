// What the stand-in server knows of scenes: merging, and choosing what is left open.
import { lookFields, modules, sceneDefault, withoutAliases } from './schemas.mjs';

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

const filled = (group, fields, said) =>
  Object.fromEntries(fields.map((field) => [field, said?.[field] ?? sceneDefault(group, field)]));

/** What of a group belongs to the look, said whole. */
const lookOf = (group, said) => filled(group, lookFields(group), said);

function branchLook(branch) {
  return {
    surface: lookOf('surface', branch?.surface),
    shading: whole('shading', branch?.shading ?? { name: 'tone' }),
    filters: (branch?.filters ?? []).map((filter) => whole('filter', filter)),
  };
}

/** What makes a look, said whole. */
export function look({ focus, context, lens, light, background }) {
  return {
    focus: branchLook(focus),
    context: branchLook(context),
    lens: lookOf('lens', lens),
    light: lookOf('light', light),
    background: lookOf('background', background),
  };
}

const branch = (look, said, iso_value) => ({
  ...look,
  surface: { iso_value, ...said?.surface, ...look.surface },
});

export function resolve(document, volume, viewport) {
  const radius_mm = volume.radii_mm;
  const front = {
    projection: sceneDefault('camera', 'projection'),
    eye_mm: [0, -620, 0],
    target_mm: [0, 0, 0],
    up: [0, 0, 1],
    vertical_fov_degrees: sceneDefault('camera', 'vertical_fov_degrees'),
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
    focus: branch(focus, document.focus, 250),
    context: branch(context, document.context, -200),
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
