"""Pictures in, drawings of saliency out. A picture is (height, width, 3) RGB, display-encoded,
float32 in [0, 1].
"""
import cv2
import numpy

BACKGROUND = (
    128 / 255
)  # mid-grey; a background's contrast is salient too, so all conditions must share one
YELLOW = (255, 255, 0)
BLACK = (0, 0, 0)
SMALLEST_RADIUS_PX = 8


def read_picture(path, background=BACKGROUND):
    """A PNG or JPEG as RGB in [0, 1]; transparency (unpremultiplied) shows the grey background."""
    stored = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if stored is None:
        raise OSError(f"cannot read a picture from {path}")
    values = stored.astype(numpy.float32) / numpy.iinfo(stored.dtype).max
    if values.ndim == 2:
        return numpy.repeat(values[..., None], 3, axis=2)
    if values.shape[2] == 4:
        alpha = values[..., 3:]
        values = values[..., :3] * alpha + background * (1 - alpha)
    return numpy.ascontiguousarray(values[..., ::-1])


def write_picture(path, rgb):
    """Writes RGB in [0, 1] with 8 bits per channel."""
    if not cv2.imwrite(str(path), _eight_bit(rgb)[..., ::-1]):
        raise OSError(f"cannot write a picture to {path}")


def heat_map(saliency_px):
    """(height, width) saliency as a picture, black (least) through red and yellow to white (most);
    black where it is flat."""
    highest = saliency_px.max()
    share = saliency_px / highest if highest > 0 else numpy.zeros_like(saliency_px)
    return numpy.clip(share[..., None] * 3 - numpy.arange(3), 0, 1).astype(numpy.float32)


def draw_fixations(rgb, fixations, outlines=True):
    """The picture with each fixation's circle and rank, and its proto-object's outline."""
    drawn = _eight_bit(rgb)
    for fixation in fixations:
        x, y, radius = fixation.circle_px()
        centre, radius = (round(x), round(y)), max(round(radius), SMALLEST_RADIUS_PX)
        _draw_twice(
            lambda colour, width: cv2.circle(drawn, centre, radius, colour, width, cv2.LINE_AA)
        )
        if outlines and fixation.proto_object is not None:
            cv2.drawContours(drawn, fixation.proto_object.outlines(), -1, YELLOW, 1, cv2.LINE_AA)
        _draw_rank(drawn, fixation.rank, centre, radius)
    return drawn.astype(numpy.float32) / 255


def _eight_bit(rgb):
    return numpy.ascontiguousarray(numpy.rint(numpy.clip(rgb, 0, 1) * 255).astype(numpy.uint8))


def _draw_rank(drawn, rank, centre, radius):
    """The number to the upper right of the circle, inside the picture."""
    height, width = drawn.shape[:2]
    x = min(max(centre[0] + round(0.75 * radius), 0), width - 20)
    y = min(max(centre[1] - round(0.75 * radius), 22), height - 4)
    font = cv2.FONT_HERSHEY_SIMPLEX
    _draw_twice(
        lambda colour, line: cv2.putText(
            drawn, str(rank), (x, y), font, 0.8, colour, line, cv2.LINE_AA
        )
    )


def _draw_twice(draw):
    """Dark and wide below, yellow and thin above: visible on any picture."""
    draw(BLACK, 5)
    draw(YELLOW, 2)
