// How large an exported picture is. Sizes keep the shape of the view unless the user gives both
// sides, and no side is longer than the server makes them.
import type { Viewport } from '../view/camera.ts';

/** The longer sides of an A4 and an A3 sheet at 300 dots per inch, and the shorter ones. */
const PRINT_DOTS_PER_INCH = 300;
const A4_PX = [3508, 2480] as const;
const A3_PX = [4961, 3508] as const;

export interface SizePreset {
  readonly id: 'view' | 'double' | 'hd' | 'full_hd' | '4k' | '8k' | 'a4' | 'a3';
  readonly size: Viewport;
  /** Where it is meant for paper. */
  readonly dots_per_inch?: number;
}

const scaled = ({ width_px, height_px }: Viewport, factor: number): Viewport => ({
  width_px: Math.max(1, Math.round(width_px * factor)),
  height_px: Math.max(1, Math.round(height_px * factor)),
});

/** The largest of the view's shape in a box that may be turned to fit. */
function within(view: Viewport, [longer_px, shorter_px]: readonly [number, number]): Viewport {
  const longer = Math.max(view.width_px, view.height_px);
  const shorter = Math.min(view.width_px, view.height_px);
  return scaled(view, Math.min(longer_px / longer, shorter_px / shorter));
}

const withinSide = (view: Viewport, side_px: number): Viewport => within(view, [side_px, side_px]);

export const fits = ({ width_px, height_px }: Viewport, limit_px: number): boolean =>
  width_px <= limit_px && height_px <= limit_px;

/** Those that the server makes, for a picture of `view`. */
export function picturePresets(view: Viewport, limit_px: number): readonly SizePreset[] {
  const presets: readonly SizePreset[] = [
    { id: 'view', size: view },
    { id: 'double', size: scaled(view, 2) },
    { id: '4k', size: withinSide(view, 3840) },
    { id: '8k', size: withinSide(view, 7680) },
    { id: 'a4', size: within(view, A4_PX), dots_per_inch: PRINT_DOTS_PER_INCH },
    { id: 'a3', size: within(view, A3_PX), dots_per_inch: PRINT_DOTS_PER_INCH },
  ];
  return presets.filter(({ size }) => fits(size, limit_px));
}

/** Video has even sides: its colours are kept for two by two pixels. */
export const even = ({ width_px, height_px }: Viewport): Viewport => ({
  width_px: Math.max(2, 2 * Math.round(width_px / 2)),
  height_px: Math.max(2, 2 * Math.round(height_px / 2)),
});

export function filmPresets(view: Viewport, limit_px: number): readonly SizePreset[] {
  const presets: readonly SizePreset[] = [
    { id: 'hd', size: within(view, [1280, 720]) },
    { id: 'full_hd', size: within(view, [1920, 1080]) },
    { id: 'view', size: view },
    { id: '4k', size: within(view, [3840, 2160]) },
  ];
  return presets
    .map((preset) => ({ ...preset, size: even(preset.size) }))
    .filter(({ size }) => fits(size, limit_px));
}

/** One side as given, the other by the view's shape where that is kept; both within the limit. */
export function withSide(
  size: Viewport,
  side: 'width_px' | 'height_px',
  value_px: number,
  keeps: Viewport | undefined,
  limit_px: number,
): Viewport {
  const clamp = (px: number): number => Math.min(limit_px, Math.max(1, Math.round(px)));
  if (!keeps) return { ...size, [side]: clamp(value_px) };
  const wanted = scaled(keeps, clamp(value_px) / keeps[side]);
  return fits(wanted, limit_px)
    ? { ...wanted, [side]: clamp(value_px) }
    : withinSide(keeps, limit_px);
}

/** What the user has chosen. */
export interface SizeWish {
  readonly preset: SizePreset['id'] | 'own';
  readonly own: Viewport;
  /** The other side follows where one is given. */
  readonly keeps_shape: boolean;
}

/** The first preset where the one that was chosen is not there any more. */
export function chosenSize(
  { preset, own }: SizeWish,
  presets: readonly SizePreset[],
): Pick<SizePreset, 'size' | 'dots_per_inch'> {
  if (preset === 'own') return { size: own };
  return presets.find(({ id }) => id === preset) ?? presets[0] ?? { size: own };
}
