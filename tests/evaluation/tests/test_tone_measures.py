import unittest

import cv2
import numpy

import tone_measures as measures

SIDE = 200


def flat(level, side=SIDE):
    return numpy.full((side, side, 3), level, numpy.float64)


def disc(radius, side=SIDE, centre=None):
    y, x = numpy.mgrid[:side, :side]
    centre = centre or (side / 2, side / 2)
    return numpy.hypot(x - centre[0], y - centre[1]) < radius


class Tones(unittest.TestCase):
    def test_lightness_is_cie(self):
        grey = numpy.array([[0, 0, 0], [119 / 255] * 3, [1, 1, 1], [1, 0, 0]], float)
        numpy.testing.assert_allclose(measures.lightness(grey), [0, 50.03, 100, 53.2], atol=0.1)

    def test_luma_is_of_the_display_encoded_channels(self):
        self.assertAlmostEqual(measures.luma(numpy.array([0.35, 0.15, 0.55])), 0.2214, 3)

    def test_spread_leaves_out_the_extremes(self):
        self.assertAlmostEqual(measures.spread(numpy.linspace(0, 1, 1001)), 0.9, 6)

    def test_fine_contrast_sees_texture_and_neither_slopes_nor_what_lies_outside(self):
        rng = numpy.random.default_rng(1)
        texture = flat(0.5) + rng.normal(0, 0.1, (SIDE, SIDE, 1))
        mask = disc(60)
        self.assertAlmostEqual(measures.fine_contrast(texture, mask), 0.1, delta=0.01)
        slope = flat(0) + numpy.linspace(0, 1, SIDE)[None, :, None]
        self.assertLess(measures.fine_contrast(slope, mask), 0.005)
        outside = numpy.where(mask[..., None], 0.5, texture)
        self.assertAlmostEqual(measures.fine_contrast(outside, mask), 0, 6)


class Rim(unittest.TestCase):
    def setUp(self):
        self.cavity = disc(50)
        self.skin = disc(90) & ~disc(51)

    def test_its_step_is_that_of_the_two_sides(self):
        rgb = numpy.where(self.cavity[..., None], 0.4, flat(0.7))
        steps = measures.rim_steps(rgb, self.skin, self.cavity)
        self.assertGreater(steps.size, 2 * numpy.pi * 50)
        numpy.testing.assert_allclose(steps, 0.3, atol=1e-9)

    def test_half_a_rim_without_a_step_is_half_of_it(self):
        rgb = flat(0.7)
        rgb[:100][self.cavity[:100]] = 0.4
        steps = measures.rim_steps(rgb, self.skin, self.cavity)
        self.assertAlmostEqual((steps < 4 / 255).mean(), 0.5, delta=0.05)

    def test_a_pale_edge_before_a_dark_wall_is_a_step_whatever_their_mean(self):
        rgb = numpy.where(self.cavity[..., None], 0.6, flat(0.7))
        rgb[self.cavity & ~disc(48.5)] = 0.9
        self.assertGreater(measures.rim_steps(rgb, self.skin, self.cavity).min(), 0.1)

    def test_without_a_cavity_there_is_no_rim(self):
        self.assertEqual(measures.rim_steps(flat(0.7), self.skin, disc(0)).size, 0)


class Boundary(unittest.TestCase):
    def test_length_of_discs_and_lines(self):
        everywhere = numpy.ones((SIDE, SIDE), bool)
        for radius in (10, 30, 80):
            length = measures.boundary_length(disc(radius), everywhere)
            self.assertAlmostEqual(length / (2 * numpy.pi * radius), 1, delta=0.02)

    def test_the_masks_edge_is_no_boundary(self):
        self.assertEqual(measures.boundary_length(disc(50), disc(50)), 0)
        half = numpy.zeros((SIDE, SIDE), bool)
        half[:, :100] = True
        length = measures.boundary_length(disc(50), half)
        self.assertAlmostEqual(length / (numpy.pi * 50), 1, delta=0.03)

    def test_a_ragged_one_is_longer(self):
        rng = numpy.random.default_rng(2)
        noise = cv2.GaussianBlur(rng.normal(0, 1, (SIDE, SIDE)), (0, 0), 1)
        slope = numpy.linspace(-1, 1, SIDE)[None] + 0.3 * noise
        everywhere = numpy.ones((SIDE, SIDE), bool)
        self.assertGreater(measures.boundary_length(slope > 0, everywhere), 1.5 * SIDE)


