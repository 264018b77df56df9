"""The report's part on saliency."""
from html import escape

from html_table import table, yes_no
from saliency.experiment import HITS, UNITS_PER_DATA_SET
from saliency.metrics import HIT_RANKS


def saliency_study(study):
    yield "<h2>Saliency</h2>"
    yield f'<p class="verdict">{escape(study.verdict.text)}</p>'
    yield (
        "<p>Condition A is the flagship as it is shipped: ramp from cool to warm, occlusion, shadow, a wall with a tone of its "
        "own, lines by depth. B, and D with the branches swapped, cut the same away with the same funnel.</p>"
    )
    yield from _sample(study)
    for model, result in study.results.items():
        yield f"<h3>{escape(model)}</h3>"
        yield from _measures(result)
        yield from _hits(result)
    yield from _requirements(study)
    yield from _sheets(study)


def _sample(study):
    comparison = next(iter(next(iter(study.results.values())).comparisons.values()))
    rows = [
        (volume, f"{units} of {UNITS_PER_DATA_SET}", "studied")
        for volume, units in comparison.units_by_data_set.items()
    ]
    rows += [
        (volume, f"{len(units)} of {UNITS_PER_DATA_SET}", "passed over for another with enough")
        for volume, units in study.passed_over
    ]
    yield table(("data set", "units", ""), rows)


def _measures(result):
    yield table(
        ("condition", "NSS", "AUC", "mass ratio"),
        [
            (c, *(f"{means[k]:.3f}" for k in ("nss", "auc", "mass_ratio")))
            for c, means in result.means.items()
        ],
    )
    yield table(
        ("difference of NSS", "mean", "95 % over units", "95 % over data sets", "sign-flip p",
         "the same over data sets", "Wilcoxon p", "Cliff's delta"),
        [_difference(c) for (_, measure), c in result.comparisons.items() if measure == "nss"],
    )  # fmt: skip


def _difference(c):
    return (
        f"{c.first} minus {c.second}", f"{c.mean:+.3f}", _interval(c.units_interval),
        _interval(c.clustered_interval), f"{c.sign_flip_p:.2g}", f"{c.clustered_sign_flip_p:.2g}",
        f"{c.wilcoxon_p:.2g}", f"{c.cliffs_delta:+.2f}",
    )  # fmt: skip


def _hits(result):
    yield table(
        ("condition", *HITS.values()),
        [(c, *(f"{rates[hit]:.0%}" for hit in HITS)) for c, rates in result.hit_rates.items()],
    )
    yield table(
        ("units by the rank of the first winner in the focus", *range(1, HIT_RANKS + 1), "none"),
        [(condition, *ranks) for condition, ranks in result.hit_ranks.items()],
    )
    yield table(
        ("hits, paired", "", "both", "first only", "second only", "neither", "McNemar p"),
        [
            (f"{h.first} against {h.second}", HITS[h.hit], h.both, h.only_first, h.only_second,
             h.neither, f"{h.mcnemar_p:.3g}")
            for h in result.hits.values()
        ],
    )  # fmt: skip


def _requirements(study):
    yield "<h3>Required beside (primary model, paired over units)</h3>"
    yield table(
        ("required", "units", "mean difference", "95 % over units", "95 % over data sets",
         "sign-flip p", ""),
        [_requirement(r) for r in study.requirements],
    )  # fmt: skip
    yield table(
        ("condition", "units whose focus can be moved", "their NSS on the focus",
         "their NSS on it moved elsewhere", "detail in the focus", "detail in the context"),
        [
            (c.condition, c.movable_units, f"{c.nss:.3f}", f"{c.nss_elsewhere:.3f}",
             f"{c.detail_focus:.4f}", f"{c.detail_context:.4f}")
            for c in study.controls
        ],
    )  # fmt: skip


def _requirement(r):
    if r.units == 0:
        return r.text, 0, "", "", "", "", "no unit tells"
    return (
        r.text, r.units, f"{r.mean:+.4f}", _interval(r.units_interval, "+.4f"),
        _interval(r.clustered_interval, "+.4f"), f"{r.sign_flip_p:.2g}", yes_no(r.holds),
    )  # fmt: skip


def _interval(pair, form="+.3f"):
    return f"{pair[0]:{form}} to {pair[1]:{form}}"


def _sheets(study):
    for volume, file in study.sheet_files:
        yield (
            f'<figure><img src="{file}" alt="Most salient regions, {escape(volume)}">'
            f"<figcaption>The most salient regions in order, {escape(volume)}: circles at the winners, "
            "outlines of their proto-objects.</figcaption></figure>"
        )
