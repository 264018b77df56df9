// How a slice lies in the patient (LPS, mm) and in its picture (px): the counterpart of
// server/scene/slice_geometry.h.
import type { Scene, VolumeSummary } from '../protocol/messages.ts';
import type { Point, Viewport } from './camera.ts';
import { add, cross, dot, normalize, scale, subtract, type Vector3 } from './vector.ts';
import type { ViewProjection } from './view_projection.ts';

export const SLICE_NAMES = ['axial', 'coronal', 'sagittal'] as const;
export type SliceName = (typeof SLICE_NAMES)[number];

export type Slices = NonNullable<Scene['slices']>;

/** Two of the planes' normals; left open they are the patient's own. */
export interface Directions {
  readonly superior?: Vector3;
  readonly anterior?: Vector3;
}

/** The three planes' normals, orthonormal, in patient space; left = superior x anterior. */
export interface SliceFrame {
  readonly superior: Vector3;
  readonly anterior: Vector3;
  readonly left: Vector3;
}

const SUPERIOR: Vector3 = [0, 0, 1];
const ANTERIOR: Vector3 = [0, -1, 0];

export function sliceFrame({ superior, anterior }: Directions): SliceFrame {
  const s = normalize(superior ?? SUPERIOR);
  const said = anterior ?? ANTERIOR;
  const a = normalize(subtract(said, scale(s, dot(said, s))));
  return { superior: s, anterior: a, left: cross(s, a) };
}

/** Of each slice the normal along which it is scrolled. */
export function sliceNormal(slices: Slices, name: SliceName): Vector3 {
  const { superior, anterior, left } = sliceFrame(slices);
  return { axial: superior, coronal: anterior, sagittal: left }[name];
}

/** What a slice's picture shows of its plane, whatever the picture's size. */
export interface SlicePlane {
  /** Unit vectors in patient space; the picture's right and up, and the plane's normal. */
  readonly right: Vector3;
  readonly up: Vector3;
  readonly normal: Vector3;
  /** In the middle of the picture, on the plane. */
  readonly centre_mm: Vector3;
  /** What the picture's height spans; nothing where it is the whole volume. */
  readonly view_height_mm: number | undefined;
}

/** Nothing while the scene leaves the plane open. */
export function slicePlane(slices: Slices | undefined, name: SliceName): SlicePlane | undefined {
  const { centre_mm, view_height_mm } = slices?.[name] ?? {};
  if (!slices?.crosshair_mm || !centre_mm) return undefined;
  const { superior, anterior, left } = sliceFrame(slices);
  const normal = sliceNormal(slices, name);
  const side = scale(left, slices.convention === 'neurological' ? -1 : 1);
  const axes = {
    axial: { right: side, up: anterior },
    coronal: { right: side, up: superior },
    sagittal: { right: scale(anterior, -1), up: superior },
  }[name];
  const to_plane_mm = dot(subtract(slices.crosshair_mm, centre_mm), normal);
  return { ...axes, normal, centre_mm: add(centre_mm, scale(normal, to_plane_mm)), view_height_mm };
}

/** What a slice's picture says of the planes by its axes. */
export type ShownPlanes = Required<Directions> & Pick<Slices, 'convention'>;

/** The inverse of slicePlane. Sagittal slices are the same in either convention, and leave it open. */
export function shownPlanes({ right, up, normal }: SlicePlane, name: SliceName): ShownPlanes {
  if (name === 'sagittal') return { superior: up, anterior: scale(right, -1) };
  const [superior, anterior] = name === 'axial' ? [normal, up] : [up, normal];
  const to_left = dot(right, cross(superior, anterior)) > 0;
  return { superior, anterior, convention: to_left ? 'radiological' : 'neurological' };
}

type Grid = Pick<VolumeSummary, 'size_voxels' | 'spacing_mm' | 'origin_mm' | 'axes'>;

