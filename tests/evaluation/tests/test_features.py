import unittest

import numpy

from saliency import features

from . import displays


def pixel(*rgb):
    return numpy.array([[rgb]], numpy.float32)


def one_bar(angle_deg):
    picture = displays.blank(65)
    displays.bar(angle_deg, length=200, width=3)(picture, (32, 32))
    return features.intensity(displays.as_picture(picture))


class Colour(unittest.TestCase):
    def test_opponents_of_pure_colours(self):
        for rgb, red_green, blue_yellow in (
            ((1, 0, 0), 1, 0),
            ((0, 1, 0), -1, 0),
            ((0, 0, 1), 0, 1),
            ((1, 1, 0), 0, -1),
            ((0.4, 0.4, 0.4), 0, 0),
        ):
            self.assertAlmostEqual(features.red_green(pixel(*rgb))[0, 0], red_green, places=6)
            self.assertAlmostEqual(features.blue_yellow(pixel(*rgb))[0, 0], blue_yellow, places=6)

    def test_hue_does_not_change_with_the_light(self):
        bright, dim = pixel(0.9, 0.5, 0.3), pixel(0.45, 0.25, 0.15)
        self.assertAlmostEqual(
            features.red_green(bright)[0, 0], features.red_green(dim)[0, 0], places=6
        )
        self.assertAlmostEqual(
            features.blue_yellow(bright)[0, 0], features.blue_yellow(dim)[0, 0], places=6
        )

    def test_too_dark_for_a_hue(self):
        self.assertEqual(features.red_green(pixel(0.09, 0, 0))[0, 0], 0)
        self.assertEqual(features.blue_yellow(pixel(0, 0, 0.09))[0, 0], 0)


class Orientation(unittest.TestCase):
    def test_kernels_have_mean_zero_and_norm_one(self):
        for angle in features.ORIENTATIONS_DEG:
            for phase in (0, 90):
                kernel = features.gabor(angle, phase)
                self.assertAlmostEqual(kernel.mean(), 0, places=12)
                self.assertAlmostEqual((kernel**2).sum(), 1, places=12)

    def test_even_area_gives_no_answer(self):
        even = numpy.full((40, 40), 0.7, numpy.float32)
        for angle in features.ORIENTATIONS_DEG:
            self.assertLess(features.orientation_energy(even, angle).max(), 1e-5)

    def test_a_bar_answers_its_own_orientation_most(self):
        for shown in features.ORIENTATIONS_DEG:
            plane = one_bar(shown)
            answers = {
                angle: features.orientation_energy(plane, angle)[32, 32]
                for angle in features.ORIENTATIONS_DEG
            }
            self.assertEqual(max(answers, key=answers.get), shown)
            self.assertGreater(answers[shown], 5 * answers[(shown + 90) % 180])
