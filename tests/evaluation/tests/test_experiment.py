import json
import random
import unittest
from dataclasses import replace

import numpy

from saliency import PRIMARY, SECOND_OPINION, SINGLE_PASS, Observation, analyse, judge
from saliency.experiment import HITS
from saliency.metrics import Scores


def observations(
    effect, swapped=-0.4, data_sets=3, units=12, second_effect=None, spread=0.2, seed=1
):
    """Scores as if A exceeded B by `effect` in NSS under the primary model, and D exceeded B by
    `swapped`."""
    generator = numpy.random.default_rng(seed)
    effects = {PRIMARY: effect, SECOND_OPINION: effect if second_effect is None else second_effect}
    for model, gain in effects.items():
        for data_set in range(data_sets):
            for unit in range(units):
                place = generator.normal(1, 0.5)
                for condition, mean in (("A", gain), ("B", 0), ("C", -0.1), ("D", swapped)):
                    nss = place + mean + generator.normal(0, spread)
                    result = Scores(
                        nss, 0.5 + nss / 10, 1 + nss, nss > 1, nss > 1, 1 if nss > 1 else None
                    )
                    yield Observation(
                        f"volume {data_set}", f"view {unit}", condition, model, result
                    )


def relabelled(some):
    """What the primary model says, as said by its variant."""
    return [replace(o, model=SINGLE_PASS) for o in some if o.model == PRIMARY]


def verdict(*arguments, **named):
    return judge(analyse(list(observations(*arguments, **named))))


class Analysis(unittest.TestCase):
    def test_the_difference_is_found_with_its_sign(self):
        result = analyse(list(observations(0.5)))[PRIMARY]
        better, worse = result.comparisons["A-B", "nss"], result.comparisons["D-B", "nss"]
        self.assertAlmostEqual(better.mean, 0.5, delta=0.15)
        self.assertTrue(better.units_interval[0] < better.mean < better.units_interval[1])
        self.assertAlmostEqual(worse.mean, -0.4, delta=0.15)
        self.assertLess(better.sign_flip_p, 0.001)
        self.assertGreater(worse.sign_flip_p, 0.999)
        self.assertEqual((better.units, better.data_sets), (36, 3))
        self.assertAlmostEqual(
            result.means["A"]["nss"] - result.means["B"]["nss"], better.mean, places=9
        )

    def test_pairing_removes_what_the_place_adds(self):
        comparison = analyse(list(observations(0.15)))[PRIMARY].comparisons["A-B", "nss"]
        self.assertLess(comparison.sign_flip_p, 0.01)
        self.assertLess(comparison.cliffs_delta, 0.5)

    def test_the_hits_add_up(self):
        result = analyse(list(observations(0.5)))[PRIMARY]
        for hit in HITS:
            hits = result.hits["A-B", hit]
            self.assertEqual(hits.both + hits.only_first + hits.only_second + hits.neither, 36)
            self.assertAlmostEqual(result.hit_rates["A"][hit], (hits.both + hits.only_first) / 36)
            self.assertAlmostEqual(result.hit_rates["B"][hit], (hits.both + hits.only_second) / 36)

    def test_each_kind_of_hit_and_each_rank_is_counted_by_itself(self):
        ranks = {"A": (1, 1, 2), "B": (5, None, None)}
        some = [
            Observation("head", f"view {n}", c, PRIMARY, Scores(0, 0.5, 1, r == 1, n == 0, r))
            for c, of_condition in ranks.items()
            for n, r in enumerate(of_condition)
        ]
        result = analyse(some)[PRIMARY]
        self.assertEqual(result.hit_ranks, {"A": [2, 1, 0, 0, 0, 0], "B": [0, 0, 0, 0, 1, 2]})
        rates = result.hit_rates["A"]
        self.assertAlmostEqual(rates["first_hit"], 2 / 3)
        self.assertAlmostEqual(rates["proto_object_hit"], 1 / 3)
        self.assertEqual(rates["any_hit"], 1)
        self.assertEqual(result.hits["A-B", "any_hit"].only_first, 2)
        self.assertEqual(result.hits["A-B", "proto_object_hit"].both, 1)

    def test_the_order_of_observations_does_not_matter(self):
        ordered = list(observations(0.3))
        shuffled = ordered.copy()
        random.Random(5).shuffle(shuffled)
        self.assertEqual(analyse(ordered)[PRIMARY].as_dict(), analyse(shuffled)[PRIMARY].as_dict())

    def test_a_missing_picture_is_named(self):
        some = [
            o
            for o in observations(0.3)
            if (o.data_set, o.unit, o.condition) != ("volume 1", "view 7", "B")
        ]
        with self.assertRaisesRegex(ValueError, "volume 1, view 7: lacks condition B"):
            analyse(some)

    def test_a_double_and_an_unknown_condition_are_refused(self):
        some = list(observations(0.3))
        with self.assertRaisesRegex(ValueError, "volume 0, view 0: condition A"):
            analyse(some + some[:1])
        stray = Observation("volume 0", "view 0", "E", PRIMARY, some[0].scores)
        with self.assertRaisesRegex(ValueError, "condition E"):
            analyse(some + [stray])

    def test_results_are_plain_values(self):
        for result in analyse(list(observations(0.3))).values():
            self.assertEqual(json.loads(json.dumps(result.as_dict()))["model"], result.model)


