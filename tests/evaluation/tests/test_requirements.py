import unittest

import numpy

import controls
from controls import Reading
from saliency import PRIMARY, SECOND_OPINION, analyse, judge
from saliency.experiment import CONDITIONS
from saliency.requirements import require

from .test_experiment import observations


def readings(units=12, unmovable=(), gain=1.0, seed=1):
    """One {condition: Reading} a unit; the focus of some has nowhere to go."""
    generator = numpy.random.default_rng(seed)
    for unit in range(units):
        stays = unit in unmovable
        yield {
            condition: Reading(
                nss=100.0 if stays else gain + generator.normal(0, 0.1),
                nss_elsewhere=None if stays else generator.normal(0, 0.1),
                detail_focus={"A": 0.5}.get(condition, 0.3) + generator.normal(0, 0.01),
                detail_context={"A": 0.1}.get(condition, 0.3) + generator.normal(0, 0.01),
            )
            for condition in CONDITIONS
        }


class Requirements(unittest.TestCase):
    def test_it_holds_where_the_whole_interval_lies_above_zero(self):
        clearly = require("x > y", [(2, 1.0 + 0.1 * n) for n in range(6)], list("aabbcc"))
        self.assertTrue(clearly.holds)
        self.assertAlmostEqual(clearly.mean, 0.75)
        self.assertEqual(clearly.units, 6)
        hardly = require("x > y", [(2, 1), (1, 2), (3, 1), (1, 2)], list("aabb"))
        self.assertGreater(hardly.mean, 0)
        self.assertFalse(hardly.holds)

    def test_without_units_nothing_holds(self):
        self.assertFalse(require("x > y", [], []).holds)

    def test_each_required_inequality_is_stated(self):
        told = controls.requirements(list(readings()), ["head"] * 12)
        self.assertEqual([r.holds for r in told], [True, True, True])
        self.assertAlmostEqual(told[0].mean, 1.0, delta=0.1)
        self.assertAlmostEqual(told[1].mean, 0.2, delta=0.02)
        self.assertAlmostEqual(told[2].mean, 0.2, delta=0.02)

    def test_both_nss_are_of_the_same_units(self):
        some = list(readings(unmovable=(3, 7)))
        self.assertEqual(controls.requirements(some, ["head"] * 12)[0].units, 10)
        control = controls.means(some)[0]
        self.assertEqual(control.movable_units, 10)
        self.assertAlmostEqual(control.nss, 1.0, delta=0.1)
        self.assertAlmostEqual(control.nss_elsewhere, 0.0, delta=0.1)

    def test_a_focus_that_can_never_be_moved_is_told(self):
        some = list(readings(units=2, unmovable=(0, 1)))
        self.assertEqual(controls.requirements(some, ["head"] * 2)[0].units, 0)
        self.assertEqual(controls.means(some)[0].movable_units, 0)

    def test_the_verdict_names_what_is_not_shown(self):
        results = analyse([o for o in observations(0.5) if o.model in (PRIMARY, SECOND_OPINION)])
        met = controls.requirements(list(readings()), ["head"] * 12)
        unmet = controls.requirements(list(readings(gain=-1)), ["head"] * 12)
        self.assertNotIn("Required", judge(results, met).text)
        self.assertIn(
            "Required and not shown: A: NSS on the focus > NSS on it moved elsewhere, "
            "the difference is -1.",
            judge(results, unmet).text,
        )
