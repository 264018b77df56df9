"""The kinds of volumes whose first pictures are looked at; each is written into a folder."""
import gzip

import numpy

from made_volumes import (
    AIR, BONE, HEAD_PARTS, MUSCLE, Grid, couch, head, knees, noisy, put, soft, torso, vessels,
    write_nifti, write_nrrd,
)

TORSO = ((112, 76, 80), 4.0)
HEAD = ((84, 112, 110), 2.0)
T1 = (4, 300, 60, 90, 220, 290, 80)
T2 = (4, 180, 40, 420, 230, 170, 430)
FLAIR = (4, 200, 40, 50, 240, 190, 45)
CT_HEAD = (AIR, 20, 1000, 10, 38, 30, 8)


def ct(path, size=TORSO, turned=None, change=None, **parts):
    """A torso in HU as an NRRD, after `change(volume, grid)`."""
    grid = Grid(*size)
    v = soft(torso(grid, **parts))
    if change:
        v = change(v, grid)
    write_nrrd(path, grid, noisy(v, 12), turned=turned)


def mr_head(path, values, bias=0.0, sigma=8.0):
    grid = Grid(*HEAD)
    v = soft(head(grid, values)) * (1 + bias * grid.y / 100 + bias * grid.x / 200)
    write_nifti(path, grid, numpy.abs(noisy(v, sigma)))


def head_on_rest(path):
    grid = Grid((100, 128, 110), 2.0)
    v = head(grid, CT_HEAD)
    ring = grid.radius((0, 5, 0), (105, 113, None))
    put(v, (ring > 0.96) & (ring < 1) & (grid.y > 20) & (v < -500), 200.0)
    write_nrrd(path, grid, noisy(soft(v), 10))


def oblique_plate(path):
    """A plate of tissue, 24 mm thick, on edge through the corner of a cube of air."""
    grid = Grid((96, 96, 96), 2.0)
    across = (grid.x + grid.y + 0.6 * grid.z) / numpy.sqrt(2.36)
    v = grid.full(AIR)
    ball = grid.radius((0, 0, 0), (85, 85, 85)) < 1
    put(v, (abs(across) < 12) & ball, MUSCLE)
    put(v, (abs(across) < 7) & (grid.radius((0, 0, 0), (40, 40, 40)) < 1), BONE)
    write_nrrd(path, grid, noisy(soft(v), 10))


def signed_map(path, background=0.0):
    grid = Grid((64, 76, 64), 2.5)
    brain = grid.radius((0, 0, 0), (65, 82, 62)) < 1
    v = noisy(grid.full(0), 1.0)
    v = soft(v, 1.5) * 4 * numpy.where(brain, 1.0, background)
    for sign, middle in ((7, (-30, -20, 20)), (6, (35, 30, 0)), (-6, (20, -40, 25))):
        v += sign * numpy.exp(-3 * grid.radius(middle, (16, 16, 16)) ** 2)
    write_nifti(path, grid, v * (brain if background == 0 else 1), "f4")


def mask(path, size_mm=22.0, middle=(40, -30, 25)):
    grid = Grid((96, 80, 70), 2.0)
    write_nifti(path, grid, grid.radius(middle, (size_mm, 0.7 * size_mm, size_mm)) < 1, "u1")


def labels(path):
    grid = Grid((84, 60, 60), 4.0)
    v = torso(grid)
    names = numpy.searchsorted([-900.0, -500.0, -50.0, 47.0, 55.0, 500.0], v)
    write_nifti(path, grid, names, "u1")


def unit_float(path, blood=45.0):
    grid = Grid(*TORSO)
    v = noisy(soft(torso(grid, blood=blood)), 12)
    write_nrrd(path, grid, numpy.clip((v + 1000) / 2000, 0, 1), "f4")


def noise(path):
    grid = Grid((64, 64, 64), 1.0)
    write_nrrd(path, grid, noisy(grid.full(100), 30))


def pet(path, spacing_mm=4.0):
    grid = Grid((84, 60, 80), spacing_mm)
    v = 0.8 * (grid.radius((0, 0, 0), (150, 95, None)) < 1)
    hot = (((0, -10, 90), (45, 40, 40), 5), ((-50, 0, -40), (60, 50, 35), 1.6),
           ((25, -30, 20), (14, 14, 14), 9), ((-55, 45, -70), (16, 14, 26), 4),
           ((0, -60, -130), (30, 25, 22), 14))
    for middle, half, activity in hot:
        v = numpy.where(grid.radius(middle, half) < 1, activity, v)
    write_nifti(path, grid, numpy.maximum(noisy(soft(v, 1.5), 0.08), 0), "f4")


