"""The region that a salient place belongs to: traced back to the feature that made it salient, and
cut out of that map.

Source: D. Walther, C. Koch, "Modeling Attention to Salient Proto-Objects", Neural Networks 19(9),
2006, section 2.2. A region never exceeds a tenth of the picture, so a large focus is never found as
one region: ask where regions lie, not how well their outlines agree with the focus.
"""
from dataclasses import dataclass

import cv2
import numpy

from .grid import MAP_LEVEL
from .itti import CHANNELS

THETA = 0.1  # of the value at the winner. The paper's; the SaliencyToolbox falls back to 0.05
NEAR_TIE = 0.05  # a lone object weighs nearly the same at all scales; 16-pixel cells draw it badly
LARGEST_SHARE = 0.1  # of the map
SMOOTHING_SIGMA_PX = 8.0  # half a map cell: rounds the steps of the nearest-neighbour enlargement

DIAMOND = numpy.array(
    [[abs(row) + abs(column) <= 2 for column in range(-2, 3)] for row in range(-2, 3)], numpy.uint8
)
CROSS = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))


@dataclass(frozen=True)
class ProtoObject:
    """source: name of the map it was cut from. channel: "intensity", "colour" or "orientation", the
    one that made it salient. mask_px: (height, width) bool. mask_cells: (rows, columns) bool at
    level 4, true where any part of the cell is in it."""

    source: str
    channel: str
    mask_px: numpy.ndarray
    mask_cells: numpy.ndarray

    def outlines(self):
        """Closed outlines in pixels, smoothed for drawing: list of (n, 1, 2) int arrays of x, y."""
        smooth = cv2.GaussianBlur(self.mask_px.astype(numpy.float32), (0, 0), SMOOTHING_SIGMA_PX)
        found, _ = cv2.findContours(
            (smooth >= 0.5).astype(numpy.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
        )
        return list(found)

    def circle_px(self):
        """Smallest circle around the region: (x, y, radius)."""
        rows, columns = numpy.nonzero(self.mask_px)
        (x, y), radius = cv2.minEnclosingCircle(
            numpy.stack([columns, rows], axis=1).astype(numpy.float32)
        )
        return x, y, radius


def proto_object(maps, cell, theta=THETA, clean_up=True):
    """The proto-object at a cell (row, column) of the saliency map, or None where no map yields an
    acceptable shape. clean_up: open and close the region, which takes off threads and fills dents.
    """
    channel = max(CHANNELS, key=lambda name: maps.conspicuity[name][cell])
    for source, values, level in _candidates(maps, channel, cell):
        region = _region(values, _sample(cell, level), theta, clean_up)
        if region is not None:
            return ProtoObject(
                source, channel, _at_pixels(maps.grid, region, level), _at_cells(region, level)
            )
    return None


def _candidates(maps, channel, cell):
    """Maps to cut the region from, the most specific first: (name, values, level)."""
    of_channel = [plane for plane in maps.features if plane.channel == channel]
    best = _strongest(of_channel, cell)
    yield best.name, best.values, best.centre_level
    yield f"conspicuity of {channel}", maps.conspicuity[channel], MAP_LEVEL
    yield "saliency", maps.saliency, MAP_LEVEL


def _strongest(feature_maps, cell):
    """The map with the largest value at the cell. Of near equals the one with the finest centre, as
    it draws the outline best, and the coarsest surround, as a close one answers around the object
    too."""
    at_cell = {
        plane.name: plane.values[_sample(cell, plane.centre_level)] for plane in feature_maps
    }
    enough = (1 - NEAR_TIE) * max(at_cell.values())
    near = [plane for plane in feature_maps if at_cell[plane.name] >= enough]
    return min(near, key=lambda plane: (plane.centre_level, -plane.surround_level))


def _sample(cell, level):
    """The sample of a level that lies on the cell's pixel."""
    finer = 2 ** (MAP_LEVEL - level)
    return cell[0] * finer, cell[1] * finer


def _region(values, seed, theta, clean_up):
    """The connected samples >= theta times the seed's value that hold the seed; None if none or too
    many."""
    if values[seed] <= 0:
        return None
    region = _component(values >= theta * values[seed], seed)
    if clean_up:
        region = _cleaned(region, seed)
    return region if region.sum() < LARGEST_SHARE * region.size else None


def _cleaned(region, seed):
    for element in (DIAMOND, CROSS):
        opened = cv2.morphologyEx(region.astype(numpy.uint8), cv2.MORPH_OPEN, element)
        closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, element).astype(bool)
        if closed[seed]:
            return _component(closed, seed)
    return region


def _component(binary, seed):
    _, labels = cv2.connectedComponents(binary.astype(numpy.uint8), connectivity=4)
    return labels == labels[seed]


def _at_pixels(grid, region, level):
    return grid.to_pixels(region, level, cv2.INTER_NEAREST) > 0


def _at_cells(region, level):
    finer = 2 ** (MAP_LEVEL - level)
    spread = (
        cv2.dilate(region.astype(numpy.uint8), numpy.ones((finer + 1, finer + 1), numpy.uint8))
        if finer > 1
        else region
    )
    return spread[::finer, ::finer].astype(bool)
