"""What the experiment's numbers allow to be said, favourable or not.

The claim is accepted when the illustration (A) beats Phong shading of the same cutaway (B) in NSS,
the interval's lower end above 0, under the primary model and under one other kind of map, and when
the swapped style (D) falls below B under both, the interval's upper end below 0: a swapped style
that is not told from B says nothing about the style's place.
"""
from dataclasses import dataclass

from .experiment import CONDITIONS, DATA_SETS, UNITS_PER_DATA_SET
from .models import PRIMARY, SECOND_OPINION, SINGLE_PASS

DECISIVE = ("A-B", "nss")
CONTROL = ("D-B", "nss")
ALPHA = 0.05
HEADLINES = {
    "supported": "Supported: the style draws saliency to the focus, more than Phong shading of the "
    "same cutaway does.",
    "not shown": "Not shown: these pictures do not establish that the style draws saliency to the "
    "focus.",
    "contradicted": "Contradicted: the style draws less saliency to the focus than Phong shading "
    "of the same cutaway does.",
}


@dataclass(frozen=True)
class Verdict:
    """outcome: "supported", "not shown" or "contradicted". reasons: what decided. caveats: what
    limits it. All are sentences."""

    outcome: str
    reasons: list
    caveats: list

    @property
    def text(self):
        return "\n".join([HEADLINES[self.outcome], *self.reasons, *self.caveats])


def judge(results, requirements=()):
    """Verdict on analyse(...)'s {model: ModelResult}; both PRIMARY and SECOND_OPINION must be
    there, with A, B and D. requirements: Requirements to name where they do not hold."""
    comparisons = {
        model: results[model].comparisons[DECISIVE] for model in (PRIMARY, SECOND_OPINION)
    }
    controls = {model: results[model].comparisons[CONTROL] for model in (PRIMARY, SECOND_OPINION)}
    reasons = [_sentence(model, comparison) for model, comparison in comparisons.items()]
    reasons += [_control_sentence(model, control) for model, control in controls.items()]
    caveats = _caveats(results, comparisons[PRIMARY]) + _unmet(requirements)
    return Verdict(_outcome(comparisons, controls), reasons, caveats)


def _outcome(comparisons, controls):
    if comparisons[PRIMARY].units_interval[1] < 0:
        return "contradicted"
    both_above = all(comparison.units_interval[0] > 0 for comparison in comparisons.values())
    turned = all(control.units_interval[1] < 0 for control in controls.values())
    return "supported" if both_above and turned else "not shown"


def _sentence(model, c):
    return (
        f"{model}: NSS of {c.first} minus {c.second} is {_figure(c.mean, c.units_interval)} "
        f"over {c.units} units ({c.share_positive:.0%} of them positive, "
        f"sign-flip p = {c.sign_flip_p:.2g}, Cliff's delta {c.cliffs_delta:+.2f}): "
        f"{_direction(c.units_interval)}."
    )


def _control_sentence(model, control):
    figure = _figure(control.mean, control.units_interval)
    return f"{model}: the swapped style minus B is {figure}, which {_turn(control.units_interval)}."


def _turn(interval):
    if interval[1] < 0:
        return "turns the sign, as it should"
    if interval[0] > 0:
        return "does not turn the sign: the gain is not the style's place"
    return "is not distinguishable from B: it does not support the claim"


def _direction(interval):
    if interval[0] > 0:
        return "more than chance would give"
    if interval[1] < 0:
        return "less, and more than chance would give"
    return "within chance"


def _figure(mean, interval, form="+.3f"):
    return f"{mean:{form}} (95 % interval {interval[0]:{form}} to {interval[1]:{form}})"


def _caveats(results, decisive):
    return [
        sentence
        for sentence in (
            _size(decisive.units_by_data_set),
            _single_pass(results),
            _reach(decisive),
            _p_value(decisive),
            _hits(results),
            _lens(results),
        )
        if sentence
    ]


def _size(units_by_data_set):
    """Set by set: a sum would let one with many units hide one with few."""
    short = [
        f"{data_set}: {units} of {UNITS_PER_DATA_SET} units"
        for data_set, units in units_by_data_set.items()
        if units < UNITS_PER_DATA_SET
    ]
    if len(units_by_data_set) < DATA_SETS:
        short.append(f"{len(units_by_data_set)} of {DATA_SETS} data sets")
    return f"The sample is smaller than planned: {', '.join(short)}." if short else None


def _single_pass(results):
    """The other normalisation does not decide, but where it says something else it must be said."""
    if SINGLE_PASS not in results:
        return None
    told = [
        f"{c.first} minus {c.second} is {_figure(c.mean, c.units_interval)}"
        for key, c in results[SINGLE_PASS].comparisons.items()
        if key in (DECISIVE, CONTROL)
        and _direction(c.units_interval)
        != _direction(results[PRIMARY].comparisons[key].units_interval)
    ]
    return f"{SINGLE_PASS} disagrees with {PRIMARY}: {' and '.join(told)}." if told else None


def _reach(c):
    """Units of one data set resemble each other; only a clustered test speaks about data sets that
    were not rendered."""
    if c.clustered_sign_flip_p < ALPHA:
        return (
            f"It also holds with data sets as the sampled unit (p = {c.clustered_sign_flip_p:.2g})."
        )
    floor = 2.0**-c.data_sets
    limit = f" {c.data_sets} data sets cannot give less than {floor:.2g}." if floor >= ALPHA else ""
    p = f"clustered sign-flip p = {c.clustered_sign_flip_p:.2g}"
    return f"Nothing is shown about other data sets ({p}).{limit}"


def _p_value(c):
    if (c.units_interval[0] > 0) == (c.sign_flip_p < ALPHA):
        return None
    p = f"p = {c.sign_flip_p:.2g}"
    return f"The interval and the sign-flip test ({p}) disagree: read the effect as borderline."


def _unmet(requirements):
    return [f"Required and not shown: {_requirement(r)}." for r in requirements if not r.holds]


def _requirement(r):
    if r.units == 0:
        return f"{r.text} (no unit tells)"
    return f"{r.text}, the difference is {_figure(r.mean, r.units_interval, '+.4f')}"


def _hits(results):
    hits, rates = results[PRIMARY].hits["A-B", "first_hit"], results[PRIMARY].hit_rates
    return (
        f"The first winner lies in the focus in {rates['A']['first_hit']:.0%} of A "
        f"and {rates['B']['first_hit']:.0%} of B "
        f"(McNemar p = {hits.mcnemar_p:.2g} "
        f"from {hits.only_first + hits.only_second} differing units)."
    )


def _lens(results):
    comparison = results[PRIMARY].comparisons.get(("A-C", "nss"))
    if comparison is None:
        return None
    figure = _figure(comparison.mean, comparison.units_interval)
    return (
        f"Against {CONDITIONS['C']} the difference is {figure}; "
        "it holds the lens and the style together."
    )