class Ramp(unittest.TestCase):
    COLOURS = [[0.2, 0.3, 0.5], [0.4, 0.5, 0.6], [0.9, 0.8, 0.6]]

    def test_its_own_colours_are_at_even_places(self):
        places = measures.place_on_ramp(numpy.array(self.COLOURS), self.COLOURS)
        numpy.testing.assert_allclose(places, [0, 0.5, 1], atol=1e-6)

    def test_beyond_its_ends_are_its_ends(self):
        places = measures.place_on_ramp(numpy.array([[0.0, 0.1, 0.3], [1, 1, 0.9]]), self.COLOURS)
        numpy.testing.assert_allclose(places, [0, 1], atol=1e-6)

    def test_oklab_of_white_and_red(self):
        lab = measures.oklab(numpy.array([[1.0, 1, 1], [1, 0, 0]]))
        numpy.testing.assert_allclose(lab, [[1, 0, 0], [0.628, 0.225, 0.126]], atol=1e-3)

    def test_a_place_between_two_colours(self):
        place = measures.place_between(numpy.array([[0.5, 0.5, 0.5]]), (0, 0, 0), (1, 1, 1))
        numpy.testing.assert_allclose(place, [0.5])


def ringed(width_px, side=SIDE, times=1):
    """A ring of ink, anti-aliased."""
    y, x = numpy.mgrid[:side, :side] + 0.5
    away_px = abs(numpy.hypot(x - side / 2, y - side / 2) - 0.4 * side)
    return measures.smaller(numpy.clip((width_px + 1) / 2 - away_px, 0, min(1, width_px)), times)


class Lines(unittest.TestCase):
    INK = numpy.array([0.1, 0.1, 0.2])

    def test_the_share_of_ink_is_found_on_any_ground(self):
        share = numpy.linspace(0, 1, SIDE)[:, None, None]
        for ground in (flat(0.9), flat(0.5)):
            found, told = measures.ink_share(ground + share * (self.INK - ground), ground, self.INK)
            self.assertTrue(told.all())
            numpy.testing.assert_allclose(
                found, numpy.broadcast_to(share[..., 0], found.shape), atol=1e-9
            )
        self.assertFalse(measures.ink_share(flat(0.15), flat(0.15), self.INK)[1].any())

    def test_a_line_that_another_light_takes_away_is_counted(self):
        everywhere = numpy.ones((SIDE, SIDE), bool)
        ink = ringed(3)
        less = ink.copy()
        less[:100] = 0
        changed, lines = measures.changed_lines((ink, less), (everywhere, everywhere), everywhere)
        self.assertAlmostEqual(changed / lines, 0.5, delta=0.02)
        self.assertEqual(measures.changed_lines((ink, ink), (everywhere,) * 2, everywhere)[0], 0)

    def test_widths_are_compared_over_the_lines_that_both_have(self):
        small, large = ringed(2), ringed(8, 4 * SIDE, 4)
        self.assertAlmostEqual(measures.width_ratio(small, large), 1, delta=0.02)
        self.assertAlmostEqual(measures.width_ratio(ringed(16, 4 * SIDE, 4), large), 2, delta=0.05)
        only_here = large.copy()
        only_here[90:110, 90:110] = 1
        self.assertAlmostEqual(measures.width_ratio(only_here, large), 1, delta=1e-9)

    def test_smaller_takes_means(self):
        picture = numpy.arange(16.0).reshape(4, 4)
        numpy.testing.assert_allclose(measures.smaller(picture, 2), [[2.5, 4.5], [10.5, 12.5]])
