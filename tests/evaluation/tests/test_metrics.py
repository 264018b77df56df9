import unittest

import numpy

from saliency import (
    detail,
    fixations,
    metrics,
    moved_masks,
    saliency_maps,
    scores,
    shuffled_nss,
)

from . import displays


def mask_of(shape, rows, columns):
    mask = numpy.zeros(shape, bool)
    mask[rows, columns] = True
    return mask


QUARTER = mask_of((40, 40), slice(0, 20), slice(0, 20))


class Maps(unittest.TestCase):
    def test_the_mask_itself_reaches_every_bound(self):
        for focus, bound in (
            (QUARTER, 1.732),
            (mask_of((40, 50), slice(0, 10), slice(0, 10)), 4.359),
        ):
            saliency = focus.astype(numpy.float32)
            self.assertAlmostEqual(metrics.nss(saliency, focus), bound, places=3)
            self.assertEqual(metrics.auc(saliency, focus), 1)
            self.assertAlmostEqual(metrics.mass_ratio(saliency, focus), 1 / focus.mean(), places=6)
            self.assertEqual(metrics.auc(1 - saliency, focus), 0)
            self.assertLess(metrics.nss(1 - saliency, focus), 0)

    def test_flat_maps_score_chance(self):
        for value in (0, 0.3):
            flat = numpy.full(QUARTER.shape, value, numpy.float32)
            self.assertAlmostEqual(metrics.nss(flat, QUARTER), 0, places=6)
            self.assertEqual(metrics.auc(flat, QUARTER), 0.5)
            self.assertAlmostEqual(metrics.mass_ratio(flat, QUARTER), 1, places=6)

    def test_noise_scores_chance(self):
        saliency = numpy.random.default_rng(1).random((400, 400))
        focus = mask_of((400, 400), slice(100, 200), slice(50, 250))
        self.assertAlmostEqual(metrics.nss(saliency, focus), 0, delta=0.03)
        self.assertAlmostEqual(metrics.auc(saliency, focus), 0.5, delta=0.01)
        self.assertAlmostEqual(metrics.mass_ratio(saliency, focus), 1, delta=0.02)

    def test_auc_is_the_share_of_ordered_pairs(self):
        saliency = numpy.random.default_rng(2).integers(0, 5, (9, 11))
        focus = mask_of((9, 11), slice(2, 6), slice(3, 8))
        inside, outside = saliency[focus][:, None], saliency[~focus]
        expected = ((inside > outside) + 0.5 * (inside == outside)).mean()
        self.assertAlmostEqual(metrics.auc(saliency, focus), expected, places=12)

    def test_nss_and_auc_ignore_the_scale(self):
        saliency = numpy.random.default_rng(3).random(QUARTER.shape)
        self.assertAlmostEqual(
            metrics.nss(saliency, QUARTER), metrics.nss(7 * saliency + 3, QUARTER), places=9
        )
        self.assertEqual(metrics.auc(saliency, QUARTER), metrics.auc(7 * saliency + 3, QUARTER))

    def test_masks_that_mean_nothing_are_refused(self):
        saliency = numpy.ones((40, 40))
        for focus in (~QUARTER & QUARTER, QUARTER | ~QUARTER, QUARTER[:20], QUARTER.astype(float)):
            with self.assertRaises(ValueError):
                metrics.nss(saliency, focus)


class Hits(unittest.TestCase):
    def setUp(self):
        picture, self.squares = displays.squares(60, (150, 200), (520, 500))
        self.maps = saliency_maps(picture)
        self.winners = fixations(self.maps)
        self.left = mask_of(picture.shape[:2], slice(200, 260), slice(150, 210))
        self.right = mask_of(picture.shape[:2], slice(500, 560), slice(520, 580))

    def test_first_and_second(self):
        ranks = [metrics.hit_rank(self.winners, mask) for mask in (self.left, self.right)]
        self.assertEqual(sorted(ranks), [1, 2])
        first = self.left if ranks[0] == 1 else self.right
        result = scores(self.maps.saliency_px(), self.winners, first)
        self.assertTrue(result.first_hit and result.proto_object_hit and result.hit_rank == 1)
        self.assertTrue(result.nss > 1 and result.auc > 0.95 and result.mass_ratio > 10)

    def test_nowhere(self):
        empty_corner = mask_of(self.squares.shape, slice(600, 700), slice(50, 150))
        result = scores(self.maps.saliency_px(), self.winners, empty_corner)
        self.assertEqual(
            (result.first_hit, result.proto_object_hit, result.hit_rank), (False, False, None)
        )
        self.assertLess(result.nss, 0)

    def test_one_cell_beside_the_focus_still_counts(self):
        x, y = (int(value) for value in self.winners[0].position_px)
        for distance, expected in ((15, True), (18, False)):
            focus = mask_of(
                self.squares.shape, slice(y - 5, y + 5), slice(x + distance, x + distance + 30)
            )
            self.assertEqual(metrics.hit_rank(self.winners[:1], focus) == 1, expected)

    def test_no_winner_is_no_hit(self):
        result = scores(numpy.zeros(self.squares.shape), [], self.left)
        self.assertEqual(
            (result.first_hit, result.proto_object_hit, result.hit_rank), (False, False, None)
        )


class Controls(unittest.TestCase):
    body = mask_of((400, 400), slice(50, 350), slice(50, 350))
    focus = mask_of((400, 400), slice(100, 160), slice(100, 160))

    def test_moved_masks_keep_their_size_and_lie_elsewhere_on_the_object(self):
        masks = moved_masks(self.focus, self.body)
        self.assertGreater(len(masks), 20)
        for mask in masks:
            self.assertLessEqual(mask.sum(), self.focus.sum())
            self.assertGreaterEqual((mask & self.body).sum(), 0.75 * self.focus.sum())
            self.assertLessEqual((mask & self.focus).sum(), 0.5 * self.focus.sum())

    def test_shuffling_costs_a_map_that_shows_the_focus(self):
        saliency = self.focus.astype(numpy.float32)
        self.assertLess(
            shuffled_nss(saliency, moved_masks(self.focus, self.body)),
            0.2 * metrics.nss(saliency, self.focus),
        )

    def test_a_focus_as_large_as_the_object_cannot_be_moved(self):
        self.assertEqual(moved_masks(self.body, self.body), [])
        self.assertIsNone(shuffled_nss(self.focus.astype(float), []))


class Detail(unittest.TestCase):
    def test_a_ramp_has_none_and_a_checkerboard_eight_times_its_half_step(self):
        focus = mask_of((64, 64), slice(10, 50), slice(10, 50))
        ramp = numpy.repeat(numpy.linspace(0, 1, 64)[None, :, None], 64, axis=0).repeat(3, axis=2)
        self.assertAlmostEqual(detail(ramp, focus), 0, places=6)
        rows, columns = numpy.mgrid[:64, :64]
        board = numpy.repeat((0.5 + 0.1 * (-1.0) ** (rows + columns))[..., None], 3, axis=2)
        self.assertAlmostEqual(detail(board, focus), 0.8, places=5)

    def test_the_seam_does_not_count(self):
        focus = mask_of((64, 64), slice(10, 50), slice(10, 50))
        self.assertEqual(detail(numpy.repeat(focus[..., None], 3, axis=2).astype(float), focus), 0)

    def test_a_thin_mask_has_none(self):
        thread = mask_of((64, 64), slice(10, 12), slice(0, 64))
        self.assertEqual(detail(displays.scene(64), thread), 0)
