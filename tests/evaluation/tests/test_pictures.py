import pathlib
import tempfile
import unittest

import cv2
import numpy

from saliency import draw_fixations, fixations, heat_map, read_picture, saliency_maps, write_picture

from . import displays


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "picture.png"

    def test_what_was_written_is_read_with_red_as_red(self):
        picture = displays.as_picture(displays.blank(32))
        picture[3, 5] = (1, 0, 0)
        write_picture(self.path, picture)
        numpy.testing.assert_allclose(read_picture(self.path), picture, atol=1e-6)

    def test_transparency_shows_the_grey_background(self):
        blue_green_red_alpha = numpy.zeros((2, 2, 4), numpy.uint8)
        blue_green_red_alpha[0, 0] = (0, 0, 255, 255)
        cv2.imwrite(str(self.path), blue_green_red_alpha)
        picture = read_picture(self.path)
        numpy.testing.assert_allclose(picture[0, 0], (1, 0, 0), atol=1e-6)
        numpy.testing.assert_allclose(picture[1, 1], 128 / 255, atol=1e-6)

    def test_grey_files_have_three_channels(self):
        cv2.imwrite(str(self.path), numpy.full((4, 6), 51, numpy.uint8))
        numpy.testing.assert_allclose(
            read_picture(self.path), numpy.full((4, 6, 3), 0.2), atol=1e-6
        )

    def test_a_file_that_is_no_picture_is_named(self):
        self.path.write_text("no picture")
        with self.assertRaisesRegex(OSError, "picture.png"):
            read_picture(self.path)


class Drawing(unittest.TestCase):
    def test_the_circle_surrounds_the_winner_and_leaves_the_rest(self):
        picture, _ = displays.squares(60, (500, 300))
        drawn = draw_fixations(picture, fixations(saliency_maps(picture), 1))
        changed = numpy.argwhere(numpy.abs(drawn - picture).max(axis=2) > 0.1)
        self.assertTrue(
            (changed.min(axis=0) > (200, 400)).all() and (changed.max(axis=0) < (420, 640)).all()
        )

    def test_heat_grows_from_black_to_white(self):
        heat = heat_map(numpy.linspace(0, 2, 50)[None])
        self.assertTrue((numpy.diff(heat.sum(axis=2)[0]) > 0).all())
        numpy.testing.assert_allclose((heat[0, 0], heat[0, -1]), ((0, 0, 0), (1, 1, 1)), atol=1e-6)
        self.assertEqual(heat_map(numpy.zeros((3, 3))).max(), 0)
