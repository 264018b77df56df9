"""The saliency models of the evaluation behind one call: a picture goes in, a map at its pixels and
the ranked winners come out.
"""
from dataclasses import dataclass

import numpy

from .fixations import COUNT, fixations, map_fixations
from .itti import saliency_maps
from .spectral_residual import spectral_residual, to_pixels

PRIMARY = "Itti-Koch-Niebur"
SINGLE_PASS = "Itti-Koch-Niebur, single pass"
SECOND_OPINION = "spectral residual"


@dataclass(frozen=True)
class Examined:
    """model: its name. saliency_px: (height, width) >= 0, free scale. fixations: ranked winners,
    see fixations.Fixation."""

    model: str
    saliency_px: numpy.ndarray
    fixations: list


def examine(rgb, model, count=COUNT):
    """A picture under one of MODELS. rgb: (height, width, 3) in [0, 1], display-encoded, sides >=
    256 px."""
    return Examined(model, *MODELS[model](rgb, count))


def _itti(normalisation):
    def examined(rgb, count):
        maps = saliency_maps(rgb, normalisation)
        return maps.saliency_px(), fixations(maps, count)

    return examined


def _spectral_residual(rgb, count):
    saliency = spectral_residual(rgb)
    return to_pixels(saliency, rgb.shape), map_fixations(saliency, rgb.shape, count)


# The single pass differs from the primary model in its normalisation only: it shows how much hangs
# on that, and is no second opinion.
MODELS = {
    PRIMARY: _itti("iterative"),
    SINGLE_PASS: _itti("single pass"),
    SECOND_OPINION: _spectral_residual,
}
