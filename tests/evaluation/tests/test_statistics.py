import unittest

import numpy

from saliency import statistics


def normal(count, mean=0.0, seed=1):
    return numpy.random.default_rng(seed).normal(mean, 1, count)


class SignFlip(unittest.TestCase):
    def test_all_positive_gives_the_smallest_p(self):
        for count in (1, 3, 5, 10, 16):
            self.assertEqual(statistics.sign_flip_p(numpy.arange(1, count + 1)), 2.0**-count)

    def test_by_hand(self):
        # Of the eight sums of +-1 +-2 +-3, those >= -1 + 2 + 3 = 4 are 6 and 4.
        self.assertEqual(statistics.sign_flip_p([-1, 2, 3]), 2 / 8)

    def test_no_difference_gives_one(self):
        self.assertEqual(statistics.sign_flip_p(numpy.zeros(8)), 1)

    def test_equal_sums_count_as_ties(self):
        self.assertEqual(statistics.sign_flip_p([0.1, 0.2, 0.3]), 1 / 8)
        self.assertEqual(statistics.sign_flip_p([0.1, 0.2, -0.3]), 5 / 8)

    def test_random_flips_agree_with_the_normal_limit(self):
        differences = normal(60, 0.2)
        z = differences.sum() / numpy.sqrt((differences**2).sum())
        self.assertAlmostEqual(
            statistics.sign_flip_p(differences), statistics.scipy.stats.norm.sf(z), delta=0.01
        )

    def test_random_flips_never_give_zero(self):
        self.assertEqual(statistics.sign_flip_p(numpy.ones(40)), 1 / 100_001)

    def test_clusters_bound_p_from_below(self):
        for clusters, least in ((3, 1 / 8), (5, 1 / 32)):
            names = numpy.repeat([f"volume {n}" for n in range(clusters)], 12)
            self.assertEqual(
                statistics.clustered_sign_flip_p(numpy.ones(12 * clusters), names), least
            )

    def test_it_keeps_its_level(self):
        rejected = [statistics.sign_flip_p(normal(10, 0, seed)) <= 0.05 for seed in range(600)]
        self.assertAlmostEqual(numpy.mean(rejected), 0.05, delta=0.027)  # three standard errors

    def test_it_has_power(self):
        rejected = [statistics.sign_flip_p(normal(12, 1, seed)) <= 0.05 for seed in range(100)]
        self.assertGreater(numpy.mean(rejected), 0.85)


class Bootstrap(unittest.TestCase):
    def test_width_is_that_of_the_normal_interval(self):
        values = normal(100, 3)
        low, high = statistics.bootstrap_interval(values)
        reach = 1.96 * values.std() / 10
        self.assertAlmostEqual(low, values.mean() - reach, delta=0.03)
        self.assertAlmostEqual(high, values.mean() + reach, delta=0.03)

    def test_it_covers_the_truth_about_as_often_as_it_says(self):
        intervals = [statistics.bootstrap_interval(normal(36, 0.5, seed)) for seed in range(150)]
        self.assertGreater(numpy.mean([low < 0.5 < high for low, high in intervals]), 0.88)

    def test_the_seed_decides(self):
        values = normal(30)
        self.assertEqual(
            statistics.bootstrap_interval(values, 4), statistics.bootstrap_interval(values, 4)
        )
        self.assertNotEqual(
            statistics.bootstrap_interval(values, 4), statistics.bootstrap_interval(values, 5)
        )

    def test_equal_values_have_no_width(self):
        self.assertEqual(statistics.bootstrap_interval(numpy.full(9, 2.0)), (2, 2))

    def test_clusters_that_differ_widen_it(self):
        clusters = numpy.repeat(["a", "b", "c", "d"], 10)
        values = normal(40) * 0.1 + numpy.repeat([0, 1, 2, 3], 10)
        low, high = statistics.bootstrap_interval(values)
        wide_low, wide_high = statistics.clustered_bootstrap_interval(values, clusters)
        self.assertGreater(wide_high - wide_low, 2 * (high - low))

    def test_clusters_of_one_unit_are_units(self):
        values = normal(12)
        one_each = statistics.clustered_bootstrap_interval(values, [f"{n:02}" for n in range(12)])
        numpy.testing.assert_allclose(one_each, statistics.bootstrap_interval(values))


class Effects(unittest.TestCase):
    def test_cliffs_delta(self):
        self.assertEqual(statistics.cliffs_delta([4, 5], [1, 2, 3]), 1)
        self.assertEqual(statistics.cliffs_delta([1, 2], [1, 2]), 0)
        self.assertEqual(statistics.cliffs_delta([1, 3], [2]), 0)
        self.assertAlmostEqual(statistics.cliffs_delta([1, 2, 3], [2]), 0)
        self.assertAlmostEqual(statistics.cliffs_delta([1, 1, 3], [2]), -1 / 3)

    def test_standardised_mean(self):
        self.assertAlmostEqual(statistics.standardised_mean([1, 2, 3]), 2)
        self.assertIsNone(statistics.standardised_mean([2, 2]))
        self.assertIsNone(statistics.standardised_mean([2]))


class McNemar(unittest.TestCase):
    def test_only_pairs_that_differ_count(self):
        first = [True] * 5 + [True] * 7 + [False] * 9
        second = [False] * 5 + [True] * 7 + [False] * 9
        self.assertAlmostEqual(statistics.mcnemar_p(first, second), 1 / 32)
        self.assertAlmostEqual(statistics.mcnemar_p(second, first), 1)

    def test_by_hand(self):
        # Three against one: P(at least 3 of 4) = 5/16.
        self.assertAlmostEqual(statistics.mcnemar_p([1, 1, 1, 0], [0, 0, 0, 1]), 5 / 16)

    def test_no_difference_gives_one(self):
        self.assertEqual(statistics.mcnemar_p([True, False], [True, False]), 1)


class Wilcoxon(unittest.TestCase):
    def test_all_positive(self):
        self.assertAlmostEqual(statistics.wilcoxon_p([1, 2, 3, 4, 5]), 1 / 32)
        self.assertEqual(statistics.wilcoxon_p(numpy.zeros(4)), 1)
