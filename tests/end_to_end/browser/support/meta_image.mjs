// A volume in a file, of a shape that a test knows exactly.

const HEADER_OF = {
  ObjectType: 'Image',
  NDims: 3,
  BinaryData: 'True',
  BinaryDataByteOrderMSB: 'False',
  CompressedData: 'False',
  ElementType: 'MET_SHORT',
  Modality: 'MET_MOD_CT',
};

/** Centred on the patient's origin; `valueAt` takes patient millimetres (LPS), gives Hounsfield units. */
export function metaImage({ size, spacing_mm, valueAt }) {
  const offset_mm = size.map((voxels, axis) => (-(voxels - 1) / 2) * spacing_mm[axis]);
  const fields = {
    ...HEADER_OF,
    DimSize: size.join(' '),
    ElementSpacing: spacing_mm.join(' '),
    Offset: offset_mm.join(' '),
    ElementDataFile: 'LOCAL',
  };
  const header = Object.entries(fields).map(([name, value]) => `${name} = ${value}\n`);
  const [width, height, depth] = size;
  const voxels = Buffer.alloc(2 * width * height * depth);
  for (let index = 0; index < width * height * depth; index++) {
    const place = [index % width, Math.floor(index / width) % height];
    place.push(Math.floor(index / (width * height)));
    const at_mm = place.map((step, axis) => offset_mm[axis] + step * spacing_mm[axis]);
    voxels.writeInt16LE(Math.round(valueAt(at_mm)), 2 * index);
  }
  return Buffer.concat([Buffer.from(header.join('')), voxels]);
}
