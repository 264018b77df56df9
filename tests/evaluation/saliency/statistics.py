"""Paired statistics with known assumptions, deterministic for a given seed. Differences are 1-D
arrays, one number a unit.

Sources: E. J. G. Pitman, "Significance Tests which May be Applied to Samples from any Populations",
1937 (sign flips); B. Efron, R. Tibshirani, "An Introduction to the Bootstrap", 1993, chapter 13
(percentile interval); N. Cliff, "Dominance Statistics", 1993; Q. McNemar, 1947, in its exact
binomial form.
"""
import numpy
import scipy.stats

EXACT_UP_TO = 16  # units: all 2^n flips are tried; beyond, RANDOM_FLIPS of them
RANDOM_FLIPS = 100_000
RESAMPLES = 10_000
CONFIDENCE = 0.95
ROUNDING = 1e-12  # relative: equal sums that were added in another order are ties


def sign_flip_p(differences, seed=0):
    """One-sided p of "the differences are symmetric about a value <= 0", by flipping signs; the
    statistic is their mean."""
    differences = numpy.asarray(differences, float)
    count = len(differences)
    at_least = differences.sum() - ROUNDING * numpy.abs(differences).sum()
    if count <= EXACT_UP_TO:
        codes = numpy.arange(2**count)[:, None]
        signs = 1 - 2 * ((codes >> numpy.arange(count)) & 1)
        return float((signs @ differences >= at_least).mean())
    generator = numpy.random.default_rng(seed)
    signs = 1 - 2 * generator.integers(0, 2, (RANDOM_FLIPS, count), dtype=numpy.int8)
    as_large = (signs @ differences >= at_least).sum()
    return float((as_large + 1) / (RANDOM_FLIPS + 1))


def clustered_sign_flip_p(differences, clusters, seed=0):
    """The same with whole clusters flipped: units of one data set count as one witness. k clusters
    give p >= 2^-k."""
    return sign_flip_p(_cluster_sums(differences, clusters)[0], seed)


def wilcoxon_p(differences):
    """One-sided signed-rank p of "the median is <= 0"; zeros are left out, and all zeros give 1."""
    if not numpy.any(differences):
        return 1.0
    return float(scipy.stats.wilcoxon(differences, alternative="greater").pvalue)


def bootstrap_interval(differences, seed=0):
    """95 % percentile interval of the mean, units drawn with replacement: (low, high)."""
    differences = numpy.asarray(differences, float)
    drawn = numpy.random.default_rng(seed).integers(
        0, len(differences), (RESAMPLES, len(differences))
    )
    return _percentiles(differences[drawn].mean(axis=1))


def clustered_bootstrap_interval(differences, clusters, seed=0):
    """95 % percentile interval of the mean, whole clusters drawn with replacement: how far it
    carries beyond these data sets. With fewer than about five clusters it is rough and too narrow.
    """
    sums, sizes = _cluster_sums(differences, clusters)
    drawn = numpy.random.default_rng(seed).integers(0, len(sums), (RESAMPLES, len(sums)))
    return _percentiles(sums[drawn].sum(axis=1) / sizes[drawn].sum(axis=1))


def cliffs_delta(first, second):
    """P(first > second) - P(first < second) over all pairs, in [-1, 1]."""
    first, second = numpy.asarray(first, float), numpy.asarray(second, float)
    return float(numpy.sign(first[:, None] - second).mean())


def standardised_mean(differences):
    """Mean over standard deviation (Cohen's d for pairs); None where all are equal."""
    deviation = numpy.std(differences, ddof=1) if len(differences) > 1 else 0.0
    return float(numpy.mean(differences) / deviation) if deviation > 0 else None


def mcnemar_p(first, second):
    """One-sided exact p of "first hits no more often than second", from pairs of bools; 1 where no
    pair differs."""
    first, second = numpy.asarray(first, bool), numpy.asarray(second, bool)
    only_first, only_second = int((first & ~second).sum()), int((~first & second).sum())
    differing = only_first + only_second
    return float(scipy.stats.binom.sf(only_first - 1, differing, 0.5)) if differing else 1.0


def _cluster_sums(differences, clusters):
    _, index = numpy.unique(numpy.asarray(clusters), return_inverse=True)
    return numpy.bincount(index, weights=numpy.asarray(differences, float)), numpy.bincount(index)


def _percentiles(means):
    tail = (1 - CONFIDENCE) / 2
    low, high = numpy.quantile(means, (tail, 1 - tail))
    return float(low), float(high)
