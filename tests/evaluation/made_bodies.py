"""A body of known form, smooth and under noise: an ellipsoid with another one in it, written as
NRRD."""
from pathlib import Path

import numpy

VOXELS, SPACING_MM = 112, 2.0
POINT_SPREAD = 0.7  # standard deviation in voxels of the blur that a scanner has
CONTRAST = 1000.0  # of both edges
NOISE = 0.15  # standard deviation, of an edge's contrast
BODY_MM, BONE_MM, BONE_AT_MM = (78, 62, 92), (44, 34, 56), (0, -12, 0)
# The edges' middles; specks of noise are no part of the body, nor are its holes.
SURFACES = {
    "focus": {"surface": {"iso_value": 1.5 * CONTRAST}},
    "context": {"surface": {"iso_value": 0.5 * CONTRAST}},
    "preparation": {
        "hide_couch": False,
        "fill_context": False,
        "focus_islands_ml": 1,
        "context_islands_ml": 1,
    },
}
VIEW = {
    "camera": {"eye_mm": [0, -420, 0], "target_mm": [0, 0, 0], "up": [0, 0, 1]},
    "lens": {"centre_mm": [0, -62, 0], "radius_mm": 45},
}
SMOOTH, NOISY = "body-smooth.nrrd", "body-noisy.nrrd"


def write(folder):
    """Both into the folder; air is 0."""
    body = CONTRAST * (_inside(BODY_MM, (0, 0, 0)) + _inside(BONE_MM, BONE_AT_MM))
    noise = numpy.random.default_rng(1).normal(0, NOISE * CONTRAST, body.shape)
    _write_nrrd(Path(folder) / SMOOTH, body)
    _write_nrrd(Path(folder) / NOISY, body + noise)


def _inside(half_axes_mm, centre_mm):
    """1 inside, 0 outside, blurred at the edge; indices z, y, x."""
    axis = (numpy.arange(VOXELS) - (VOXELS - 1) / 2) * SPACING_MM
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    parts = [(p - c) / r for p, c, r in zip((x, y, z), centre_mm, half_axes_mm)]
    gauge = numpy.sqrt(sum(part**2 for part in parts))
    slope = numpy.sqrt(
        sum((part / r) ** 2 for part, r in zip(parts, half_axes_mm))
    ) / numpy.maximum(gauge, 1e-6)
    away_mm = (gauge - 1) / numpy.maximum(
        slope, 1e-6
    )  # to first order, which is what the blur's reach needs
    return 1 / (1 + numpy.exp(numpy.clip(1.702 * away_mm / (POINT_SPREAD * SPACING_MM), -50, 50)))


def _write_nrrd(path, values):
    first = -(VOXELS - 1) / 2 * SPACING_MM
    s = SPACING_MM
    head = (
        "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {VOXELS} {VOXELS} {VOXELS}\n"
        f"space directions: ({s},0,0) (0,{s},0) (0,0,{s})\n"
        f"space origin: ({first},{first},{first})\n"
        "endian: little\nencoding: raw\n\n"
    )
    path.write_bytes(head.encode() + numpy.rint(values).astype("<i2").tobytes())
