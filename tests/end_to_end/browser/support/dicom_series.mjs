// A CT series in DICOM files, of a shape that a test knows exactly and acquired in any plane.
// Source: DICOM PS3.5 (explicit VR, little endian), PS3.3 C.7.6.2 (image plane).
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

const CT_IMAGE_STORAGE = '1.2.840.10008.5.1.4.1.1.2';
const EXPLICIT_LITTLE_ENDIAN = '1.2.840.10008.1.2.1';
const ROOT_UID = '1.2.826.0.1.3680043.10.1511';
const LONG_HEADED = ['OB', 'OW'];
const RESCALE_INTERCEPT = -1024;

function element(group, number, vr, content) {
  const bytes = Buffer.isBuffer(content) ? content : Buffer.from(content, 'latin1');
  const padding = bytes.length % 2 === 0 ? '' : vr === 'UI' ? '\0' : ' ';
  const value = Buffer.concat([bytes, Buffer.from(padding, 'latin1')]);
  const tag = Buffer.alloc(4);
  tag.writeUInt16LE(group, 0);
  tag.writeUInt16LE(number, 2);
  const length = Buffer.alloc(LONG_HEADED.includes(vr) ? 6 : 2);
  if (length.length === 6) length.writeUInt32LE(value.length, 2);
  else length.writeUInt16LE(value.length, 0);
  return Buffer.concat([tag, Buffer.from(vr, 'latin1'), length, value]);
}

const unsigned = (value) => {
  const bytes = Buffer.alloc(2);
  bytes.writeUInt16LE(value);
  return bytes;
};
const decimals = (numbers) => numbers.map((number) => number.toFixed(8)).join('\\');

function metaHeader(instance) {
  const elements = Buffer.concat([
    element(2, 0x01, 'OB', Buffer.from([0, 1])),
    element(2, 0x02, 'UI', CT_IMAGE_STORAGE),
    element(2, 0x03, 'UI', instance),
    element(2, 0x10, 'UI', EXPLICIT_LITTLE_ENDIAN),
    element(2, 0x12, 'UI', `${ROOT_UID}.1`),
  ]);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(elements.length);
  return Buffer.concat([
    Buffer.alloc(128),
    Buffer.from('DICM'),
    element(2, 0, 'UL', length),
    elements,
  ]);
}

const combined = (terms) =>
  [0, 1, 2].map((axis) => terms.reduce((sum, [factor, vector]) => sum + factor * vector[axis], 0));

/** Hounsfield units of one image, row by row. */
function pixels({ size, spacing_mm, axes }, position_mm, valueAt) {
  const [columns, rows] = size;
  const stored = Buffer.alloc(2 * columns * rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at_mm = combined([
        [1, position_mm],
        [column * spacing_mm[0], axes[0]],
        [row * spacing_mm[1], axes[1]],
      ]);
      const value = Math.round(valueAt(at_mm)) - RESCALE_INTERCEPT;
      stored.writeInt16LE(value, 2 * (row * columns + column));
    }
  }
  return stored;
}

function image(series, number, position_mm) {
  const instance = `${ROOT_UID}.${series.number}.${number + 1}`;
  const [columns, rows] = series.size;
  return Buffer.concat([
    metaHeader(instance),
    element(0x0008, 0x0016, 'UI', CT_IMAGE_STORAGE),
    element(0x0008, 0x0018, 'UI', instance),
    element(0x0008, 0x0060, 'CS', 'CT'),
    element(0x0008, 0x103e, 'LO', series.title),
    element(0x0018, 0x0050, 'DS', decimals([series.spacing_mm[2]])),
    element(0x0020, 0x000d, 'UI', `${ROOT_UID}.2`),
    element(0x0020, 0x000e, 'UI', `${ROOT_UID}.3.${series.number}`),
    element(0x0020, 0x0013, 'IS', String(number + 1)),
    element(0x0020, 0x0032, 'DS', decimals(position_mm)),
    element(0x0020, 0x0037, 'DS', decimals([...series.axes[0], ...series.axes[1]])),
    element(0x0020, 0x0052, 'UI', `${ROOT_UID}.4`),
    element(0x0028, 0x0002, 'US', unsigned(1)),
    element(0x0028, 0x0004, 'CS', 'MONOCHROME2'),
    element(0x0028, 0x0010, 'US', unsigned(rows)),
    element(0x0028, 0x0011, 'US', unsigned(columns)),
    element(0x0028, 0x0030, 'DS', decimals([series.spacing_mm[1], series.spacing_mm[0]])),
    element(0x0028, 0x0100, 'US', unsigned(16)),
    element(0x0028, 0x0101, 'US', unsigned(16)),
    element(0x0028, 0x0102, 'US', unsigned(15)),
    element(0x0028, 0x0103, 'US', unsigned(1)),
    element(0x0028, 0x1052, 'DS', decimals([RESCALE_INTERCEPT])),
    element(0x0028, 0x1053, 'DS', decimals([1])),
    element(0x7fe0, 0x0010, 'OW', pixels(series, position_mm, series.valueAt)),
  ]);
}

/**
 * Writes the series into a folder, centred on the patient's origin. `axes` are the directions of
 * columns, rows and images in the patient (LPS, unit, square to each other), `size` and
 * `spacing_mm` go along them; `valueAt` takes patient millimetres and gives Hounsfield units.
 * `number` tells series apart.
 */
export async function writeDicomSeries(folder, series) {
  const { size, spacing_mm, axes } = series;
  const first_mm = combined(
    axes.map((axis, index) => [(-(size[index] - 1) / 2) * spacing_mm[index], axis]),
  );
  await mkdir(folder, { recursive: true });
  for (let number = 0; number < size[2]; number++) {
    const position_mm = combined([
      [1, first_mm],
      [number * spacing_mm[2], axes[2]],
    ]);
    await writeFile(join(folder, `${number + 1}.dcm`), image(series, number, position_mm));
  }
}
