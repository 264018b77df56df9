"""What a picture's tones, rims and lines measure, by the picture and masks alone. Pictures are
(height, width, 3) RGB in [0, 1], display-encoded sRGB; masks are bool (height, width). """
import cv2
import numpy

REC_709 = numpy.array([0.2126, 0.7152, 0.0722])
# Of the picture's height: what is seen as texture, and how far beside the rim its step is looked
# for.
SCALE = 0.01
NEAR_RIM_PX = 2  # between skin and cavity lies a pixel that holds some of both


def luma(rgb):
    """(height, width) in [0, 1]: the display-encoded channels by their weights, as video has it."""
    return rgb @ REC_709


def lightness(rgb):
    """CIE L* (0 to 100) of each pixel."""
    linear = _linear(rgb) @ REC_709
    return numpy.where(linear > 0.008856, 116 * numpy.cbrt(linear) - 16, 903.3 * linear)


def spread(values):
    """From the 5th to the 95th percentile."""
    low, high = numpy.percentile(values, (5, 95))
    return float(high - low)


def fine_contrast(rgb, mask):
    """RMS of the luma's deviation from its mean around each pixel of the mask, under a Gaussian of
    1 % of the height; what is not in the mask counts nowhere."""
    level, sigma = luma(rgb), SCALE * rgb.shape[0]
    weight = mask.astype(numpy.float64)
    around = cv2.GaussianBlur(level * weight, (0, 0), sigma) / numpy.maximum(
        cv2.GaussianBlur(weight, (0, 0), sigma), 1e-9
    )
    return float(numpy.sqrt(numpy.mean((level - around)[mask] ** 2)))


def rim(skin, cavity):
    """Where one lies within two pixels of the other."""
    kernel = _disc(NEAR_RIM_PX)
    return _dilated(skin, kernel) & _dilated(cavity, kernel)


def rim_steps(rgb, skin, cavity):
    """The step in luma across the rim, at each of its pixels: from the mean of the skin beside it
    to what differs most from that in the cavity, within 1 % of the height. So a pale edge before a
    dark wall is a step, whatever the mean of both."""
    at, reach_px = rim(skin, cavity), NEAR_RIM_PX + max(round(SCALE * rgb.shape[0]), 1)
    outside = _mean_within(luma(rgb), skin, reach_px)
    inside = numpy.where(cavity, _mean_within(luma(rgb), cavity, 1), numpy.nan)
    kernel = _disc(reach_px)
    lightest = cv2.dilate(numpy.nan_to_num(inside, nan=-9), kernel)
    darkest = cv2.erode(numpy.nan_to_num(inside, nan=9), kernel)
    return numpy.maximum(lightest - outside, outside - darkest)[at]


def boundary_length(labels, mask):
    """Of the boundary between True and False within the mask, in pixels: Cauchy and Crofton with
    four directions. Pairs across the mask's edge do not count."""

    def changes(here, there):
        return numpy.count_nonzero((labels[here] != labels[there]) & mask[here] & mask[there])

    all_but_last, all_but_first, every = slice(None, -1), slice(1, None), slice(None)
    across = changes((every, all_but_last), (every, all_but_first))
    down = changes((all_but_last, every), (all_but_first, every))
    falling = changes((all_but_last, all_but_last), (all_but_first, all_but_first))
    rising = changes((all_but_first, all_but_last), (all_but_last, all_but_first))
    return float(numpy.pi / 8 * (across + down + (falling + rising) / numpy.sqrt(2)))


def place_between(rgb, dark, light):
    """Of each pixel on the way from one colour (0) to another (1)."""
    way = numpy.subtract(light, dark)
    return (rgb - numpy.asarray(dark)) @ way / (way @ way)


def place_on_ramp(rgb, colours):
    """Of each of the (n, 3) colours on the ramp, 0 at its first colour and 1 at its last: the
    nearest point of the straight ways in OKLab between its evenly placed colours."""
    points, ramp = oklab(rgb)[:, None], oklab(numpy.asarray(colours, float))
    begins, ways = ramp[:-1], numpy.diff(ramp, axis=0)
    share = ((points - begins) * ways).sum(-1) / numpy.maximum((ways**2).sum(-1), 1e-12)
    share = share.clip(0, 1)
    nearest = ((begins + share[..., None] * ways - points) ** 2).sum(-1).argmin(1)
    return (nearest + share[numpy.arange(len(nearest)), nearest]) / len(ways)


def oklab(rgb):
    """B. Ottosson, "A perceptual color space for image processing", 2020."""
    cones = numpy.array(
        [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ]
    )
    opponents = numpy.array(
        [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ]
    )
    return numpy.cbrt(_linear(rgb) @ cones.T) @ opponents.T


def ink_share(drawn, plain, ink):
    """How much of each pixel is ink, and whether that can be told: `drawn` is `plain` with lines
    mixed in. ink: a colour or one for each pixel."""
    way = ink - plain
    square = (way**2).sum(-1)
    share = ((drawn - plain) * way).sum(-1) / numpy.maximum(square, 1e-9)
    return share.clip(0, 1), square > TELLING**2


TELLING = 0.25  # distance of the ink from what it is drawn on, of 1.7
INKED = 0.15  # a pixel with so much ink is a line's


def changed_lines(inks, tellings, where):
    """(changed, all) of the line pixels of two pictures: one whose ink differs by INKED changed."""
    told = tellings[0] & tellings[1] & where
    lines = told & (numpy.maximum(*inks) > INKED)
    return numpy.count_nonzero(lines & (abs(inks[0] - inks[1]) > INKED)), numpy.count_nonzero(lines)


def width_ratio(ink, other):
    """Of the lines' widths in two maps of ink of one size: over the lines that both have, which are
    as long in both."""
    kernel = _disc(2)
    both = _dilated(ink > INKED, kernel) & _dilated(other > INKED, kernel)
    return float(ink[both].sum() / other[both].sum()) if both.any() else float("nan")


def dilated(mask, radius_px):
    return _dilated(mask, _disc(round(radius_px)))


def smaller(picture, times):
    """A whole number of times smaller, each pixel the mean of those that it stands for."""
    height, width = picture.shape[0] // times, picture.shape[1] // times
    return picture.reshape(height, times, width, times, -1).mean((1, 3)).squeeze()


def _linear(rgb):
    return numpy.where(rgb > 0.04045, ((numpy.maximum(rgb, 0) + 0.055) / 1.055) ** 2.4, rgb / 12.92)


def _mean_within(level, mask, radius_px):
    """Over the mask's pixels in a disc around each pixel; NaN where it has none."""
    kernel = _disc(radius_px).astype(numpy.float64)
    weight = mask.astype(numpy.float64)
    sums = [
        cv2.filter2D(v, -1, kernel, borderType=cv2.BORDER_CONSTANT)
        for v in (level * weight, weight)
    ]
    return numpy.where(sums[1] > 0.5, sums[0] / numpy.maximum(sums[1], 0.5), numpy.nan)


def _disc(radius_px):
    return cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius_px + 1,) * 2)


def _dilated(mask, kernel):
    return cv2.dilate(mask.astype(numpy.uint8), kernel).astype(bool)
