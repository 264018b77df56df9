// Pictures of two nested ellipsoids with a lens: enough to see rotation, pan, zoom, lens and style
// at work.
import { deflateSync } from 'node:zlib';

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const scale = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const unit = (a) => scale(a, 1 / Math.hypot(...a));

/** Distances at which a ray enters and leaves an ellipsoid. */
function crossings(origin, direction, ball) {
  const from = subtract(origin, ball.centre).map((part, axis) => part / ball.radii[axis]);
  const along = direction.map((part, axis) => part / ball.radii[axis]);
  const a = dot(along, along);
  const b = dot(from, along);
  const root = b * b - a * (dot(from, from) - 1);
  if (root < 0) return undefined;
  return [(-b - Math.sqrt(root)) / a, (-b + Math.sqrt(root)) / a];
}

/** First point on any of the shapes outside of the hole. */
function firstHit(ray, shapes, hole) {
  let nearest;
  for (const shape of shapes) {
    const through = crossings(ray.origin, ray.direction, shape);
    if (!through) continue;
    let distance = through[0];
    if (hole && distance > hole[0] && distance < hole[1])
      distance = hole[1] < through[1] ? undefined : Infinity;
    if (distance === undefined || distance <= 0 || distance >= (nearest?.distance ?? Infinity))
      continue;
    nearest = { distance, shape };
  }
  return nearest && { ...nearest, point: add(ray.origin, scale(ray.direction, nearest.distance)) };
}

function normalAt({ point, shape }) {
  return unit(subtract(point, shape.centre).map((part, axis) => part / shape.radii[axis] ** 2));
}

function shadeColour(shading, lambert) {
  if (shading.name === 'phong')
    return shading.colour.map(
      (part) => part * (shading.ambient + shading.diffuse * Math.max(0, lambert)),
    );
  if (shading.name === 'gooch') {
    const { colour, blue, yellow, alpha, beta } = shading;
    const cool = add(scale(colour, alpha), [0, 0, blue]);
    const warm = add(scale(colour, beta), [yellow, yellow, 0]);
    return add(scale(cool, (1 - lambert) / 2), scale(warm, (1 + lambert) / 2));
  }
  const step = lambert > shading.terminator ? 1 : 0;
  const share = (shading.detail * (lambert + 1)) / 2 + (1 - shading.detail) * step;
  return shading.dark.map((part, index) => part + (shading.light[index] - part) * share);
}

export function cameraAxes({ eye_mm, target_mm, up }) {
  const backward = unit(subtract(eye_mm, target_mm));
  const right = unit(cross(up, backward));
  return { right, up: cross(backward, right), backward };
}

export function rayAt(camera, axes, x, y) {
  if (camera.projection === 'orthographic') {
    const half = camera.view_height_mm / 2;
    const origin = add(camera.eye_mm, add(scale(axes.right, x * half), scale(axes.up, y * half)));
    return { origin, direction: scale(axes.backward, -1) };
  }
  const half = Math.tan((camera.vertical_fov_degrees * Math.PI) / 360);
  const aim = add(
    add(scale(axes.right, x * half), scale(axes.up, y * half)),
    scale(axes.backward, -1),
  );
  return { origin: camera.eye_mm, direction: unit(aim) };
}

export function surfaceUnder(scene, volume, position_px) {
  const { width_px, height_px } = scene.viewport;
  const x = (2 * position_px[0] - width_px) / height_px;
  const y = 1 - (2 * position_px[1]) / height_px;
  const axes = cameraAxes(scene.camera);
  return firstHit(rayAt(scene.camera, axes, x, y), volume.skin)?.point;
}

/** Of one branch alone, or the background's. */
function branchColour(scene, hit, shading, light) {
  if (!hit || hit.distance === Infinity) return scene.background.colour;
  return shadeColour(shading, dot(normalAt(hit), light));
}

