"""The designed experiment: does the illustration style draw the eye to the focus, more than Phong
shading of the same cutaway?

A unit is one data set, camera and lens position; each is rendered in every condition and scored
with one and the same focus mask.
"""
from collections import Counter
from dataclasses import asdict, dataclass

import numpy

from . import statistics
from .metrics import HIT_RANKS, Scores

CONDITIONS = {
    "A": "illustration style with cutaway",
    "B": "Phong shading with the same cutaway",
    "C": "Phong shading without a lens",
    "D": "style with focus and context swapped",
}
CONTRASTS = (
    ("A", "B"),
    ("A", "C"),
    ("D", "B"),
)  # the first decides; the last must have the opposite sign
MEASURES = ("nss", "auc", "mass_ratio")  # the first decides
HITS = {
    "first_hit": "the first winner lies in the focus",
    "proto_object_hit": "most of the first winner's region lies in the focus",
    "any_hit": f"one of the first {HIT_RANKS} winners lies in the focus",
}  # the first decides nothing, and is what the dissertation looked at
UNITS_PER_DATA_SET = 12
DATA_SETS = 3


@dataclass(frozen=True)
class Observation:
    """One picture's scores under one model. unit: camera and lens position, unique within its data
    set."""

    data_set: str
    unit: str
    condition: str
    model: str
    scores: Scores


@dataclass(frozen=True)
class Comparison:
    """Paired differences first - second of one measure over all units, with their uncertainty.
    Intervals are 95 %; all p are one-sided for "first is larger". units_*: of the sample at hand.
    clustered_*: data sets as the sampled unit."""

    first: str
    second: str
    measure: str
    units: int
    units_by_data_set: dict
    mean: float
    units_interval: tuple
    clustered_interval: tuple
    sign_flip_p: float
    clustered_sign_flip_p: float
    wilcoxon_p: float
    cliffs_delta: float
    standardised_mean: float | None
    share_positive: float

    @property
    def data_sets(self):
        return len(self.units_by_data_set)


@dataclass(frozen=True)
class HitComparison:
    """One of HITS: units hit in both, in one only, in neither; exact McNemar, one-sided for "first
    hits more"."""

    first: str
    second: str
    hit: str
    both: int
    only_first: int
    only_second: int
    neither: int
    mcnemar_p: float


@dataclass(frozen=True)
class ModelResult:
    """means[condition][measure]; comparisons["A-B", "nss"]; hits["A-B", "first_hit"];
    hit_rates[condition]["first_hit"]. hit_ranks[condition]: units whose first winner in the focus
    is the first, the second, ... and last those where none of them is."""

    model: str
    means: dict
    hit_rates: dict
    hit_ranks: dict
    comparisons: dict
    hits: dict

    def as_dict(self):
        """Plain values for JSON."""
        plain = asdict(self)
        plain["comparisons"] = [asdict(comparison) for comparison in self.comparisons.values()]
        plain["hits"] = [asdict(hits) for hits in self.hits.values()]
        return plain


def analyse(observations, seed=0):
    """{model: ModelResult} of observations. ValueError where a unit lacks a condition that another
    unit has, or has it twice."""
    return {
        model: _analyse_model(model, _table(observations, model), seed)
        for model in _models(observations)
    }


def _analyse_model(model, table, seed):
    present = [condition for condition in CONDITIONS if condition in next(iter(table.values()))]
    contrasts = [pair for pair in CONTRASTS if set(pair) <= set(present)]
    return ModelResult(
        model,
        {condition: _column_means(table, condition, MEASURES) for condition in present},
        {condition: _column_means(table, condition, HITS) for condition in present},
        {condition: _hit_ranks(table, condition) for condition in present},
        {
            (f"{a}-{b}", measure): compare(table, a, b, measure, seed)
            for a, b in contrasts
            for measure in MEASURES
        },
        {(f"{a}-{b}", hit): compare_hits(table, a, b, hit) for a, b in contrasts for hit in HITS},
    )


def compare(table, first, second, measure, seed=0):
    """Comparison of two conditions. table: {(data set, unit): {condition: Scores}}."""
    before, after = _column(table, second, measure), _column(table, first, measure)
    differences = after - before
    clusters = [data_set for data_set, _ in table]
    return Comparison(
        first=first,
        second=second,
        measure=measure,
        units=len(table),
        units_by_data_set=dict(Counter(clusters)),
        mean=float(differences.mean()),
        units_interval=statistics.bootstrap_interval(differences, seed),
        clustered_interval=statistics.clustered_bootstrap_interval(differences, clusters, seed),
        sign_flip_p=statistics.sign_flip_p(differences, seed),
        clustered_sign_flip_p=statistics.clustered_sign_flip_p(differences, clusters, seed),
        wilcoxon_p=statistics.wilcoxon_p(differences),
        cliffs_delta=statistics.cliffs_delta(after, before),
        standardised_mean=statistics.standardised_mean(differences),
        share_positive=float((differences > 0).mean()),
    )


def compare_hits(table, first, second, hit):
    """HitComparison of two conditions."""
    a, b = (_column(table, condition, hit).astype(bool) for condition in (first, second))
    counts = (int(which.sum()) for which in (a & b, a & ~b, ~a & b, ~a & ~b))
    return HitComparison(first, second, hit, *counts, statistics.mcnemar_p(a, b))


def _models(observations):
    return list(dict.fromkeys(observation.model for observation in observations))


def _table(observations, model):
    """{(data set, unit): {condition: Scores}}, sorted, so that the order of rendering does not
    change a resample."""
    table = {}
    for observation in sorted(
        (o for o in observations if o.model == model), key=lambda o: (o.data_set, o.unit)
    ):
        row = table.setdefault((observation.data_set, observation.unit), {})
        if observation.condition not in CONDITIONS or observation.condition in row:
            raise ValueError(
                f"{observation.data_set}, {observation.unit}: "
                f"condition {observation.condition} is unknown or double"
            )
        row[observation.condition] = observation.scores
    wanted = set().union(*(row.keys() for row in table.values()))
    for (data_set, unit), row in table.items():
        if row.keys() != wanted:
            raise ValueError(
                f"{data_set}, {unit}: lacks condition {', '.join(sorted(wanted - row.keys()))}"
            )
    return table


def _column_means(table, condition, measures):
    return {measure: float(_column(table, condition, measure).mean()) for measure in measures}


def _hit_ranks(table, condition):
    ranks = [row[condition].hit_rank for row in table.values()]
    return [ranks.count(rank) for rank in (*range(1, HIT_RANKS + 1), None)]


def _column(table, condition, measure):
    return numpy.array([getattr(row[condition], measure) for row in table.values()], float)
