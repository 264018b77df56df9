import unittest

import numpy

from saliency import normalisation
from saliency.normalisation import PEAK, iterative, single_pass


def peaks(*heights):
    plane = numpy.zeros((64, 64), numpy.float32)
    for place, height in enumerate(heights):
        plane[10 + 12 * place, 10 + 12 * place] = height
    return plane


class SinglePass(unittest.TestCase):
    def test_one_peak_is_multiplied_by_m_squared(self):
        self.assertAlmostEqual(single_pass(peaks(0.3)).max(), PEAK * PEAK**2, places=3)

    def test_two_equal_peaks_give_nothing(self):
        self.assertEqual(single_pass(peaks(0.3, 0.3)).max(), 0)

    def test_three_peaks(self):
        # Scaled to 10, 5 and 2: the others' mean is 3.5.
        self.assertAlmostEqual(
            single_pass(peaks(1, 0.5, 0.2)).max(), 10 * (10 - 3.5) ** 2, places=3
        )

    def test_peaks_under_a_tenth_do_not_count(self):
        self.assertAlmostEqual(single_pass(peaks(1, 0.09)).max(), 1000, places=3)

    def test_a_plateau_counts_once(self):
        plane = peaks(1)
        plane[30:33, 40:45] = 0.5
        self.assertEqual(len(normalisation.local_maxima(plane, 0.1)), 2)


class Iterative(unittest.TestCase):
    def test_even_map_gives_nothing(self):
        for value in (0, 0.4, 1):
            self.assertEqual(iterative(numpy.full((40, 50), value, numpy.float32)).max(), 0)

    def test_rounding_errors_are_not_blown_up(self):
        noise = 1e-5 * numpy.random.default_rng(1).random((50, 50), numpy.float32)
        self.assertEqual(iterative(noise).max(), 0)
        self.assertEqual(single_pass(noise).max(), 0)

    def test_the_scale_of_a_map_does_not_matter(self):
        plane = numpy.random.default_rng(2).random((50, 60), numpy.float32)
        numpy.testing.assert_allclose(
            iterative(plane), iterative(0.01 * plane), rtol=1e-3, atol=1e-4
        )

    def test_a_strong_peak_gains_on_many_weak_ones(self):
        plane = numpy.zeros((64, 64), numpy.float32)
        plane[::4, ::4] = 0.3
        plane[20, 40] = 1
        result = iterative(plane)
        self.assertEqual(numpy.unravel_index(result.argmax(), result.shape), (20, 40))
        self.assertLess(numpy.delete(result.ravel(), 20 * 64 + 40).max(), 0.2 * result.max())

    def test_the_spread_keeps_an_even_map_even_up_to_the_border(self):
        even = numpy.ones((40, 50), numpy.float32)
        numpy.testing.assert_allclose(normalisation._spread(even, 10, 1.5), 2.25, rtol=1e-5)
