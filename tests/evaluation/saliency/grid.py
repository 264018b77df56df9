"""Where the cells of a dyadic pyramid lie on the picture, and how the picture is framed so that
they lie evenly.

Each halving keeps samples 0, 2, 4 ... of the level below, so cell (row, column) of level L lies
exactly on pixel (row * 2^L, column * 2^L) of the framed picture. Both borders carry a sample at
every level only if the framed sides are k * 256 + 1 pixels; otherwise the coarse surrounds end up
to 255 pixels short of the right and the lower border and a mirrored picture would get another map.
So the picture is framed by repeating its border pixels, and the maps are cropped again.
"""
from dataclasses import dataclass

import cv2
import numpy

COARSEST_LEVEL = 8
MAP_LEVEL = 4
CELL_PX = 2**MAP_LEVEL
SMALLEST_SIDE_PX = 2**COARSEST_LEVEL


@dataclass(frozen=True)
class Axis:
    """One side of the picture. size_px: its pixels. cells: cells of the saliency map that cover it.
    before_px: added pixels before its first one, a multiple of CELL_PX. framed_px: all pixels, k *
    256 + 1."""

    size_px: int
    cells: int
    before_px: int
    framed_px: int

    @classmethod
    def of(cls, size_px):
        """ValueError under SMALLEST_SIDE_PX: the coarsest surround would not fit the picture."""
        if size_px < SMALLEST_SIDE_PX:
            raise ValueError(
                f"a picture's side must have at least {SMALLEST_SIDE_PX} pixels, not {size_px}"
            )
        steps = -(-(size_px - 1) // CELL_PX)
        spans = -(-(size_px - 1) // SMALLEST_SIDE_PX)
        spare_cells = spans * (SMALLEST_SIDE_PX // CELL_PX) - steps
        return cls(size_px, steps + 1, spare_cells // 2 * CELL_PX, spans * SMALLEST_SIDE_PX + 1)

    @property
    def after_px(self):
        return self.framed_px - self.before_px - self.size_px

    def range_at(self, level):
        """The cells that cover the picture, as a slice of a framed level <= MAP_LEVEL."""
        finer = 2 ** (MAP_LEVEL - level)
        begin = self.before_px // 2**level
        return slice(begin, begin + (self.cells - 1) * finer + 1)


@dataclass(frozen=True)
class Grid:
    """The two sides of one picture."""

    rows: Axis
    columns: Axis

    @classmethod
    def of(cls, picture):
        """picture: (height, width, ...) array."""
        return cls(Axis.of(picture.shape[0]), Axis.of(picture.shape[1]))

    @property
    def map_shape(self):
        return self.rows.cells, self.columns.cells

    def frame(self, picture):
        """The picture with its border pixels repeated outwards, float32."""
        return cv2.copyMakeBorder(
            picture.astype(numpy.float32),
            self.rows.before_px,
            self.rows.after_px,
            self.columns.before_px,
            self.columns.after_px,
            cv2.BORDER_REPLICATE,
        )

    def crop(self, plane, level):
        """The part of a framed level (<= MAP_LEVEL) that covers the picture."""
        return plane[self.rows.range_at(level), self.columns.range_at(level)]

    def to_pixels(self, plane, level, interpolation=cv2.INTER_LINEAR):
        """A cropped plane of a level, sampled at every pixel of the picture: (height, width)
        float32."""
        return _sample(
            plane, self.rows.size_px, self.columns.size_px, 1 / 2**level, interpolation
        )


def halve(plane):
    """Next coarser level: 5-tap binomial filter, every second sample; (rows, columns) ->
    (ceil(rows/2), ceil(columns/2))."""
    return cv2.pyrDown(plane, borderType=cv2.BORDER_REPLICATE)


def pyramid(plane, levels):
    """Levels 0..levels-1 of a Gaussian pyramid (Burt and Adelson 1983), level 0 being the plane
    itself."""
    planes = [plane]
    while len(planes) < levels:
        planes.append(halve(planes[-1]))
    return planes


def coarsen(plane, level, target_level):
    """A plane of a level at a coarser level."""
    for _ in range(target_level - level):
        plane = halve(plane)
    return plane


def refine(plane, shape, levels):
    """A coarse plane at the samples of a plane `levels` finer with that shape, bilinear. cv2.resize
    would not do: it takes samples for centres of areas and would shift the plane by half a coarse
    cell."""
    return _sample(plane, *shape, 1 / 2**levels, cv2.INTER_LINEAR)


def _sample(plane, rows, columns, scale, interpolation):
    to_source = numpy.array([[scale, 0, 0], [0, scale, 0]])
    return cv2.warpAffine(
        plane.astype(numpy.float32),
        to_source,
        (columns, rows),
        flags=interpolation | cv2.WARP_INVERSE_MAP,
        borderMode=cv2.BORDER_REPLICATE,
    )
