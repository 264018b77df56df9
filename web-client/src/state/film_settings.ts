// What the user wants of a film, and the controls for it.
import { frameCount } from '../film/film.ts';
import type { FilmFormat } from '../film/film_file.ts';
import type { Turntable } from '../film/turntable.ts';
import { words } from '../words/words.ts';
import type { ChoiceControl, NumberControl } from './controls.ts';

export interface FilmSettings extends Turntable {
  readonly motion: 'turntable' | 'path';
  readonly frames_per_second: number;
  /** The first that can be written where this one cannot. */
  readonly format: FilmFormat;
}

export const FIRST_FILM: FilmSettings = {
  motion: 'turntable',
  axis: 'superior',
  direction: 'right',
  degrees: 360,
  seconds: 8,
  frames_per_second: 25,
  format: 'mp4',
};

const FRAMES_PER_SECOND = [10, 24, 25, 30, 50, 60];
const LONGEST_SECONDS = 60;

type Names = Readonly<Record<string, string>>;

function choice(
  key: keyof FilmSettings,
  label: string,
  settings: FilmSettings,
  names: Names,
): ChoiceControl {
  return {
    kind: 'choice',
    id: `film-${key}`,
    label,
    description: '',
    value: String(settings[key]),
    choices: Object.entries(names).map(([value, title]) => ({ value, label: title })),
    toPatch: (value) => ({ [key]: value }),
  };
}

function number(
  key: 'degrees' | 'seconds',
  label: string,
  settings: FilmSettings,
  range: Pick<NumberControl, 'minimum' | 'maximum' | 'step' | 'unit'>,
): NumberControl {
  const base = { kind: 'number', id: `film-${key}`, label, description: '' } as const;
  return { ...base, ...range, value: settings[key], toPatch: (value) => ({ [key]: value }) };
}

export function motionControl(settings: FilmSettings): ChoiceControl {
  const { motion, motions } = words().export;
  return choice('motion', motion, settings, motions);
}

export function turntableControls(settings: FilmSettings): (ChoiceControl | NumberControl)[] {
  const { axis, axes, direction, directions, angle, seconds } = words().export;
  const turn = { minimum: 5, maximum: 720, step: 5, unit: '°' };
  const length = { minimum: 1, maximum: LONGEST_SECONDS, step: 0.5, unit: 's' };
  return [
    choice('axis', axis, settings, axes),
    choice('direction', direction, settings, directions),
    number('degrees', angle, settings, turn),
    number('seconds', seconds, settings, length),
  ];
}

export function speedControl(settings: FilmSettings): ChoiceControl {
  const names = Object.fromEntries(FRAMES_PER_SECOND.map((one) => [String(one), String(one)]));
  const control = choice('frames_per_second', words().export.frames_per_second, settings, names);
  return { ...control, toPatch: (value) => ({ frames_per_second: Number(value) }) };
}

export const formatControl = (
  settings: FilmSettings,
  chosen: FilmFormat | undefined,
  names: Names,
): ChoiceControl => ({
  ...choice('format', words().export.format, settings, names),
  value: chosen ?? '',
});

/** `path_ms` is the length of what was recorded. */
export function filmFacts(settings: FilmSettings, path_ms: number | undefined): string {
  const seconds = settings.motion === 'path' ? (path_ms ?? 0) / 1000 : settings.seconds;
  return words().export.film_facts(frameCount(seconds, settings.frames_per_second), seconds);
}
