// Measurements as files for other programs: JSON that says its space and units, and CSV with a row
// for each measurement. Numbers have a decimal point in every language.
import type { VolumeSummary } from '../protocol/messages.ts';
import { resultOf, type Measurement, type MeasurementResult } from '../view/measurement.ts';
import type { MeasurementList } from './measurement_list.ts';

type Measured = Pick<VolumeSummary, 'id' | 'title' | 'modality' | 'units'>;

const FORMAT = 'cutaway-measurements';
const VERSION = 1;
/** A micrometre, and a thousandth of a unit or a degree. */
const DIGITS = 3;

const rounded = (value: number): number => Number(value.toFixed(DIGITS));

const RESULT_NAMES = {
  distance: 'length_mm',
  angle: 'angle_degrees',
  probe: 'value',
} as const;

function measurementJson(one: Measurement, { units }: Measured) {
  const result = resultOf(one, units);
  return {
    name: one.name,
    kind: one.kind,
    ...(result && { [RESULT_NAMES[one.kind]]: rounded(result.value) }),
    points: one.points.map(({ position_mm, value }) => ({
      position_mm: position_mm.map(rounded),
      value: rounded(value),
    })),
  };
}

/** `notice` says what the numbers are not for. */
export function measurementsJson(list: MeasurementList, volume: Measured, notice: string): string {
  const { id, title, modality, units } = volume;
  const document = {
    format: FORMAT,
    version: VERSION,
    notice,
    volume: { id, title, modality },
    space: 'patient LPS: x to the left, y to posterior, z to superior',
    position_unit: 'mm',
    value_unit: units,
    measurements: list.map((one) => measurementJson(one, volume)),
  };
  return `${JSON.stringify(document, null, 2)}\n`;
}

const POINTS = [1, 2, 3] as const;

const COLUMNS = [
  ...['name', 'kind', 'result', 'unit'],
  ...POINTS.flatMap((point) =>
    ['left_mm', 'posterior_mm', 'superior_mm', 'value'].map((what) => `point${point}_${what}`),
  ),
  ...['value_unit', 'volume', 'notice'],
];

/** Text that a spreadsheet would take for a formula begins with an apostrophe. */
function field(content: string | number): string {
  const text = String(content);
  const safe = typeof content === 'string' && /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

const resultFields = (result: MeasurementResult | undefined): (string | number)[] =>
  result ? [rounded(result.value), result.unit] : ['', ''];

function row(one: Measurement, volume: Measured, notice: string): string {
  const points = POINTS.flatMap((number): readonly (string | number)[] => {
    const point = one.points[number - 1];
    return point ? [...point.position_mm, point.value].map(rounded) : ['', '', '', ''];
  });
  const result = resultFields(resultOf(one, volume.units));
  const fields = [one.name, one.kind, ...result, ...points, volume.units, volume.title, notice];
  return fields.map(field).join(',');
}

/** RFC 4180, with the mark of UTF-8 that spreadsheets look for. */
export function measurementsCsv(list: MeasurementList, volume: Measured, notice: string): string {
  const rows = list.map((one) => row(one, volume, notice));
  return `\uFEFF${[COLUMNS.join(','), ...rows].map((line) => `${line}\r\n`).join('')}`;
}