def tiny(path):
    grid = Grid((9, 8, 7), 2.0)
    write_nrrd(path, grid, 1000 * (1 - grid.radius((0, 0, 0), (9, 9, 9))))


def constant(path):
    grid = Grid((40, 40, 40), 1.0)
    write_nrrd(path, grid, grid.full(7))


def knee_pair(path):
    grid = Grid((104, 52, 60), 3.0)
    write_nrrd(path, grid, noisy(soft(knees(grid)), 10))


def small_aside(path):
    """A limb in the corner of a large field of view."""
    grid = Grid((110, 90, 80), 3.0)
    v = grid.full(AIR)
    put(v, grid.radius((95, -80, 0), (40, 36, None)) < 1, MUSCLE)
    put(v, grid.radius((95, -80, 0), (13, 13, None)) < 1, BONE)
    write_nrrd(path, grid, noisy(soft(v), 10))


def hot_voxels(v, _):
    v = v.copy()
    random = numpy.random.default_rng(4)
    for value in (30000, -20000):
        at = tuple(random.integers(0, n, 25) for n in v.shape)
        v[at] = value
    return v


def cylinder(padding):
    def change(v, grid):
        return numpy.where(grid.radius((0, 0, 0), (150, 150, None)) < 1, v, padding)
    return change


def inverted(path):
    grid = Grid(*TORSO)
    write_nrrd(path, grid, 4095 - (noisy(soft(torso(grid)), 12) + 1000), "u2")


