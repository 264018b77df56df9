// Where the ends of a band lie on the histogram, and what keys and pointer make of them.
import type { NumberControl } from './controls.ts';
import type { BandModel } from './surface_controls.ts';

const LARGE_STEPS = 10;
const PAGES = 20;

/** 0..1 over the range. */
export function shareOf({ value, minimum, maximum }: NumberControl): number {
  if (maximum <= minimum) return 0;
  return Math.min(1, Math.max(0, (value - minimum) / (maximum - minimum)));
}

const within = (value: number, { minimum, maximum }: NumberControl): number =>
  Math.min(maximum, Math.max(minimum, value));

/** Rounded to the control's step; the ends of the range are what they are. */
export function valueAtShare(control: NumberControl, share: number): number {
  const { minimum, maximum, step } = control;
  if (share <= 0 || share >= 1) return share <= 0 ? minimum : maximum;
  const value = minimum + share * (maximum - minimum);
  return within(Number((Math.round(value / step) * step).toPrecision(12)), control);
}

/** The end that a press at a share of the range takes: the nearer one, and between two equal ones
 * that on the side of the press. */
export function nearestEnd({ lower, upper }: BandModel, share: number): NumberControl {
  if (!upper) return lower;
  const [to_lower, to_upper] = [lower, upper].map((end) => Math.abs(share - shareOf(end)));
  if (to_lower === to_upper) return share > shareOf(upper) ? upper : lower;
  return (to_lower ?? 0) < (to_upper ?? 0) ? lower : upper;
}

/** As a slider's keys do; nothing for any other key. Shift makes ten steps of one. */
export function steppedValue(
  control: NumberControl,
  key: string,
  large: boolean,
): number | undefined {
  const { value, minimum, maximum, step } = control;
  const one = large ? step * LARGE_STEPS : step;
  const page = Math.max(step, (maximum - minimum) / PAGES);
  const values: Readonly<Record<string, number>> = {
    ArrowLeft: value - one,
    ArrowDown: value - one,
    ArrowRight: value + one,
    ArrowUp: value + one,
    PageDown: value - page,
    PageUp: value + page,
    Home: minimum,
    End: maximum,
  };
  const wanted = values[key];
  return wanted === undefined
    ? undefined
    : valueAtShare(control, (wanted - minimum) / Math.max(Number.EPSILON, maximum - minimum));
}
