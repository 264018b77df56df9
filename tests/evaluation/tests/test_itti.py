import time
import unittest

import numpy

from saliency import fixations, saliency_maps

from . import displays
from .displays import GREEN, PALE, RED, WHITE, array, bar, disc

BOTH = ("iterative", "single pass")
ODD_PLACES = ((1, 2), (4, 1), (3, 3), (2, 4))


def first_winner(picture, normalisation="iterative"):
    return fixations(saliency_maps(picture, normalisation), count=1)[0]


class PopOut(unittest.TestCase):
    def check(self, item, odd_item, channel=None):
        for normalisation in BOTH:
            for place in ODD_PLACES:
                picture, (x, y) = array(item, odd_item, place)
                with self.subTest(normalisation=normalisation, place=place):
                    winner = first_winner(picture, normalisation)
                    off = numpy.hypot(winner.position_px[0] - x, winner.position_px[1] - y)
                    self.assertLess(off, 48, "the winner is not the odd item")
                    if channel and normalisation == "single pass":
                        self.assertEqual(winner.proto_object.channel, channel)

    def test_colour(self):
        # Red and green of one intensity. The discs must be large against their spacing: both
        # contrast alike with the grey between them, and only what the surround holds of the
        # neighbours' colour tells the odd one.
        self.check(disc(48, GREEN), disc(48, RED))
        self.check(disc(48, RED), disc(48, GREEN))

    def test_orientation(self):
        self.check(bar(0), bar(90), "orientation")
        self.check(bar(45), bar(135), "orientation")

    def test_intensity(self):
        self.check(disc(20, PALE), disc(20, WHITE), "intensity")

    def test_size(self):
        self.check(disc(14, WHITE), disc(38, WHITE))

    def test_a_lone_dot(self):
        for x, y in ((100, 600), (400, 330), (650, 90)):
            picture = displays.blank()
            disc(12, WHITE)(picture, (x, y))
            winner = first_winner(displays.as_picture(picture))
            self.assertLess(numpy.hypot(winner.position_px[0] - x, winner.position_px[1] - y), 16)


class NullPictures(unittest.TestCase):
    def test_an_even_picture_has_no_saliency(self):
        for value in (0, 37, 128, 255):
            for normalisation in BOTH:
                maps = saliency_maps(
                    displays.as_picture(displays.blank(value=value)), normalisation
                )
                self.assertEqual(max(plane.values.max() for plane in maps.features), 0)
                self.assertEqual(maps.saliency.max(), 0)
                self.assertEqual(fixations(maps), [])

    def test_an_even_colour_has_no_saliency(self):
        picture = displays.as_picture(displays.blank()) * numpy.array(
            [0.9, 0.6, 0.3], numpy.float32
        )
        self.assertEqual(saliency_maps(picture).saliency.max(), 0)

    def test_like_items_do_not_stand_out(self):
        # The odd bar is twice as salient as the next place; without it, no place is by a tenth.
        like, _ = array(bar(0), bar(0), None)
        odd, _ = array(bar(0), bar(90), (1, 2))
        first, second = fixations(saliency_maps(like, "single pass"), count=2)
        self.assertLess(first.saliency, 1.1 * second.saliency)
        first, second = fixations(saliency_maps(odd, "single pass"), count=2)
        self.assertGreater(first.saliency, 2 * second.saliency)


class Maps(unittest.TestCase):
    def test_there_are_42_feature_maps(self):
        maps = saliency_maps(displays.scene(512))
        counts = {
            channel: sum(plane.channel == channel for plane in maps.features)
            for channel in maps.conspicuity
        }
        self.assertEqual(counts, {"intensity": 6, "colour": 12, "orientation": 24})

    def test_oblong_pictures(self):
        picture = displays.scene(960)[:720]
        maps = saliency_maps(picture)
        self.assertEqual(maps.saliency.shape, (46, 61))
        self.assertEqual(maps.saliency_px().shape, (720, 960))

    def test_the_rim_never_wins(self):
        picture = displays.blank()
        picture[:, :6] = 255
        maps = saliency_maps(displays.as_picture(picture))
        self.assertGreater(fixations(maps, 1)[0].cell[1], 0)

    def test_the_same_picture_gives_the_same_map(self):
        picture = displays.scene(512)
        numpy.testing.assert_array_equal(
            saliency_maps(picture).saliency, saliency_maps(picture).saliency
        )

    def test_time(self):
        picture = displays.scene(768)
        begun = time.process_time()
        fixations(saliency_maps(picture))
        self.assertLess(time.process_time() - begun, 2.0)


class Invariance(unittest.TestCase):
    def check_same(self, turned, expected):
        numpy.testing.assert_allclose(turned, expected, atol=2e-3 * expected.max())

    def test_mirrored_pictures_give_mirrored_maps(self):
        # 641 pixels are framed to 769, 513 are left alone.
        picture = displays.scene(641)[:513]
        for normalisation in BOTH:
            saliency = saliency_maps(picture, normalisation).saliency
            turned = saliency_maps(picture[:, ::-1], normalisation).saliency
            upside_down = saliency_maps(picture[::-1], normalisation).saliency
            self.assertGreater(abs(saliency - saliency[:, ::-1]).max(), 0.5 * saliency.max())
            self.check_same(turned, saliency[:, ::-1])
            self.check_same(upside_down, saliency[::-1])

    def test_a_transposed_picture_gives_the_transposed_map(self):
        picture = displays.scene(641)[:513]
        saliency = saliency_maps(picture).saliency
        self.check_same(saliency_maps(picture.swapaxes(0, 1)).saliency, saliency.T)

    def test_an_even_side_moves_the_mirrored_winner_by_less_than_a_cell(self):
        picture, _ = array(bar(0), bar(90), (1, 2))
        winner, mirrored = first_winner(picture), first_winner(picture[:, ::-1])
        self.assertLess(abs(winner.position_px[0] - (767 - mirrored.position_px[0])), 16)
        self.assertEqual(winner.position_px[1], mirrored.position_px[1])

    def test_twice_the_resolution_moves_the_winner_by_less_than_a_cell(self):
        for x, y in ((100, 300), (333, 90), (250, 401)):
            picture, _ = displays.squares(40, (x, y), picture_side=512)
            large = picture.repeat(2, axis=0).repeat(2, axis=1)
            near, far = first_winner(picture).position_px, first_winner(large).position_px
            self.assertLess(numpy.hypot(near[0] - far[0] / 2, near[1] - far[1] / 2), 16)

    def test_a_shift_by_cells_shifts_the_winner(self):
        picture, _ = displays.squares(30, (300, 300))
        moved, _ = displays.squares(30, (300 + 64, 300 - 32))
        x, y = first_winner(picture).position_px
        self.assertEqual(first_winner(moved).position_px, (x + 64, y - 32))