class Judgement(unittest.TestCase):
    def test_supported(self):
        result = verdict(0.5)
        self.assertEqual(result.outcome, "supported")
        self.assertIn("Supported", result.text)
        self.assertIn("3 data sets cannot give less than 0.12", result.text)

    def test_contradicted(self):
        result = verdict(-0.5)
        self.assertEqual(result.outcome, "contradicted")
        self.assertIn("Contradicted", result.text)

    def test_no_effect_is_not_shown(self):
        self.assertEqual(verdict(0.0).outcome, "not shown")

    def test_the_second_opinion_must_agree(self):
        self.assertEqual(verdict(0.5, second_effect=-0.3).outcome, "not shown")

    def test_the_swapped_style_must_turn_the_sign(self):
        result = verdict(0.5, swapped=0.4)
        self.assertEqual(result.outcome, "not shown")
        self.assertIn("does not turn the sign", result.text)

    def test_a_swapped_style_that_is_not_told_from_the_control_supports_nothing(self):
        result = verdict(0.5, swapped=-0.12)
        control = analyse(list(observations(0.5, swapped=-0.12)))[PRIMARY].comparisons["D-B", "nss"]
        self.assertLess(control.mean, 0)
        self.assertGreater(control.units_interval[1], 0)
        self.assertEqual(result.outcome, "not shown")
        self.assertIn("is not distinguishable from B", result.text)

    def test_many_data_sets_carry_further(self):
        self.assertIn(
            "It also holds with data sets as the sampled unit", verdict(0.5, data_sets=6).text
        )

    def test_a_small_sample_is_owned_up_to(self):
        self.assertIn(
            "smaller than planned: volume 0: 4 of 12 units, volume 1: 4 of 12 units, "
            "2 of 3 data sets.",
            verdict(0.5, data_sets=2, units=4).text,
        )
        self.assertNotIn("smaller than planned", verdict(0.5).text)

    def test_a_set_with_many_units_does_not_hide_one_with_few(self):
        many = [o for o in observations(0.5, units=20) if o.data_set != "volume 1"]
        few = [o for o in observations(0.5, units=7) if o.data_set == "volume 1"]
        self.assertIn(
            "smaller than planned: volume 1: 7 of 12 units.", judge(analyse(many + few)).text
        )

    def test_the_single_pass_is_named_where_it_disagrees(self):
        agrees, disagrees = (
            list(observations(0.5)) + relabelled(observations(0.5, swapped=swapped, seed=2))
            for swapped in (-0.4, 0.4)
        )
        self.assertNotIn("single pass", judge(analyse(agrees)).text)
        result = judge(analyse(disagrees))
        self.assertEqual(result.outcome, "supported")
        self.assertRegex(result.text, "single pass disagrees with .*: D minus B is [+]0.3")
