"""The performance table against its acceptance criteria. Milliseconds are compared, never
differences of frames per second, which whole numbers of them would blur.
"""
from dataclasses import dataclass

FLOOR_FPS = 8.0
MOST_LENS_OVERHEAD = 0.25  # of the control
MOST_GROWTH = 0.25  # of a filter's cost: noise, and a picture that is not quite the same
CONTROL, LENS, BOTH_FILTERS = "Phong, no lens", "lens", "lens + both"
FILTERS = ("kuwahara", "sobel")


@dataclass(frozen=True)
class Criterion:
    """text: what is asked. told: the figures that decide, in words."""

    text: str
    holds: bool
    told: str


def judge(rows, small_stages, least_frames):
    """[Criterion] of {volume: [Cell]}; small_stages: {volume: ms by stage} with both filters on the
    same volumes with an eighth of the voxels."""
    return [
        _frames(rows, least_frames),
        _floor(rows),
        _lens_overhead(rows),
        *(_independent(rows, small_stages, stage) for stage in FILTERS),
    ]


def _frames(rows, least_frames):
    fewest = min(cell.frames for row in rows.values() for cell in row)
    text = f"medians and 95th percentiles over at least {least_frames} frames"
    return Criterion(text, fewest >= least_frames, f"fewest {fewest}")


def _floor(rows):
    volume, slowest = max(
        ((volume, cell) for volume, row in rows.items() for cell in row),
        key=lambda pair: pair[1].median_ms,
    )
    fps = 1000 / slowest.median_ms
    return Criterion(
        f"every configuration at {FLOOR_FPS:g} frames per second or more",
        fps >= FLOOR_FPS,
        f"slowest {volume}, {slowest.case}: median {slowest.median_ms:.1f} ms, {fps:.1f} a second "
        f"(p95 {slowest.p95_ms:.1f} ms)",
    )


def _lens_overhead(rows):
    overheads = {
        volume: _case(row, LENS).median_ms / _case(row, CONTROL).median_ms - 1
        for volume, row in rows.items()
    }
    return Criterion(
        f"the lens costs at most {MOST_LENS_OVERHEAD:.0%} of the control",
        max(overheads.values()) <= MOST_LENS_OVERHEAD,
        ", ".join(f"{volume} {overhead:+.0%}" for volume, overhead in overheads.items()),
    )


def _independent(rows, small_stages, stage):
    """Over all volumes together: a stage alone is short and its noise is large."""
    large_ms = sum(_case(row, BOTH_FILTERS).stages_ms[stage] for row in rows.values())
    small_ms = sum(small_stages[volume][stage] for volume in rows)
    growth = large_ms / small_ms - 1
    return Criterion(
        f"the cost of {stage} does not depend on the volume's size (eight times the voxels, at "
        f"most {MOST_GROWTH:.0%} more)",
        growth <= MOST_GROWTH,
        f"{growth:+.0%}: {small_ms:.2f} and {large_ms:.2f} ms over {len(rows)} volumes",
    )


def _case(row, name):
    return next(cell for cell in row if cell.case == name)
