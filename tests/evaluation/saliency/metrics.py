"""How much of a picture's saliency lies in the focus. All maps and masks are (height, width) arrays
at the picture's pixels.

Sources: R. Peters, A. Iyer, L. Itti, C. Koch, Vision Research 45, 2005 (NSS); T. Judd, K. Ehinger,
F. Durand, A. Torralba, ICCV 2009 (AUC); Z. Bylinskii et al., IEEE PAMI 41(3), 2019 (what each
measure favours). Their fixated pixels are the focus' pixels here.

NSS over a mask of area share p is at most sqrt((1 - p) / p): compare it for one mask only, never
between masks.
"""
from dataclasses import dataclass

import cv2
import numpy
import scipy.stats

from .grid import CELL_PX
from .spectral_residual import LUMA

HIT_RANKS = 5  # a hit beyond the fifth winner is no hit
SEAM_PX = 2  # of a mask's rim is left out of its detail: the lens' edge belongs to neither side
MOVED_STEPS = 8  # a moved mask's centre is tried at so many places along each side of the object
MOVED_INSIDE = 0.75  # of a moved mask must lie on the object: background makes it too easy
MOVED_OVERLAP = 0.5  # of a moved mask may lie on the original


@dataclass(frozen=True)
class Scores:
    """All measures of one map against one focus mask. hit_rank is None where no winner up to
    HIT_RANKS lies in the focus."""

    nss: float
    auc: float
    mass_ratio: float
    first_hit: bool
    proto_object_hit: bool
    hit_rank: int | None

    @property
    def any_hit(self):
        """Whether one of the first HIT_RANKS winners lies in the focus."""
        return self.hit_rank is not None


def scores(saliency, fixations, focus):
    """Scores of a saliency map with its fixations, in order, against a bool focus mask."""
    rank = hit_rank(fixations, focus)
    return Scores(
        nss=nss(saliency, focus),
        auc=auc(saliency, focus),
        mass_ratio=mass_ratio(saliency, focus),
        first_hit=rank == 1,
        proto_object_hit=bool(fixations) and proto_object_hit(fixations[0], focus),
        hit_rank=rank,
    )


def nss(saliency, focus):
    """Normalised scanpath saliency: mean over the focus of the standardised map. Chance 0; 0 for a
    flat map."""
    _check(saliency, focus)
    deviation = saliency.std(dtype=float)
    if deviation == 0:
        return 0.0
    return float((saliency[focus].mean(dtype=float) - saliency.mean(dtype=float)) / deviation)


def auc(saliency, focus):
    """Chance that a random focus pixel is more salient than a random other pixel, ties counting
    half (Mann-Whitney). Chance 0.5."""
    _check(saliency, focus)
    ranks = scipy.stats.rankdata(saliency)[focus.ravel()]
    inside, outside = int(focus.sum()), int((~focus).sum())
    return float((ranks.sum() - inside * (inside + 1) / 2) / (inside * outside))


def mass_share(saliency, focus):
    """Share of the map's sum that lies in the focus, in [0, 1]; the focus' share of the area for a
    map of zeros."""
    _check(saliency, focus)
    total = saliency.sum(dtype=float)
    return float(saliency[focus].sum(dtype=float) / total) if total > 0 else float(focus.mean())


def mass_ratio(saliency, focus):
    """Share of the map's sum in the focus over the focus' share of the area. Chance 1."""
    return mass_share(saliency, focus) / float(focus.mean())


def hit_rank(fixations, focus):
    """Rank of the first winner inside the focus widened by one map cell, or None."""
    near = _widened(focus, CELL_PX)
    for fixation in fixations[:HIT_RANKS]:
        if _at(near, fixation.position_px):
            return fixation.rank
    return None


def proto_object_hit(fixation, focus):
    """Whether most of the winner's region lies in the focus widened by one map cell; the winner
    itself where it has no region."""
    near = _widened(focus, CELL_PX)
    if fixation.proto_object is None:
        return _at(near, fixation.position_px)
    return bool(near[fixation.proto_object.mask_px].mean() > 0.5)


def shuffled_nss(saliency, masks):
    """Mean NSS over masks that lie elsewhere, the control for the focus' own NSS; None without
    masks."""
    return float(numpy.mean([nss(saliency, mask) for mask in masks])) if masks else None


def moved_masks(focus, body):
    """The focus mask moved to other places of the object, for shuffled_nss. body: bool mask of all
    that is not background. May be empty: a focus as large as the object has nowhere to go."""
    centre = [axis.mean() for axis in numpy.nonzero(focus)]
    extents = [(axis.min(), axis.max()) for axis in numpy.nonzero(body)]
    targets = [numpy.linspace(*extent, MOVED_STEPS + 2)[1:-1] for extent in extents]
    moved = (
        _moved(focus, round(y - centre[0]), round(x - centre[1]))
        for y in targets[0]
        for x in targets[1]
    )
    return [mask for mask in moved if _is_elsewhere(mask, focus, body)]


def detail(rgb, mask):
    """Mean |Laplacian| of the luma over a mask, its rim of SEAM_PX left out; rgb in [0, 1]. 0 where
    nothing is left of the mask."""
    inner = cv2.erode(
        mask.astype(numpy.uint8), numpy.ones((2 * SEAM_PX + 1,) * 2, numpy.uint8)
    ).astype(bool)
    laplacian = cv2.Laplacian(
        (rgb @ LUMA).astype(numpy.float32), cv2.CV_32F, borderType=cv2.BORDER_REPLICATE
    )
    return float(numpy.abs(laplacian[inner]).mean()) if inner.any() else 0.0


def _check(saliency, focus):
    if saliency.shape != focus.shape or focus.dtype != bool:
        raise ValueError(
            f"the focus must be a bool mask of {saliency.shape}, not {focus.dtype} of {focus.shape}"
        )
    if not focus.any() or focus.all():
        raise ValueError("the focus must have pixels, and must not fill the picture")


def _widened(mask, reach_px):
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach_px + 1,) * 2)
    return cv2.dilate(mask.astype(numpy.uint8), disc).astype(bool)


def _at(mask, position_px):
    x, y = (
        min(max(round(value), 0), size - 1) for value, size in zip(position_px, mask.shape[::-1])
    )
    return bool(mask[y, x])


def _moved(mask, down, right):
    shift = numpy.array([[1, 0, right], [0, 1, down]], float)
    moved = cv2.warpAffine(
        mask.astype(numpy.uint8), shift, mask.shape[::-1], flags=cv2.INTER_NEAREST
    )
    return moved.astype(bool)


def _is_elsewhere(moved, focus, body):
    area = focus.sum()
    return (moved & body).sum() >= MOVED_INSIDE * area and (
        moved & focus
    ).sum() <= MOVED_OVERLAP * area
