import json
import math
import unittest

import controls
import extent
import report
from report_saliency import saliency_study as page
from saliency import PRIMARY, SECOND_OPINION, analyse, judge
from saliency_study import Study

from .test_experiment import observations
from .test_requirements import readings


def study(unmovable=()):
    some = list(readings(units=36, unmovable=unmovable))
    data_sets = [f"volume {n // 12}" for n in range(36)]
    results = analyse(list(observations(0.5)))
    requirements = controls.requirements(some, data_sets)
    return Study(
        results,
        judge(results, requirements),
        controls.means(some),
        requirements,
        [("volume 0", "winners.png")],
        [("a <b> & c", [None] * 7)],
    )


class Page(unittest.TestCase):
    def test_it_tells_hits_ranks_requirements_and_the_sample(self):
        text = "".join(page(study()))
        for told in (
            "most of the first winner&#x27;s region lies in the focus",
            "units by the rank of the first winner in the focus",
            "A: NSS on the focus &gt; NSS on it moved elsewhere",
            "detail in the context: B &gt; A",
            "<td>volume 2</td><td>12 of 12</td>",
            "<td>a &lt;b&gt; &amp; c</td><td>7 of 12</td><td>passed over",
        ):
            self.assertIn(told, text)
        self.assertEqual(text.count("<td>holds</td>"), 3)
        self.assertEqual(
            text.count(f"<h3>{PRIMARY}</h3>") + text.count(SECOND_OPINION + "</h3>"), 2
        )

    def test_a_focus_that_can_never_be_moved_leaves_a_page(self):
        self.assertIn("no unit tells", "".join(page(study(unmovable=range(36)))))

    def test_only_the_quick_form_says_that_it_is_one(self):
        self.assertIn("The quick form", "".join(report._extent(extent.QUICK)))
        self.assertEqual("".join(report._extent(extent.FULL)), "")

    def test_the_figures_are_plain_values(self):
        plain = json.loads(json.dumps(report._plain(study())))
        self.assertEqual([r["holds"] for r in plain["requirements"]], [True] * 3)
        self.assertTrue(all(math.isfinite(r["mean"]) for r in plain["requirements"]))
