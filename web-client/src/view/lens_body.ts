// The lens as a body in the patient, from what the server says of its shape: the counterpart of
// server/scene/lenses/lens_body.h. A shape that the server adds needs nothing here.
import type { LensOutline, ModuleDescription, Scene } from '../protocol/messages.ts';
import { add, cross, dot, length, scale, subtract, type Vector3 } from './vector.ts';

type Lens = NonNullable<Scene['lens']>;

/** Patient space, mm. */
export interface LensBody {
  readonly centre_mm: Vector3;
  /** From the middle to the faces of the box that holds it: the body's own x, y, z. */
  readonly half_edges_mm: readonly [Vector3, Vector3, Vector3];
  readonly outline: LensOutline;
}

/** Degrees; which way the body points, in the patient. */
export interface LensDirection {
  readonly azimuth_degrees: number;
  readonly elevation_degrees: number;
}

const DEGREES = 180 / Math.PI;
const SUPERIOR: Vector3 = [0, 0, 1];

const weighed = (a: Vector3, b: Vector3, angle: number): Vector3 =>
  add(scale(a, Math.cos(angle)), scale(b, Math.sin(angle)));

/** Unit; the body's own axes: at rest left, up, and to the front. */
function bodyAxes(azimuth: number, elevation: number, roll: number): [Vector3, Vector3, Vector3] {
  const level: Vector3 = [Math.sin(azimuth), -Math.cos(azimuth), 0];
  const ahead = weighed(level, SUPERIOR, elevation);
  const upright = weighed(SUPERIOR, scale(level, -1), elevation);
  const aside = cross(upright, ahead);
  return [weighed(aside, upright, roll), weighed(upright, scale(aside, -1), roll), ahead];
}

export function lensDirection([x, y, z]: Vector3): LensDirection {
  return {
    azimuth_degrees: Math.atan2(x, -y) * DEGREES,
    elevation_degrees: Math.atan2(z, Math.hypot(x, y)) * DEGREES,
  };
}

/** Nothing while the scene leaves the lens open, or without one. */
export function lensBody(
  lens: Lens | undefined,
  shapes: readonly ModuleDescription[] | undefined,
): LensBody | undefined {
  const { centre_mm, radius_mm, mode } = lens ?? {};
  const said: Readonly<Record<string, unknown>> = { ...lens?.shape };
  const shape = shapes?.find(({ name }) => name === (said['name'] ?? shapes[0]?.name));
  if (!centre_mm || !radius_mm || mode === 'none' || !shape?.outline) return undefined;
  const number = (name: string | undefined, otherwise: number): number => {
    const value = name === undefined ? undefined : said[name];
    return typeof value === 'number' ? value : otherwise;
  };
  const angle = (name: string): number => number(name, 0) / DEGREES;
  const [x, y, z] = bodyAxes(
    angle('azimuth_degrees'),
    angle('elevation_degrees'),
    angle('roll_degrees'),
  );
  const half_mm = (axis: string): number =>
    radius_mm * number(shape.parameters.find((one) => one.axis === axis)?.name, 1);
  return {
    centre_mm,
    half_edges_mm: [scale(x, half_mm('x')), scale(y, half_mm('y')), scale(z, half_mm('z'))],
    outline: shape.outline,
  };
}

/** Whether it looks another way when it is turned. */
export const canTurn = (shape: ModuleDescription | undefined): boolean =>
  shape?.parameters.some(({ name }) => name === 'azimuth_degrees') ?? false;

/** How many times as large the lens has to be for the point to lie on its surface. */
export function gaugeOf({ centre_mm, half_edges_mm, outline }: LensBody, at_mm: Vector3): number {
  const off_mm = subtract(at_mm, centre_mm);
  const [x, y, z] = half_edges_mm.map((half_mm) => dot(off_mm, half_mm) / length(half_mm) ** 2);
  if (x === undefined || y === undefined || z === undefined) return 0;
  const from_axis = outline.round ? Math.hypot(x, y) : Math.max(Math.abs(x), Math.abs(y));
  return outline.profile.slice(1).reduce((most, [r1, z1], index) => {
    const [r0, z0] = outline.profile[index] ?? [r1, z1];
    // Outward normal of the section's side, which lies at `height` from the middle.
    const [out_r, out_z] = [z1 - z0, r0 - r1];
    const height = out_r * r0 + out_z * z0;
    return height > 0 ? Math.max(most, (out_r * from_axis + out_z * z) / height) : most;
  }, 0);
}
