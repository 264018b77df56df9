"""Volumes of many kinds, made from formulas: what a first picture has to cope with."""
import gzip
import struct

import numpy

AIR, FAT, MUSCLE, BONE, LUNG, BLOOD = -1000.0, -90.0, 50.0, 700.0, -800.0, 45.0


class Grid:
    """Voxel centres in mm, in patient axes (LPS), the middle at 0; arrays are indexed [k, j, i]."""

    def __init__(self, size, spacing_mm, middle_mm=(0, 0, 0)):
        self.size = size
        self.spacing_mm = spacing_mm if hasattr(spacing_mm, "__len__") else (spacing_mm,) * 3
        self.origin_mm = tuple(
            m - 0.5 * (n - 1) * s for n, s, m in zip(size, self.spacing_mm, middle_mm)
        )
        x, y, z = (
            o + s * numpy.arange(n, dtype=numpy.float32)
            for n, s, o in zip(size, self.spacing_mm, self.origin_mm)
        )
        self.x, self.y, self.z = x[None, None, :], y[None, :, None], z[:, None, None]

    def full(self, value):
        return numpy.full(self.size[::-1], value, numpy.float32)

    def radius(self, middle, half):
        """1 on the ellipsoid; an axis of no extent is left out: a cylinder along it."""
        terms = [
            ((along - m) / h) ** 2
            for along, m, h in zip((self.x, self.y, self.z), middle, half)
            if h is not None
        ]
        return numpy.sqrt(sum(terms[1:], terms[0])) + self.full(0)


def put(volume, inside, value):
    volume[numpy.broadcast_to(inside, volume.shape)] = value


def soft(volume, voxels=0.7):
    """A scanner's point spread: a Gaussian, one axis after the other."""
    reach = int(3 * voxels + 1)
    weights = numpy.exp(-0.5 * (numpy.arange(-reach, reach + 1) / voxels) ** 2)
    weights /= weights.sum()
    for axis in range(3):
        edges = [(reach, reach) if a == axis else (0, 0) for a in range(3)]
        padded = numpy.pad(volume, edges, "edge")
        length = volume.shape[axis]
        volume = sum(
            w * numpy.take(padded, range(i, i + length), axis) for i, w in enumerate(weights)
        )
    return volume.astype(numpy.float32)


def noisy(volume, sigma, seed=1):
    random = numpy.random.default_rng(seed)
    return volume + random.normal(0, sigma, volume.shape).astype(numpy.float32)


def torso(grid, blood=BLOOD, arms_up=False):
    """CT in HU: fat, muscle, ribs, lungs, heart, liver, aorta, spine; head end above."""
    v = grid.full(AIR)
    body = grid.radius((0, 0, 0), (165, 105, None))
    put(v, body < 1, FAT)
    put(v, grid.radius((0, 0, 0), (148, 88, None)) < 1, MUSCLE)
    shell = grid.radius((0, 0, 0), (140, 82, None))
    slanted = numpy.mod(grid.z + 0.35 * grid.y, 32) < 11
    put(v, (shell > 0.93) & (shell < 1) & slanted & (grid.z > -40), BONE)
    for side in (-1, 1):
        put(v, grid.radius((side * 72, -5, 70), (48, 58, 110)) < 1, LUNG)
        if arms_up:
            put(v, (grid.radius((side * 120, 0, 0), (32, 32, None)) < 1) & (grid.z > 90), MUSCLE)
            put(v, (grid.radius((side * 120, 0, 0), (11, 11, None)) < 1) & (grid.z > 90), BONE)
    put(v, grid.radius((15, -25, 40), (45, 38, 50)) < 1, blood)
    put(v, grid.radius((-55, -5, -70), (75, 62, 40)) < 1, 110.0 if blood > 100 else 60.0)
    put(v, grid.radius((12, 35, 0), (12, 12, None)) < 1, blood)
    for side in (-1, 1):
        put(v, grid.radius((side * 60, 40, -90), (24, 20, 45)) < 1, 0.8 * blood + 10)
    put(v, (grid.radius((0, 62, 0), (22, 19, None)) < 1) & (numpy.mod(grid.z, 34) < 28), BONE)
    put(v, grid.radius((0, 88, 0), (6, 10, None)) < 1, BONE)
    return v


def couch(v, grid, gap_mm=0.0, parts=1):
    """A shell with a foam core under the body; `parts`: with a mattress apart from it."""
    top = 105 + gap_mm + (22 if parts > 1 else 0)
    if parts > 1:
        put(v, (grid.y > 105 + gap_mm) & (grid.y < top - 4) & (abs(grid.x) < 170), -150.0)
    across = (abs(grid.x) < 190) & (grid.y > top) & (grid.y < top + 40)
    core = (abs(grid.x) < 186) & (grid.y > top + 4) & (grid.y < top + 36)
    put(v, across & (v < -300), 150.0)
    put(v, across & core & (v < 400), -850.0)
    return v


HEAD_PARTS = ("air", "skin", "skull", "csf", "grey", "white", "ventricle")


