"""Early visual features of a picture: intensity, two colour opponents, four orientations.

Source: L. Itti, C. Koch, E. Niebur, "A Model of Saliency-Based Visual Attention for Rapid Scene
Analysis", IEEE PAMI 20(11), 1998, section 2.1; colour opponents after D. Walther, PhD thesis,
Caltech 2006, appendix A.2, which do not change with the light's strength.
"""
import cv2
import numpy

DARKEST_WITH_HUE = 0.1  # below this max(r, g, b) a hue is noise
ORIENTATIONS_DEG = (
    0,
    45,
    90,
    135,
)  # of the bar that a filter answers to; 0 is horizontal, 45 rises to the right
GABOR_PERIOD_PX = 7.0
GABOR_SIGMA_PX = 7.0 / 3.0
GABOR_SIZE_PX = 9


def intensity(rgb):
    """Mean of the channels; rgb: (height, width, 3) in [0, 1], display-encoded. Returns (height,
    width) in [0, 1]."""
    return rgb.mean(axis=2)


def red_green(rgb):
    """(r - g) / max(r, g, b), in [-1, 1]; zero where the pixel is too dark for a hue."""
    return _per_maximum(rgb, rgb[..., 0] - rgb[..., 1])


def blue_yellow(rgb):
    """(b - min(r, g)) / max(r, g, b), in [-1, 1]; zero where the pixel is too dark for a hue."""
    return _per_maximum(rgb, rgb[..., 2] - rgb[..., :2].min(axis=2))


def _per_maximum(rgb, difference):
    brightest = rgb.max(axis=2)
    has_hue = brightest >= DARKEST_WITH_HUE
    return numpy.where(has_hue, difference / numpy.where(has_hue, brightest, 1), 0).astype(
        numpy.float32
    )


def orientation_energy(plane, orientation_deg):
    """Sum of the absolute answers of an even and an odd Gabor filter to a plane of the intensity
    pyramid; same shape, >= 0."""
    even, odd = (gabor(orientation_deg, phase_deg) for phase_deg in (0, 90))
    return numpy.abs(_filter(plane, even)) + numpy.abs(_filter(plane, odd))


def gabor(orientation_deg, phase_deg):
    """A Gabor kernel of mean 0, so that an even area gives no answer, and of norm 1, so that both
    phases weigh the same."""
    reach = GABOR_SIZE_PX // 2
    down, right = numpy.mgrid[-reach : reach + 1, -reach : reach + 1].astype(float)
    angle = numpy.radians(orientation_deg)
    across = right * numpy.sin(angle) + down * numpy.cos(angle)
    envelope = numpy.exp(-(down**2 + right**2) / (2 * GABOR_SIGMA_PX**2))
    kernel = envelope * numpy.cos(
        2 * numpy.pi * across / GABOR_PERIOD_PX + numpy.radians(phase_deg)
    )
    kernel -= kernel.mean()
    return kernel / numpy.linalg.norm(kernel)


def _filter(plane, kernel):
    return cv2.filter2D(plane, cv2.CV_32F, kernel, borderType=cv2.BORDER_REPLICATE)
