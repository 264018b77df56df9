"""Spectral residual saliency: a second opinion that shares no step with the centre-surround model.

Source: X. Hou, L. Zhang, "Saliency Detection: A Spectral Residual Approach", CVPR 2007; computed by
OpenCV's saliency module, which takes log(1 + |F|), blurs before it squares and divides by the
maximum. It sees the grey picture only: no colour.
"""
import cv2
import numpy

WIDTH_CELLS = 64  # the paper's scale; OpenCV's 64 x 64 would squeeze an oblong picture
FLAT = 1e-4  # a picture that varies less than this has no structure, only rounding
WHITE = (
    255  # greys go from 0 to this: in [0, 1] the 1 that OpenCV adds to the spectrum would drown it
)
LUMA = numpy.array([0.2126, 0.7152, 0.0722])  # Rec. 709, of display-encoded RGB


def spectral_residual(rgb):
    """rgb: (height, width, 3) in [0, 1], display-encoded. Returns (rows, 64) in [0, 1], which
    covers the picture evenly; zeros for a picture without structure."""
    grey = _shrunk(rgb @ LUMA)
    if grey.max() - grey.min() <= FLAT:
        return numpy.zeros_like(grey)
    detector = cv2.saliency.StaticSaliencySpectralResidual_create()
    detector.setImageWidth(grey.shape[1])
    detector.setImageHeight(grey.shape[0])
    succeeded, saliency = detector.computeSaliency(WHITE * grey)
    if not succeeded or not numpy.isfinite(saliency).all():
        raise ArithmeticError("the spectral residual of this picture is not finite")
    return saliency


def to_pixels(saliency, picture_shape):
    """A map that covers the picture evenly, at each pixel: (height, width), bilinear."""
    return cv2.resize(
        saliency, (picture_shape[1], picture_shape[0]), interpolation=cv2.INTER_LINEAR
    )


def _shrunk(grey):
    rows = max(1, round(WIDTH_CELLS * grey.shape[0] / grey.shape[1]))
    return cv2.resize(grey.astype(numpy.float32), (WIDTH_CELLS, rows), interpolation=cv2.INTER_AREA)
