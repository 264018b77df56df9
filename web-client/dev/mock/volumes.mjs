// Stand-ins for volumes: shapes in patient millimetres. The left ear, the nose and the jaw tell the
// directions.
const ball = (centre, radii) => ({ centre, radii });

const head = {
  entry: {
    id: 'phantom:head',
    title: 'Head phantom',
    format: 'phantom',
    modality: 'CT',
    size_voxels: [256, 256, 256],
    spacing_mm: [0.9, 0.9, 0.9],
    warnings: [],
  },
  radii_mm: [76, 96, 112],
  skin: [
    ball([0, 0, 0], [76, 96, 112]),
    ball([0, -98, -8], [12, 18, 20]),
    ball([78, 6, -6], [9, 18, 28]),
    ball([-77, 6, -6], [6, 14, 20]),
    ball([0, -30, -96], [46, 56, 40]),
  ],
  bone: [ball([0, 6, 16], [64, 82, 84]), ball([0, -36, -72], [38, 44, 34])],
};

const knees = {
  entry: {
    id: 'phantom:knees',
    title: 'Knees phantom',
    format: 'phantom',
    modality: 'CT',
    size_voxels: [256, 256, 256],
    spacing_mm: [1.2, 1.2, 1.2],
    warnings: ['No spacing is given: 1.2 mm is assumed.'],
  },
  radii_mm: [130, 70, 150],
  skin: [ball([70, 0, 0], [58, 66, 150]), ball([-70, 0, 0], [52, 60, 150])],
  bone: [
    ball([70, -6, 76], [22, 24, 80]),
    ball([70, 0, -80], [20, 22, 76]),
    ball([-70, -6, 76], [22, 24, 80]),
    ball([-70, 0, -80], [20, 22, 76]),
  ],
};

export const volumes = [head, knees];

export const refused = [
  {
    path: 'series/broken.nii.gz',
    reason: 'The header announces 512×512×300 voxels, but the file ends after 112 slices.',
  },
];

export function summary({ entry, radii_mm }) {
  const histogram = Array.from({ length: 128 }, (_, bin) =>
    Math.round(
      4e5 * Math.exp(-(((bin - 4) / 3) ** 2)) +
        9e4 * Math.exp(-(((bin - 34) / 4) ** 2)) +
        7e3 * Math.exp(-(((bin - 60) / 22) ** 2)),
    ),
  );
  return {
    id: entry.id,
    title: entry.title,
    modality: entry.modality,
    units: 'HU',
    size_voxels: entry.size_voxels,
    spacing_mm: entry.spacing_mm,
    origin_mm: entry.size_voxels.map(
      (voxels, axis) => -((voxels - 1) / 2) * entry.spacing_mm[axis],
    ),
    axes: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    bounds_minimum_mm: radii_mm.map((radius) => -radius),
    bounds_maximum_mm: radii_mm,
    diagonal_mm: 2 * Math.hypot(...radii_mm),
    value_range: [-1024, 3071],
    outer_iso_value: -200,
    inner_iso_value: 250,
    histogram,
    warnings: entry.warnings,
  };
}
