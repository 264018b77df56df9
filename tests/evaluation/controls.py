"""What must hold beside the verdict's comparison: the map answers to the focus' place and not to
any place of the body, and the style moves detail from the context to the focus.
"""
from dataclasses import dataclass

import numpy

import saliency
from looks import GREY
from saliency.experiment import CONDITIONS
from saliency.metrics import nss
from saliency.requirements import require

VISIBLE = 0.02  # a pixel that differs so much from the background shows the body


@dataclass(frozen=True)
class Reading:
    """One picture under the primary model. nss_elsewhere: of the same map on the focus mask moved
    over the body, None where it has nowhere to go. detail_*: mean |Laplacian| of the luma."""

    nss: float
    nss_elsewhere: float | None
    detail_focus: float
    detail_context: float


@dataclass(frozen=True)
class Control:
    """Means of one condition. Both NSS are over the units whose focus can be moved."""

    condition: str
    movable_units: int
    nss: float
    nss_elsewhere: float
    detail_focus: float
    detail_context: float


def read(pictures, examined, focus):
    """{condition: Reading} of one unit. examined: {(condition, model): Examined}."""
    body = numpy.abs(pictures["A"] - GREY[0]).max(axis=2) > VISIBLE
    moved = saliency.moved_masks(focus, body)
    return {
        condition: _reading(
            rgb, examined[condition, saliency.PRIMARY].saliency_px, focus, body, moved
        )
        for condition, rgb in pictures.items()
    }


def _reading(rgb, salient, focus, body, moved):
    return Reading(
        nss(salient, focus),
        saliency.shuffled_nss(salient, moved),
        saliency.detail(rgb, focus),
        saliency.detail(rgb, body & ~focus),
    )


def means(readings):
    """[Control] over the units' {condition: Reading}."""
    return [_mean(condition, [r[condition] for r in readings]) for condition in CONDITIONS]


def _mean(condition, readings):
    movable = [r for r in readings if r.nss_elsewhere is not None]
    return Control(
        condition,
        len(movable),
        *(_average(r, movable) for r in ("nss", "nss_elsewhere")),
        *(_average(r, readings) for r in ("detail_focus", "detail_context")),
    )


def _average(name, readings):
    return float(numpy.mean([getattr(r, name) for r in readings])) if readings else float("nan")


def requirements(readings, data_sets):
    """[Requirement]. readings: {condition: Reading} of each unit; data_sets: the units'."""
    pairs = list(zip(readings, data_sets, strict=True))
    movable = [(r, d) for r, d in pairs if r["A"].nss_elsewhere is not None]
    return [
        _require("A: NSS on the focus > NSS on it moved elsewhere", movable,
                 lambda r: (r["A"].nss, r["A"].nss_elsewhere)),
        _require("detail in the focus: A > B", pairs,
                 lambda r: (r["A"].detail_focus, r["B"].detail_focus)),
        _require("detail in the context: B > A", pairs,
                 lambda r: (r["B"].detail_context, r["A"].detail_context)),
    ]  # fmt: skip


def _require(text, pairs, larger_and_smaller):
    values = [larger_and_smaller(reading) for reading, _ in pairs]
    return require(text, values, [data_set for _, data_set in pairs])