def colour(path):
    grid = Grid((48, 48, 40), 2.0)
    v = (255 * (grid.radius((0, 0, 0), (40, 40, 34)) < 1)).astype("u1")
    data = numpy.stack([v, v // 2, v // 4], -1)
    path.write_bytes(b"NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 48 48 40\n"
                     b"kinds: RGB-color domain domain domain\nspacings: nan 2 2 2\n"
                     b"encoding: gzip\n\n" + gzip.compress(data.tobytes(), 1, mtime=0))


def series(path):
    grid = Grid((50, 60, 50), 3.6)
    one = soft(head(grid, T2))
    write_nifti(path, grid, numpy.stack([one, 0.9 * one, 0.8 * one]))


def angiogram(path, tissue=70.0, blood=500.0):
    grid = Grid((80, 80, 80), 2.0)
    v = soft(vessels(grid, tissue, blood), 0.8)
    inside = grid.radius((0, 0, 0), (75, 75, 78)) < 1
    write_nifti(path, grid, numpy.abs(noisy(v * inside + 5, 12)))


def ultrasound(path):
    grid = Grid((90, 70, 80), 1.0)
    speckle = soft(numpy.abs(noisy(grid.full(0), 60)), 0.8)
    v = numpy.where(grid.radius((5, 0, -5), (16, 14, 18)) < 1, 8, 40 + speckle)
    v = numpy.where(grid.radius((-20, 4, 5), (9, 9, 9)) < 1, 190, v)
    fan = (abs(grid.x) < 8 + 0.5 * (grid.z + 40)) & (abs(grid.y) < 6 + 0.4 * (grid.z + 40))
    write_nrrd(path, grid, numpy.clip(v * fan, 0, 255), "u1")


def micro_ct(path):
    grid = Grid((80, 80, 80), 0.03)
    pattern = numpy.sin(grid.x * 17) + numpy.sin(grid.y * 17 + 1) + numpy.sin(grid.z * 17 + 2)
    inside = grid.radius((0, 0, 0), (1.05, 1.05, None)) < 1
    shell = grid.radius((0, 0, 0), (0.93, 0.93, None)) > 1
    v = 9000 + 16000 * (inside & (shell | (pattern > 0.7)))
    write_nrrd(path, grid, noisy(soft(v.astype("f4")), 900), "u2")


def dry_skull(path):
    grid = Grid(*HEAD)
    of = {"air": AIR, "skull": 1200}
    v = head(grid, [of.get(part, AIR) for part in HEAD_PARTS])
    write_nrrd(path, grid, noisy(soft(v), 10))


def no_air(path):
    """Cut within the body on every side."""
    grid = Grid((60, 40, 60), 2.0, (0, 30, -60))
    write_nrrd(path, grid, noisy(soft(torso(grid)), 12))


def probability(path):
    grid = Grid((70, 84, 70), 2.2)
    depth = grid.radius((0, 0, 0), (58, 75, 60))
    v = numpy.clip((1 - depth) * 8, 0, 1) * (0.55 + 0.45 * numpy.sin(grid.x / 7) *
                                             numpy.cos(grid.z / 8))
    write_nifti(path, grid, numpy.clip(v, 0, 1), "f4")


def with_nans(path):
    grid = Grid(*TORSO)
    v = noisy(soft(torso(grid)), 12)
    write_nrrd(path, grid, numpy.where(grid.radius((0, 0, 0), (175, 120, None)) < 1, v, numpy.nan),
               "f4")


def breast_mr(path):
    """MR of a trunk: bright fat, no bone worth the name."""
    grid = Grid(*TORSO)
    hu = torso(grid)
    v = numpy.interp(hu, (-1000, -800, -90, 50, 110, 700), (6, 20, 420, 160, 190, 70))
    write_nifti(path, grid, numpy.abs(noisy(soft(v.astype("f4")), 10)))


def turn(axis, degrees):
    c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    a, b = [i for i in range(3) if i != axis]
    matrix = numpy.eye(3)
    matrix[a, a], matrix[a, b], matrix[b, a], matrix[b, b] = c, -s, s, c
    return matrix


def slab(size, spacing_mm, middle=(0, 0, 0), degrees=0, axis=0):
    def write(path):
        grid = Grid(size, spacing_mm, middle)
        turned = turn(axis, degrees) if degrees else None
        write_nrrd(path, grid, noisy(soft(torso(grid), 0.4), 12), turned=turned)
    return write


def with_table(path):
    grid = Grid((112, 84, 80), 4.0, (0, 25, 0))
    write_nrrd(path, grid, noisy(couch(soft(torso(grid)), grid), 12))


def with_table_in_two(path):
    grid = Grid((112, 92, 80), 4.0, (0, 35, 0))
    write_nrrd(path, grid, noisy(couch(soft(torso(grid, arms_up=True)), grid, 3, 2), 12))


KINDS = {
    "torso CT.nrrd": ct,
    "torso CT on couch.nrrd": with_table,
    "torso arms up, couch in two parts.nrrd": with_table_in_two,
    "head CT on headrest.nrrd": head_on_rest,
    "dry skull.nrrd": dry_skull,
    "knee pair.nrrd": knee_pair,
    "axial slab, 3 slices.nrrd": slab((112, 76, 3), (4, 4, 5)),
    "axial slab, 10 slices.nrrd": slab((112, 76, 10), (4, 4, 4)),
    "sagittal slab.nrrd": slab((6, 76, 80), (4, 4, 4)),
    "coronal slab.nrrd": slab((112, 6, 80), (4, 4, 4), (0, 40, 0)),
    "turned slab.nrrd": slab((112, 76, 8), (4, 4, 4), degrees=35),
    "oblique plate in air.nrrd": oblique_plate,
    "one slice.nrrd": slab((112, 76, 1), (4, 4, 4)),
    "two slices.nrrd": slab((112, 76, 2), (4, 4, 8)),
    "8 mm slices.nrrd": lambda path: ct(path, ((180, 120, 36), (2.4, 2.4, 8.0))),
    "CT angiography.nrrd": lambda path: ct(path, blood=350),
    "CT, no air around.nrrd": no_air,
    "CT with hot voxels.nrrd": lambda path: ct(path, change=hot_voxels),
    "CT, cylinder padded -2000.nrrd": lambda path: ct(path, change=cylinder(-2000)),
    "CT, cylinder padded -3024.nrrd": lambda path: ct(path, change=cylinder(-3024)),
    "CT with NaN outside.nrrd": with_nans,
    "inverted scale.nrrd": inverted,
    "limb in the corner.nrrd": small_aside,
    "CT turned by 30 degrees.nrrd": lambda path: ct(path, turned=turn(2, 30)),
    "float 0 to 1.nrrd": unit_float,
    "float 0 to 1, contrast.nrrd": lambda path: unit_float(path, 450),
    "MR T1.nii.gz": lambda path: mr_head(path, T1),
    "MR T2.nii.gz": lambda path: mr_head(path, T2),
    "MR FLAIR with bias.nii.gz": lambda path: mr_head(path, FLAIR, 0.3),
    "MR noisy.nii.gz": lambda path: mr_head(path, T1, 0.1, 30),
    "MR of a trunk.nii.gz": breast_mr,
    "MR angiography.nii.gz": angiogram,
    "PET.nii.gz": pet,
    "signed map.nii.gz": signed_map,
    "signed map, noise all over.nii.gz": lambda path: signed_map(path, 1.0),
    "probability map.nii.gz": probability,
    "mask, small and aside.nii.gz": lambda path: mask(path, 12),
    "mask.nii.gz": lambda path: mask(path, 60, (0, 0, 0)),
    "labels.nii.gz": labels,
    "noise.nrrd": noise,
    "constant.nrrd": constant,
    "tiny.nrrd": tiny,
    "ultrasound.nrrd": ultrasound,
    "micro-CT.nrrd": micro_ct,
    "colour.nrrd": colour,
    "four dimensions.nii.gz": series,
}
