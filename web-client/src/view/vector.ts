// Three-component vectors as plain tuples, so that they are JSON as they stand.

export type Vector3 = readonly [number, number, number];

export const add = (a: Vector3, b: Vector3): Vector3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector3, b: Vector3): Vector3 => [
  a[0] - b[0],
  a[1] - b[1],
  a[2] - b[2],
];
export const scale = (a: Vector3, factor: number): Vector3 => [
  a[0] * factor,
  a[1] * factor,
  a[2] * factor,
];
/** From `a` at share 0 to `b` at share 1, on the straight line. */
export const mix = (a: Vector3, b: Vector3, share: number): Vector3 =>
  add(a, scale(subtract(b, a), share));
export const dot = (a: Vector3, b: Vector3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vector3): number => Math.hypot(a[0], a[1], a[2]);

export const cross = (a: Vector3, b: Vector3): Vector3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function normalize(a: Vector3): Vector3 {
  return scale(a, 1 / length(a));
}

/**
 * `a` turned by `angle_radians` about the unit `axis`, counter-clockwise seen from its tip
 * (Rodrigues).
 */
export function rotateAbout(a: Vector3, axis: Vector3, angle_radians: number): Vector3 {
  const cosine = Math.cos(angle_radians);
  const along = scale(axis, dot(axis, a) * (1 - cosine));
  return add(add(scale(a, cosine), scale(cross(axis, a), Math.sin(angle_radians))), along);
}
