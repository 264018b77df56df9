"""Saliency map of a picture after Itti, Koch and Niebur.

Source: L. Itti, C. Koch, E. Niebur, IEEE PAMI 20(11), 1998, sections 2.1 and 2.2. Where the
SaliencyToolbox of D. Walther differs (colour opponents, iterative normalisation), this follows the
toolbox, because the dissertation's evaluation used it. Rendered pictures should have the same
mid-grey background in all conditions: its contrast counts like any other.
"""
from dataclasses import dataclass

import numpy

from . import features
from .grid import COARSEST_LEVEL, MAP_LEVEL, Grid, coarsen, pyramid, refine
from .normalisation import NORMALISATIONS

CENTRE_LEVELS = (2, 3, 4)
SURROUND_STEPS = (3, 4)
CHANNELS = ("intensity", "colour", "orientation")  # the order that settles ties
RIM_CELLS = 1  # of the map: at the border filters see repeated pixels, which makes false winners


@dataclass(frozen=True)
class FeatureMap:
    """One normalised centre-surround map. values: (rows, columns) >= 0 at the centre level."""

    channel: str
    feature: str
    centre_level: int
    surround_level: int
    values: numpy.ndarray

    @property
    def name(self):
        return f"{self.feature}({self.centre_level},{self.surround_level})"


@dataclass(frozen=True)
class SaliencyMaps:
    """All maps of one picture. saliency and conspicuity[channel]: (rows, columns) >= 0 at level 4;
    cell (i, j) lies on pixel (16 i, 16 j). The scale is free: compare places within a picture, not
    values between pictures."""

    grid: Grid
    features: tuple
    conspicuity: dict
    saliency: numpy.ndarray

    def saliency_px(self):
        """The saliency at each pixel: (height, width), bilinear between the cells."""
        return self.grid.to_pixels(self.saliency, MAP_LEVEL)


def saliency_maps(rgb, normalisation="iterative"):
    """All maps of a picture. rgb: (height, width, 3) in [0, 1], display-encoded, each side >= 256
    px, better >= 512. normalisation: "iterative" or "single pass"."""
    normalise = NORMALISATIONS[normalisation]
    grid = Grid.of(rgb)
    maps = tuple(_feature_maps(grid, grid.frame(rgb), normalise))
    conspicuity = {channel: _conspicuity(maps, channel, normalise) for channel in CHANNELS}
    saliency = sum(normalise(plane) for plane in conspicuity.values()) / len(CHANNELS)
    return SaliencyMaps(grid, maps, conspicuity, saliency)


def _feature_maps(grid, framed, normalise):
    for channel, feature, planes in _feature_pyramids(framed):
        for centre in CENTRE_LEVELS:
            for step in SURROUND_STEPS:
                difference = grid.crop(centre_surround(planes, centre, centre + step), centre)
                values = normalise(_without_rim(difference, RIM_CELLS * 2 ** (MAP_LEVEL - centre)))
                yield FeatureMap(channel, feature, centre, centre + step, values)


def _feature_pyramids(framed):
    """(channel, feature, planes by level) of each feature."""
    intensities = pyramid(features.intensity(framed), COARSEST_LEVEL + 1)
    yield "intensity", "intensity", intensities
    yield "colour", "red-green", pyramid(features.red_green(framed), COARSEST_LEVEL + 1)
    yield "colour", "blue-yellow", pyramid(features.blue_yellow(framed), COARSEST_LEVEL + 1)
    for angle in features.ORIENTATIONS_DEG:
        energies = {
            level: features.orientation_energy(intensities[level], angle)
            for level in range(min(CENTRE_LEVELS), COARSEST_LEVEL + 1)
        }
        yield "orientation", f"{angle} deg", energies


def centre_surround(planes, centre, surround):
    """|centre level - surround level|, at the samples of the centre level."""
    return numpy.abs(
        planes[centre] - refine(planes[surround], planes[centre].shape, surround - centre)
    )


def _without_rim(plane, width):
    inner = numpy.zeros_like(plane)
    inner[width:-width, width:-width] = plane[width:-width, width:-width]
    return inner


def _conspicuity(maps, channel, normalise):
    """Across-scale sum of a channel's maps at level 4; orientations are normalised one by one
    before they are added."""
    of_channel = [plane for plane in maps if plane.channel == channel]
    if channel != "orientation":
        return _sum_at_map_level(of_channel)
    names = dict.fromkeys(plane.feature for plane in of_channel)
    return sum(
        normalise(_sum_at_map_level([p for p in of_channel if p.feature == name])) for name in names
    )


def _sum_at_map_level(maps):
    return sum(coarsen(plane.values, plane.centre_level, MAP_LEVEL) for plane in maps)
