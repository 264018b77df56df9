// A bar of a round length in the picture.

export interface ScaleBar {
  readonly length_mm: number;
  /** Of the page's pixels. */
  readonly width_css_px: number;
  /** Equal parts that the bar is marked in. */
  readonly parts: number;
}

/** How many parts are round as well. */
const STEPS = [
  { factor: 5, parts: 5 },
  { factor: 2, parts: 2 },
  { factor: 1, parts: 5 },
] as const;

/** The longest of 1, 2 and 5 times a power of ten that fits; nothing where no length is known. */
export function scaleBar(mm_per_css_px: number, longest_css_px: number): ScaleBar | undefined {
  const longest_mm = mm_per_css_px * longest_css_px;
  if (!(longest_mm > 0) || !Number.isFinite(longest_mm)) return undefined;
  const power = 10 ** Math.floor(Math.log10(longest_mm));
  const step = STEPS.find(({ factor }) => factor * power <= longest_mm) ?? STEPS[2];
  const length_mm = Number((step.factor * power).toPrecision(1));
  return { length_mm, width_css_px: length_mm / mm_per_css_px, parts: step.parts };
}

const MM_PER_CM = 10;
const MM_PER_MICROMETRE = 0.001;

/** '5 cm', '2 mm', '200 µm': a whole number of the largest unit. */
export function scaleText(length_mm: number): string {
  if (length_mm >= MM_PER_CM) return `${length_mm / MM_PER_CM} cm`;
  if (length_mm >= 1) return `${length_mm} mm`;
  return `${Number((length_mm / MM_PER_MICROMETRE).toPrecision(3))} µm`;
}
