import unittest

import cv2
import numpy

from saliency import map_fixations, spectral_residual
from saliency.spectral_residual import LUMA, to_pixels

from . import displays


def by_definition(rgb, added=0):
    """The paper's formula in double precision with OpenCV's order of the last steps: smooth,
    square, divide by the maximum. added: to the amplitudes, before their logarithm."""
    rows = round(64 * rgb.shape[0] / rgb.shape[1])
    grey = 255 * cv2.resize(rgb @ LUMA, (64, rows), interpolation=cv2.INTER_AREA)
    spectrum = numpy.fft.fft2(grey)
    logarithm = numpy.log(added + numpy.abs(spectrum))
    residual = logarithm - cv2.blur(logarithm, (3, 3))
    back = numpy.abs(numpy.fft.ifft2(numpy.exp(residual + 1j * numpy.angle(spectrum))))
    smooth = cv2.GaussianBlur(back, (5, 5), 8) ** 2
    return smooth / smooth.max()


class SpectralResidual(unittest.TestCase):
    def test_agrees_with_its_definition(self):
        for picture in (displays.scene(512), displays.scene(640)[:480]):
            numpy.testing.assert_allclose(
                spectral_residual(picture), by_definition(picture, added=1), atol=1e-3
            )
            numpy.testing.assert_allclose(
                spectral_residual(picture), by_definition(picture), atol=0.03
            )

    def test_keeps_the_aspect(self):
        self.assertEqual(spectral_residual(displays.scene(640)[:480]).shape, (48, 64))

    def test_an_even_picture_has_no_saliency(self):
        self.assertEqual(spectral_residual(displays.as_picture(displays.blank())).max(), 0)

    def test_symmetric_pictures_stay_finite(self):
        picture, _ = displays.squares(256, (256, 256))
        stripes = displays.as_picture(displays.blank())
        stripes[:, ::2] = 1
        wide = displays.as_picture(displays.blank())
        wide[:, 384:] = 1
        for rgb in (picture, stripes, wide):
            self.assertTrue(numpy.isfinite(spectral_residual(rgb)).all())

    def test_finds_the_odd_one(self):
        pale, white = displays.disc(20, displays.PALE), displays.disc(20, displays.WHITE)
        small, large = displays.disc(14, displays.WHITE), displays.disc(38, displays.WHITE)
        for item, odd in ((pale, white), (small, large)):
            picture, (x, y) = displays.array(item, odd, (4, 1))
            winner = map_fixations(spectral_residual(picture), picture.shape, 1)[0]
            self.assertLess(numpy.hypot(winner.position_px[0] - x, winner.position_px[1] - y), 48)

    def test_at_pixels(self):
        self.assertEqual(
            to_pixels(spectral_residual(displays.scene(640)[:480]), (480, 640, 3)).shape, (480, 640)
        )
