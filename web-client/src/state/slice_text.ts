// Where a slice lies and what its window is, in words of the page's language.
import type { VolumeSummary } from '../protocol/messages.ts';
import { directionLetters } from '../view/orientation.ts';
import type { SlicePlane } from '../view/slice_geometry.ts';
import { dot, scale, type Vector3 } from '../view/vector.ts';
import { words } from '../words/words.ts';
import { sidedText, valueText } from './measure_text.ts';
import type { ValueWindow } from './value_window.ts';

/** 'S 34.5 mm': the patient's direction along the normal, and how far from the origin. */
export function offsetText(normal: Vector3, offset_mm: number): string {
  const direction = offset_mm < 0 ? scale(normal, -1) : normal;
  return `${sidedText(directionLetters(direction), Math.abs(offset_mm))} mm`;
}

export const planeOffsetText = ({ normal, centre_mm }: SlicePlane): string =>
  offsetText(normal, dot(centre_mm, normal));

/** 'W 400 · C 40' */
export function windowText({ centre, width }: ValueWindow, units: VolumeSummary['units']): string {
  const text = (value: number): string =>
    valueText(value, units === 'HU' ? units : 'none').replace(/ HU$/, '');
  return words().slices.window(text(width), text(centre));
}