function lensHole({ lens }, ray) {
  const ball = { centre: lens.centre_mm, radii: Array(3).fill(Math.max(lens.radius_mm, 1e-3)) };
  return lens.mode === 'none' ? undefined : crossings(ray.origin, ray.direction, ball);
}

function pixelColour(scene, volume, axes, light, x, y) {
  const ray = rayAt(scene.camera, axes, x, y);
  const hole = lensHole(scene, ray);
  return scene.lens.mode === 'magic'
    ? magicColour(scene, volume, light, ray, hole)
    : cutawayColour(scene, volume, light, ray, hole);
}

/** The whole focus over the context, as far as the lens reaches. */
function magicColour(scene, volume, light, ray, hole) {
  const context = branchColour(scene, firstHit(ray, volume.skin), scene.context.shading, light);
  const bone = hole && firstHit(ray, volume.bone);
  if (!bone) return context;
  const focus = branchColour(scene, bone, scene.focus.shading, light);
  const { strength } = scene.lens;
  return add(scale(context, 1 - strength), scale(focus, strength));
}

function cutawayColour(scene, volume, light, ray, hole) {
  const context = firstHit(ray, volume.skin, hole);
  const focus = hole && firstHit(ray, volume.bone);
  const inLens =
    focus && focus.distance < (context?.distance ?? Infinity) && context?.distance !== Infinity;
  return inLens
    ? branchColour(scene, focus, scene.focus.shading, light)
    : branchColour(scene, context, scene.context.shading, light);
}

export function drawScene(scene, volume, width, height) {
  const axes = cameraAxes(scene.camera);
  const [right, up, towards] = scene.light.direction;
  const light = unit(
    add(add(scale(axes.right, right), scale(axes.up, up)), scale(axes.backward, towards)),
  );
  return drawPixels(width, height, (x, y) => pixelColour(scene, volume, axes, light, x, y));
}

const inside = (point, ball) =>
  subtract(point, ball.centre).reduce(
    (sum, part, axis) => sum + (part / ball.radii[axis]) ** 2,
    0,
  ) < 1;

/** Hounsfield units of the shapes: air, soft tissue, bone. */
export function valueAt(volume, point) {
  if (volume.bone.some((ball) => inside(point, ball))) return 700;
  return volume.skin.some((ball) => inside(point, ball)) ? 40 : -1000;
}

/** A slice, seen along its normal: `plane` as of slice.mjs. */
export function drawSlice(scene, volume, plane, width, height) {
  const { centre, width: range } = scene.slices.window;
  return drawPixels(width, height, (x, y) => {
    const value = valueAt(volume, pointOf(plane, x / 2, y / 2));
    return Array(3).fill((value - centre) / range + 0.5);
  });
}

/** `x` and `y` from the middle, in heights of the picture; up is positive. */
export const pointOf = ({ centre, right, up, height_mm }, x, y) =>
  add(centre, add(scale(right, x * height_mm), scale(up, y * height_mm)));

/** `colourAt` takes places from the middle in half heights of the picture. */
function drawPixels(width, height, colourAt) {
  const pixels = Buffer.alloc((width * 3 + 1) * height);
  let offset = 0;
  for (let row = 0; row < height; row++) {
    offset += 1;
    for (let column = 0; column < width; column++) {
      const colour = colourAt((2 * column + 1 - width) / height, 1 - (2 * row + 1) / height);
      for (const part of colour)
        pixels[offset++] = Math.round(Math.min(1, Math.max(0, part)) * 255);
    }
  }
  return encodePng(pixels, width, height);
}

const crcTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  return crc;
});

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  let crc = 0xffffffff;
  for (const byte of body) crc = crcTable[(crc ^ byte) & 255] ^ (crc >>> 8);
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(data.length, 0);
  frame.writeUInt32BE((crc ^ 0xffffffff) >>> 0, 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

function encodePng(scanlines, width, height) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
  const data = deflateSync(scanlines, { level: 1 });
  return Buffer.concat([
    signature,
    chunk('IHDR', header),
    chunk('IDAT', data),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}
