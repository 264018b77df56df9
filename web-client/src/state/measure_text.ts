// Measured values in words of the page's language.
import { words } from '../words/words.ts';
import { sidedCoordinates } from '../view/orientation.ts';
import type { Vector3 } from '../view/vector.ts';
import type { MeasurementResult } from '../view/measurement.ts';

const DIGITS = 1;
const VALUE_DIGITS = 4;

/** Hounsfield values are whole numbers; others may be of any size. `units` are the volume's. */
export function valueText(value: number, units: string): string {
  if (units === 'HU') return `${words().number(value)} HU`;
  const digits = Math.max(0, VALUE_DIGITS - 1 - Math.floor(Math.log10(Math.abs(value) || 1)));
  const number = words().number(value, Math.min(VALUE_DIGITS, digits));
  return units === 'none' ? number : `${number} ${units}`;
}

const MICROMETRES_PER_MM = 1000;
const SMALLEST_IN_MM = 0.1;

/** '12.3 mm'; what a millimetre with one digit cannot say in micrometres. */
export function lengthText(length_mm: number): string {
  if (length_mm >= SMALLEST_IN_MM || length_mm === 0)
    return `${words().number(length_mm, DIGITS)} mm`;
  return `${words().number(length_mm * MICROMETRES_PER_MM, DIGITS)} µm`;
}

export function resultText({ value, unit }: MeasurementResult): string {
  if (unit === 'mm') return lengthText(value);
  if (unit === 'degrees') return `${words().number(value, DIGITS)}°`;
  return valueText(value, unit);
}

/** 'L 12.3'; what rounds to nothing is on neither side. `distance_mm` >= 0. */
export function sidedText(letters: string, distance_mm: number): string {
  const text = words().number(distance_mm, DIGITS);
  return text === words().number(0, DIGITS) ? text : `${letters} ${text}`;
}

/** 'L 12.3 · P 40.1 · S 8.8 mm' */
export function positionText(position_mm: Vector3): string {
  const parts = sidedCoordinates(position_mm).map(({ letter, distance_mm }) =>
    sidedText(letter, distance_mm),
  );
  return `${parts.join(' · ')} mm`;
}