def head(grid, values, wall_mm=7.0):
    """Each part's value by HEAD_PARTS; with folds in the cortex, eyes, nose and neck."""
    of = dict(zip(HEAD_PARTS, values))
    v = grid.full(of["air"])
    put(v, (grid.radius((0, 15, 0), (55, 60, None)) < 1) & (grid.z < -60), of["skin"])
    put(v, grid.radius((0, -92, -40), (14, 24, 22)) < 1, of["skin"])
    put(v, grid.radius((0, 0, 0), (76, 98, 102)) < 1, of["skin"])
    for side in (-1, 1):
        put(v, grid.radius((side * 79, 5, -20), (8, 20, 28)) < 1, of["skin"])
    put(v, grid.radius((0, 5, 12), (69, 86, 82)) < 1, of["skull"])
    put(v, (grid.radius((0, 70, 0), (16, 16, None)) < 1) & (grid.z < -50), of["skull"])
    put(v, grid.radius((0, 5, 12), (69 - wall_mm, 86 - wall_mm, 82 - wall_mm)) < 1, of["csf"])
    folds = numpy.sin(grid.x / 5.5 + numpy.sin(grid.z / 8) * 2) * numpy.sin(grid.y / 6 + grid.z / 9)
    depth = grid.radius((0, 5, 14), (58, 75, 70)) + 0.05 * folds
    put(v, (depth < 1) & (abs(grid.x) > 1.5), of["grey"])
    put(v, (depth < 0.9) & (abs(grid.x) > 2.5), of["white"])
    for side in (-1, 1):
        put(v, grid.radius((side * 10, 0, 18), (6, 34, 12)) < 1, of["ventricle"])
        put(v, grid.radius((side * 32, -82, -8), (12, 12, 12)) < 1, of["csf"])
    return v


def knees(grid):
    v = grid.full(AIR)
    for side in (-1, 1):
        x = side * 90
        put(v, grid.radius((x, 0, 0), (62, 68, None)) < 1, FAT)
        put(v, grid.radius((x, 0, 0), (52, 58, None)) < 1, MUSCLE)
        put(v, (grid.radius((x, 0, 0), (17, 17, None)) < 1) & (abs(grid.z) > 6), BONE)
        put(v, (grid.radius((x, 0, 32), (36, 32, 28)) < 1) & (abs(grid.z) > 6), BONE)
        put(v, (grid.radius((x, 0, -30), (36, 30, 26)) < 1) & (abs(grid.z) > 6), BONE)
        put(v, grid.radius((x, -46, 22), (18, 9, 20)) < 1, BONE)
    return v


def vessels(grid, tissue, blood, spread=80.0):
    """A tree of winding tubes within tissue."""
    v = grid.full(0) + tissue
    for n in range(7):
        turn = 2 * numpy.pi * n / 7
        reach = spread * (0.3 + 0.7 * abs(grid.z) / spread)
        x = reach * numpy.cos(turn + grid.z / 60) * 0.7
        y = reach * numpy.sin(turn + grid.z / 45) * 0.7
        put(v, numpy.hypot(grid.x - x, grid.y - y) < 3.0, blood)
    return v


NRRD_TYPES = {"f4": "float", "i2": "short", "u2": "ushort", "u1": "uchar", "i4": "int"}


def write_nrrd(path, grid, volume, kind="i2", turned=None):
    """LPS. `turned`: a rotation matrix of the grid's axes."""
    axes = numpy.eye(3) if turned is None else numpy.asarray(turned)
    columns = axes * numpy.asarray(grid.spacing_mm)
    vectors = " ".join("(" + ",".join(f"{n:.6f}" for n in columns[:, a]) + ")" for a in range(3))
    origin = axes @ numpy.asarray(grid.origin_mm)
    head_text = (
        f"NRRD0004\ntype: {NRRD_TYPES[kind]}\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {' '.join(str(n) for n in volume.shape[::-1])}\nspace directions: {vectors}\n"
        f"space origin: ({','.join(f'{n:.6f}' for n in origin)})\n"
        f"kinds: domain domain domain\nendian: little\nencoding: gzip\n\n"
    )
    data = volume if kind == "f4" else numpy.rint(volume)
    voxels = gzip.compress(data.astype("<" + kind).tobytes(), 1, mtime=0)
    path.write_bytes(head_text.encode() + voxels)


NIFTI_TYPES = {"u1": (2, 8), "i2": (4, 16), "f4": (16, 32), "u2": (512, 16), "i4": (8, 32)}


def write_nifti(path, grid, volume, kind="i2", slope=1.0, intercept=0.0):
    """RAS by an sform; a fourth dimension where the array has one."""
    sizes = volume.shape[::-1]
    code, bits = NIFTI_TYPES[kind]
    dim = [len(sizes), *sizes, *[1] * (7 - len(sizes))]
    x, y, z = grid.origin_mm
    dx, dy, dz = grid.spacing_mm
    header = struct.pack("<i35sB8hfffhhhh8f", 348, b"", 0, *dim, 0, 0, 0, 0, code, bits, 0,
                         1.0, dx, dy, dz, 1.0, 1.0, 1.0, 1.0)
    header += struct.pack("<fffhBBffffii80s24shh6f", 352.0, slope, intercept, 0, 0, 2, 0, 0, 0, 0,
                          0, 0, b"", b"", 0, 1, 0, 0, 0, 0, 0, 0)
    header += struct.pack("<12f16s4s", -dx, 0, 0, -x, 0, -dy, 0, -y, 0, 0, dz, z, b"", b"n+1\0")
    data = volume if kind == "f4" else numpy.rint(volume)
    voxels = data.astype("<" + kind).tobytes()
    path.write_bytes(gzip.compress(header + b"\0" * 4 + voxels, 1, mtime=0))