/** How far the grid's voxels reach from its middle along a direction, and their centres, mm. */
function halfExtentsMm({ size_voxels, spacing_mm, axes }: Grid, direction: Vector3) {
  const reach = (voxels_less: number): number =>
    axes.reduce((sum, axis, index) => {
      const voxels = (size_voxels[index] ?? 0) - voxels_less;
      return sum + Math.abs(dot(axis, direction)) * voxels * (spacing_mm[index] ?? 0) * 0.5;
    }, 0);
  return { edges_mm: reach(0), centres_mm: reach(1) };
}

/** Cosine of an angle that leaves a slice by less than a voxel in a thousand. */
const ALONG_AXIS = 1 - 5e-7;

/** Where the voxels' centres begin and end along a normal: mm from the patient's origin. */
export function extentAlong(grid: Grid, normal: Vector3): { minimum: number; maximum: number } {
  const { size_voxels, spacing_mm, origin_mm, axes } = grid;
  const middle_mm = axes.reduce<Vector3>((point_mm, axis, index) => {
    const half_mm = 0.5 * ((size_voxels[index] ?? 1) - 1) * (spacing_mm[index] ?? 0);
    return add(point_mm, scale(axis, half_mm));
  }, origin_mm);
  const middle = dot(middle_mm, normal);
  const { centres_mm } = halfExtentsMm(grid, normal);
  return { minimum: middle - centres_mm, maximum: middle + centres_mm };
}

/** Whether planes across this unit normal are the grid's own slices. */
export const runsAlongAxis = ({ axes }: Grid, normal: Vector3): boolean =>
  axes.some((axis) => Math.abs(dot(axis, normal)) > ALONG_AXIS);

/** From one slice to the next along a unit normal: the spacing, where an axis runs along it, mm. */
export function voxelStepMm({ axes, spacing_mm }: Grid, normal: Vector3): number {
  return Math.hypot(...axes.map((axis, index) => dot(axis, normal) * (spacing_mm[index] ?? 0)));
}

/** Of the volume's size, so that its edge is seen to be one. */
const FRAMING_MARGIN = 1.02;

/** What the picture's height spans, mm. */
export function viewHeightMm(plane: SlicePlane, grid: Grid, viewport: Viewport): number {
  if (plane.view_height_mm !== undefined) return plane.view_height_mm;
  const aspect = viewport.height_px / viewport.width_px;
  const half_mm = Math.max(
    halfExtentsMm(grid, plane.up).edges_mm,
    halfExtentsMm(grid, plane.right).edges_mm * aspect,
  );
  return 2 * FRAMING_MARGIN * half_mm;
}

/** A slice's picture: patient positions are projected onto it along its normal. */
export interface SliceProjection extends ViewProjection {
  readonly plane: SlicePlane;
  readonly mm_per_pixel: number;
  readonly toPicture: (position_mm: Vector3) => Point;
  /** The point of the plane under a point of the picture. */
  readonly toPatient: (position_px: Point) => Vector3;
  /** Of a patient point from the plane along its normal, mm. */
  readonly distanceMm: (position_mm: Vector3) => number;
}

export function sliceProjection(
  plane: SlicePlane,
  grid: Grid,
  viewport: Viewport,
): SliceProjection {
  const { right, up, normal, centre_mm } = plane;
  const mm_per_pixel = viewHeightMm(plane, grid, viewport) / viewport.height_px;
  const [x_px, y_px] = [viewport.width_px / 2, viewport.height_px / 2];
  const toPicture = (position_mm: Vector3): Point => {
    const offset_mm = subtract(position_mm, centre_mm);
    return [x_px + dot(offset_mm, right) / mm_per_pixel, y_px - dot(offset_mm, up) / mm_per_pixel];
  };
  return {
    plane,
    viewport,
    mm_per_pixel,
    toPicture,
    toPatient: ([x, y]) =>
      add(
        centre_mm,
        add(scale(right, (x - x_px) * mm_per_pixel), scale(up, (y_px - y) * mm_per_pixel)),
      ),
    distanceMm: (position_mm) => dot(subtract(position_mm, centre_mm), normal),
    lineToPicture: (from_mm, to_mm) => [toPicture(from_mm), toPicture(to_mm)],
    pixelSizeMm: () => mm_per_pixel,
    scale_at_mm: centre_mm,
    foreshortens: false,
  };
}
