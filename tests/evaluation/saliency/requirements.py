"""An inequality that must hold, as a paired comparison over units."""
from dataclasses import dataclass

import numpy

from . import statistics


@dataclass(frozen=True)
class Requirement:
    """text: "x > y". mean: of x - y over the units, with 95 % intervals of the units at hand and
    with data sets as the sampled unit; None where there are no units. p is one-sided."""

    text: str
    units: int
    mean: float | None
    units_interval: tuple | None
    clustered_interval: tuple | None
    sign_flip_p: float | None

    @property
    def holds(self):
        """Beyond chance: the whole interval lies above 0. Without units nothing holds."""
        return self.units > 0 and self.units_interval[0] > 0


def require(text, values, data_sets, seed=0):
    """values: (what must be larger, what must be smaller) of each unit; data_sets: the units'."""
    if not values:
        return Requirement(text, 0, None, None, None, None)
    differences = -numpy.diff(numpy.asarray(values, float), axis=1)[:, 0]
    return Requirement(
        text,
        len(differences),
        float(differences.mean()),
        statistics.bootstrap_interval(differences, seed),
        statistics.clustered_bootstrap_interval(differences, data_sets, seed),
        statistics.sign_flip_p(differences, seed),
    )
