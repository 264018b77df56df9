"""Whether a figure grows over time, told from noise and from what a start needs."""
import statistics
from dataclasses import dataclass

WARM_UP = 1 / 3  # of the time: caches fill, pools and buffers come to their size
WINDOWS = 30  # whose medians are compared, so that single spikes do not count


@dataclass(frozen=True)
class Limit:
    """How much a figure may grow from the end of the warm-up to the end: so much, or the share of
    its median where that is more."""

    figure: str
    unit: str
    most: float
    share: float = 0.0


@dataclass(frozen=True)
class Verdict:
    limit: Limit
    median: float
    grown: float
    allowed: float

    @property
    def holds(self):
        return self.grown <= self.allowed


def judge(limit, samples):
    """samples: (seconds, value) in their order."""
    begun, ended = samples[0][0], samples[-1][0]
    counted = [s for s in samples if s[0] >= begun + WARM_UP * (ended - begun)]
    if len(counted) < 3:
        raise ValueError(f"{limit.figure}: {len(counted)} samples tell nothing; measure for longer")
    median = statistics.median(value for _, value in counted)
    grown = slope(windows(counted)) * (counted[-1][0] - counted[0][0])
    return Verdict(limit, median, grown, max(limit.most, limit.share * median))


def windows(samples):
    """(seconds, value) medians of up to WINDOWS pieces of the same length."""
    size = -(-len(samples) // WINDOWS)
    pieces = [samples[i : i + size] for i in range(0, len(samples), size)]
    return [tuple(statistics.median(column) for column in zip(*piece)) for piece in pieces]


def slope(points):
    """A second, by Theil and Sen: the median over all pairs, which three outliers in ten do not move."""
    return statistics.median(
        (b[1] - a[1]) / (b[0] - a[0]) for i, a in enumerate(points) for b in points[i + 1 :]
    )
