// How a slice lies in the patient; protocol/README.md, "Views".
import { pointOf } from './picture.mjs';

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scale = (a, factor) => a.map((part) => part * factor);
const subtract = (a, b) => a.map((part, axis) => part - b[axis]);
const add = (a, b) => a.map((part, axis) => part + b[axis]);
const unit = (a) => scale(a, 1 / Math.hypot(...a));
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

const NAMES = ['3d', 'axial', 'coronal', 'sagittal'];

function axesOf({ superior, anterior, convention }, name) {
  const s = unit(superior);
  const a = unit(subtract(anterior, scale(s, dot(anterior, s))));
  const left = cross(s, a);
  const side = scale(left, convention === 'neurological' ? -1 : 1);
  return {
    axial: { right: side, up: a, normal: s },
    coronal: { right: side, up: s, normal: a },
    sagittal: { right: scale(a, -1), up: s, normal: left },
  }[name];
}

export function planeOf({ slices }, { entry }, view, viewport) {
  const name = NAMES[view];
  const { right, up, normal } = axesOf(slices, name);
  const { centre_mm, view_height_mm } = slices[name];
  const half = (axis) =>
    entry.size_voxels.reduce(
      (sum, voxels, index) => sum + (Math.abs(axis[index]) * voxels * entry.spacing_mm[index]) / 2,
      0,
    );
  const aspect = viewport.height_px / viewport.width_px;
  const whole_mm = 2 * 1.02 * Math.max(half(up), half(right) * aspect);
  const to_plane = dot(subtract(slices.crosshair_mm, centre_mm), normal);
  return {
    right,
    up,
    centre: add(centre_mm, scale(normal, to_plane)),
    height_mm: view_height_mm ?? whole_mm,
  };
}

export function pointUnder(plane, viewport, [x, y]) {
  const { width_px, height_px } = viewport;
  return pointOf(plane, (x - width_px / 2) / height_px, (height_px / 2 - y) / height_px);
}
