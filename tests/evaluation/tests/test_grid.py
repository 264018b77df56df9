import unittest

import numpy

from saliency import grid
from saliency.grid import Axis, Grid


def ramp(side):
    """Values that grow by one a pixel to the right and by ten downwards."""
    rows, columns = numpy.mgrid[:side, :side]
    return (columns + 10 * rows).astype(numpy.float32)


class Framing(unittest.TestCase):
    def test_sides_become_multiples_of_256_and_one(self):
        for size in (256, 257, 512, 513, 640, 720, 768, 769, 1000):
            axis = Axis.of(size)
            self.assertEqual(axis.framed_px % 256, 1)
            self.assertEqual(axis.before_px % grid.CELL_PX, 0)
            self.assertGreaterEqual(axis.after_px, 0)
            self.assertTrue(size <= (axis.cells - 1) * grid.CELL_PX + 1 < size + grid.CELL_PX)

    def test_a_side_that_fits_is_left_alone(self):
        self.assertEqual(Axis.of(513), Axis(size_px=513, cells=33, before_px=0, framed_px=513))

    def test_small_pictures_are_refused_with_the_limit(self):
        with self.assertRaisesRegex(ValueError, "at least 256 pixels.*not 255"):
            Axis.of(255)


class Alignment(unittest.TestCase):
    def test_a_cell_lies_on_its_pixel(self):
        picture = ramp(700)
        frame = Grid.of(picture)
        plane = frame.crop(grid.pyramid(frame.frame(picture), 5)[4], 4)
        self.assertEqual(plane.shape, frame.map_shape)
        numpy.testing.assert_allclose(plane[4:-4, 4:-4], picture[::16, ::16][4:41, 4:41], atol=0.01)

    def test_refining_does_not_shift(self):
        fine = ramp(65)
        numpy.testing.assert_allclose(grid.refine(fine[::8, ::8], fine.shape, 3), fine, atol=1e-3)

    def test_pixels_of_a_plane_pass_through_its_cells(self):
        plane = numpy.random.default_rng(3).random((33, 33), numpy.float32)
        pixels = Grid.of(ramp(513)).to_pixels(plane, 4)
        numpy.testing.assert_allclose(pixels[::16, ::16], plane, atol=1e-6)
