"""The order in which the places of a saliency map win: winner-take-all with inhibition of return.

Source: L. Itti, C. Koch, E. Niebur, IEEE PAMI 20(11), 1998, section 2.3; inhibition by the
proto-object's shape after Walther and Koch 2006. The original's network of leaky integrate-and-fire
neurons serves the timing; here the winner is the maximum itself, and an inhibited place stays so.
Deterministic: the lowest index wins a tie, and a winner lies at its cell without random offset.
"""
from dataclasses import dataclass

import cv2
import numpy

from .grid import CELL_PX
from .proto_object import THETA, ProtoObject, proto_object

COUNT = 5
DISC_SHARE = 1 / 6  # radius of the inhibited disc, of the map's shorter side (1998 paper)
SHAPE_MARGIN_CELLS = 2  # the inhibited proto-object is widened by so much (SaliencyToolbox)


@dataclass(frozen=True)
class Fixation:
    """rank: 1 is the most salient. cell: (row, column) of the map. position_px: (x, y). saliency:
    of the map, free scale. proto_object: its region, or None where there is none. radius_px: for
    drawing where there is no region."""

    rank: int
    cell: tuple
    position_px: tuple
    saliency: float
    proto_object: ProtoObject | None
    radius_px: float

    def circle_px(self):
        """Circle to draw: around the proto-object, else the inhibited disc; (x, y, radius)."""
        if self.proto_object is not None:
            return self.proto_object.circle_px()
        return (*self.position_px, self.radius_px)


def fixations(maps, count=COUNT, theta=THETA, inhibition="proto-object", clean_up=True):
    """The `count` most salient regions of saliency_maps(...) in order, fewer where nothing salient
    is left. inhibition: "proto-object", or "disc" as in the 1998 paper, which then also spaces the
    winners out."""
    if inhibition not in ("proto-object", "disc"):
        raise ValueError(f'inhibition is "proto-object" or "disc", not {inhibition!r}')

    def region_at(cell):
        return proto_object(maps, cell, theta, clean_up)

    return _compete(
        maps.saliency, (CELL_PX, CELL_PX), count, region_at, by_shape=inhibition == "proto-object"
    )


def map_fixations(saliency, picture_shape, count=COUNT):
    """Fixations of any other saliency map, with inhibition by a disc. saliency: (rows, columns) >=
    0 that covers the picture evenly (cells are areas, as after a resize). picture_shape: (height,
    width, ...)."""
    cell_px = tuple(picture_shape[axis] / saliency.shape[axis] for axis in (0, 1))
    return _compete(saliency, cell_px, count, lambda cell: None, by_shape=False, centre=0.5)


def _compete(saliency, cell_px, count, region_at, by_shape, centre=0.0):
    left = saliency.copy()
    radius = DISC_SHARE * min(saliency.shape)
    winners = []
    while len(winners) < count and left.max() > 0:
        cell = tuple(int(index) for index in numpy.unravel_index(left.argmax(), left.shape))
        region = region_at(cell)
        y, x = ((cell[axis] + centre) * cell_px[axis] - centre for axis in (0, 1))
        winners.append(
            Fixation(
                len(winners) + 1, cell, (x, y), float(left[cell]), region, radius * min(cell_px)
            )
        )
        left[_inhibited(saliency.shape, cell, radius, region if by_shape else None)] = 0
    return winners


def _inhibited(shape, cell, radius, region):
    """Cells that may not win again; always with the winner's own, so that the competition ends."""
    if region is None:
        return _disc(shape, cell, radius)
    margin = 2 * SHAPE_MARGIN_CELLS + 1
    disc = _disc((margin, margin), (SHAPE_MARGIN_CELLS, SHAPE_MARGIN_CELLS), SHAPE_MARGIN_CELLS)
    widened = cv2.dilate(region.mask_cells.astype(numpy.uint8), disc.astype(numpy.uint8)).astype(
        bool
    )
    return widened | _disc(shape, cell, 0)


def _disc(shape, centre, radius):
    rows, columns = numpy.ogrid[: shape[0], : shape[1]]
    return (rows - centre[0]) ** 2 + (columns - centre[1]) ** 2 <= radius**2
