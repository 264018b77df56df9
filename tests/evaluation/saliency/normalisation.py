"""The map normalisation N(.) of the saliency model: maps with one strong peak are promoted, maps
with many alike are suppressed.

`single_pass`: Itti, Koch, Niebur, IEEE PAMI 20(11), 1998, section 2.2. `iterative`: L. Itti, C.
Koch, "A saliency-based search mechanism for overt and covert shifts of visual attention", Vision
Research 40, 2000, section 2.3; the SaliencyToolbox's default.
"""
import functools

import cv2
import numpy

PEAK = 10.0  # M: every map is first scaled to [0, M]
FLAT = 1e-4  # a range within this (1/40 of an 8-bit step) is rounding
ITERATIONS = 3
EXCITATION_SIGMA = 0.02  # of the map's longer side
INHIBITION_SIGMA = 0.25  # of the map's longer side
EXCITATION_GAIN = 0.5  # of each of the two 1-D Gaussians
INHIBITION_GAIN = 1.5
GLOBAL_INHIBITION = 0.02  # of the map's maximum


def scale_to_peak(plane, flat=FLAT):
    """The plane scaled linearly from [minimum, maximum] to [0, PEAK]; zeros for a plane whose range
    is within `flat`."""
    lowest, highest = float(plane.min()), float(plane.max())
    if highest - lowest <= flat:
        return numpy.zeros_like(plane)
    return (plane - lowest) * (PEAK / (highest - lowest))


def single_pass(plane):
    """Scaled to [0, M], times (M - mean of the other local maxima)^2: one peak gives M^2, two equal
    peaks give 0."""
    scaled = scale_to_peak(plane)
    peaks = local_maxima(scaled, PEAK / 10)
    others = numpy.sort(peaks)[:-1]
    mean = others.mean() if len(others) else 0.0
    return scaled * (PEAK - mean) ** 2


def local_maxima(plane, threshold):
    """Values of the local maxima (8 neighbours) above a threshold; a plateau of touching pixels
    counts once."""
    highest_near = cv2.dilate(plane, numpy.ones((3, 3), numpy.uint8))
    is_maximum = (plane == highest_near) & (plane > threshold)
    count, labels = cv2.connectedComponents(is_maximum.astype(numpy.uint8), connectivity=8)
    highest = numpy.zeros(count, plane.dtype)
    numpy.maximum.at(highest, labels[is_maximum], plane[is_maximum])
    return highest[1:]


def iterative(plane):
    """Repeated difference of Gaussians with global inhibition: peaks compete, the strongest
    survives."""
    current = scale_to_peak(plane)
    longer_side = max(plane.shape)
    for _ in range(ITERATIONS):
        excitation = _spread(current, EXCITATION_SIGMA * longer_side, EXCITATION_GAIN)
        inhibition = _spread(current, INHIBITION_SIGMA * longer_side, INHIBITION_GAIN)
        current = numpy.maximum(
            0, current + excitation - inhibition - GLOBAL_INHIBITION * current.max()
        )
    return current


def _spread(plane, sigma, gain):
    """Convolution with the product of two 1-D Gaussians of that gain; what a border cuts off the
    kernel is made up for."""
    return gain**2 * _blur(plane, sigma) / _weight_inside(plane.shape, sigma)


@functools.cache
def _weight_inside(shape, sigma):
    """The share of the kernel that lies on the map; many maps have one of a few shapes."""
    return _blur(numpy.ones(shape, numpy.float32), sigma)


def _blur(plane, sigma):
    reach = min(int(numpy.ceil(3 * sigma)), max(plane.shape) - 1)
    kernel = cv2.getGaussianKernel(2 * reach + 1, sigma)
    return cv2.sepFilter2D(plane, cv2.CV_32F, kernel, kernel, borderType=cv2.BORDER_CONSTANT)


NORMALISATIONS = {"iterative": iterative, "single pass": single_pass}
