import unittest

import numpy

from saliency import fixations, map_fixations, saliency_maps
from saliency.proto_object import LARGEST_SHARE

from . import displays


def overlap(first, second):
    return (first & second).sum() / (first | second).sum()


class ProtoObject(unittest.TestCase):
    def test_it_is_about_the_square(self):
        # At 4 pixels a sample and a threshold of 0.1 the region reaches one or two samples beyond a
        # 30-pixel square; where such a square lies across the grid, a map with 16-pixel cells may
        # win and overlap less.
        for side, corner, least in (
            (30, (500, 300), 0.6),
            (30, (496, 304), 0.6),
            (60, (500, 300), 0.6),
            (100, (200, 420), 0.7),
        ):
            picture, square = displays.squares(side, corner)
            region = fixations(saliency_maps(picture), 1)[0].proto_object
            self.assertGreater(overlap(region.mask_px, square), least)
            self.assertEqual(region.channel, "intensity")

    def test_it_never_covers_a_tenth(self):
        for side in (200, 350, 500):
            picture, _ = displays.squares(side, (120, 130))
            for winner in fixations(saliency_maps(picture)):
                if winner.proto_object is not None:
                    self.assertLess(winner.proto_object.mask_px.mean(), 1.2 * LARGEST_SHARE)

    def test_a_region_that_would_is_no_region(self):
        picture, _ = displays.squares(60, (500, 300))
        winner = fixations(saliency_maps(picture, "single pass"), 1, theta=1e-6)[0]
        self.assertIsNone(winner.proto_object)
        x, y, radius = winner.circle_px()
        self.assertEqual((x, y), winner.position_px)
        self.assertAlmostEqual(radius, 768 / 6, delta=16)

    def test_a_lower_threshold_gives_a_larger_region(self):
        picture, _ = displays.squares(60, (500, 300))
        maps = saliency_maps(picture)
        areas = [
            fixations(maps, 1, theta)[0].proto_object.mask_px.sum()
            for theta in (0.05, 0.1, 0.3, 0.6)
        ]
        self.assertEqual(areas, sorted(areas, reverse=True))
        self.assertGreater(areas[0], areas[-1])

    def test_cells_hold_the_region(self):
        picture, _ = displays.squares(60, (500, 300))
        region = fixations(saliency_maps(picture), 1)[0].proto_object
        rows, columns = (
            numpy.rint(axis / 16).astype(int) for axis in numpy.nonzero(region.mask_px)
        )
        self.assertTrue(region.mask_cells[rows, columns].all())
        self.assertLess(region.mask_cells.sum() * 256, 4 * region.mask_px.sum())

    def test_circle_and_outline_surround_it(self):
        picture, _ = displays.squares(60, (500, 300))
        winner = fixations(saliency_maps(picture), 1)[0]
        x, y, radius = winner.circle_px()
        self.assertLess(numpy.hypot(x - 530, y - 330), 12)
        self.assertTrue(30 < radius < 75)
        self.assertEqual(len(winner.proto_object.outlines()), 1)


class Order(unittest.TestCase):
    def test_two_squares_are_two_successive_fixations(self):
        for normalisation in ("iterative", "single pass"):
            picture, _ = displays.squares(60, (150, 200), (520, 500))
            first, second = fixations(saliency_maps(picture, normalisation), 2)
            found = sorted([first.position_px, second.position_px])
            for (x, y), (left, top) in zip(found, ((150, 200), (520, 500))):
                self.assertTrue(left - 16 < x < left + 76 and top - 16 < y < top + 76)

    def test_ranks_and_falling_saliency(self):
        winners = fixations(saliency_maps(displays.scene(512)), 5)
        self.assertEqual([winner.rank for winner in winners], [1, 2, 3, 4, 5])
        values = [winner.saliency for winner in winners]
        self.assertEqual(values, sorted(values, reverse=True))
        self.assertEqual(len({winner.cell for winner in winners}), 5)

    def test_five_unless_told_otherwise(self):
        self.assertEqual(len(fixations(saliency_maps(displays.scene(512)))), 5)

    def test_a_shape_inhibits_less_than_a_disc(self):
        # The squares lie 100 pixels apart; the disc reaches 130.
        picture, _ = displays.squares(40, (300, 300), (400, 300))
        maps = saliency_maps(picture)
        first, second = fixations(maps, 2)
        self.assertAlmostEqual(abs(first.position_px[0] - second.position_px[0]), 100, delta=20)
        self.assertEqual(len(fixations(maps, 2, inhibition="disc")), 1)

    def test_discs_space_the_winners_out(self):
        maps = saliency_maps(displays.scene(512))
        cells = [numpy.array(winner.cell) for winner in fixations(maps, 5, inhibition="disc")]
        least = min(numpy.hypot(*(a - b)) for place, a in enumerate(cells) for b in cells[:place])
        self.assertGreater(least, min(maps.saliency.shape) / 6)

    def test_unknown_inhibition_is_refused(self):
        with self.assertRaisesRegex(ValueError, "square"):
            fixations(saliency_maps(displays.scene(512)), inhibition="square")

    def test_any_map(self):
        saliency = numpy.zeros((36, 64), numpy.float32)
        saliency[10, 20], saliency[30, 50] = 2, 1
        first, second = map_fixations(saliency, (720, 1280), 5)
        self.assertEqual((first.cell, second.cell), ((10, 20), (30, 50)))
        self.assertEqual(first.position_px, (409.5, 209.5))
        self.assertEqual(first.circle_px(), (409.5, 209.5, 120))

    def test_ties_go_to_the_lowest_index(self):
        saliency = numpy.zeros((36, 64), numpy.float32)
        saliency[30, 5] = saliency[10, 50] = 1
        self.assertEqual(map_fixations(saliency, (720, 1280), 1)[0].cell, (10, 50))
