"""Search displays with a known answer: a square array of like items, one of which may be odd.
Mid-grey background.
"""
import cv2
import numpy

SIDE_PX = 768
BACKGROUND = 128
WHITE, PALE, RED, GREEN = (255, 255, 255), (153, 153, 153), (255, 0, 0), (0, 255, 0)


def blank(side=SIDE_PX, value=BACKGROUND):
    return numpy.full((side, side, 3), value, numpy.uint8)


def as_picture(eight_bit):
    return eight_bit.astype(numpy.float32) / 255


def array(item, odd_item, odd_at, spacing=128):
    """The display as a picture, and the odd item's position (x, y). odd_at: (column, row), or None
    for a display of like items. item(picture, (x, y)) draws."""
    picture = blank()
    count = SIDE_PX // spacing
    for column in range(count):
        for row in range(count):
            place = (spacing // 2 + column * spacing, spacing // 2 + row * spacing)
            (odd_item if (column, row) == odd_at else item)(picture, place)
    position = odd_at and tuple(spacing // 2 + index * spacing for index in odd_at)
    return as_picture(picture), position


def disc(radius, colour):
    return lambda picture, place: cv2.circle(picture, place, radius, colour, -1, cv2.LINE_AA)


def bar(angle_deg, length=60, width=10, colour=WHITE):
    """angle_deg: 0 is horizontal, 45 rises to the right."""
    right = length / 2 * numpy.cos(numpy.radians(angle_deg))
    down = -length / 2 * numpy.sin(numpy.radians(angle_deg))

    def draw(picture, place):
        begin = (round(place[0] - right), round(place[1] - down))
        end = (round(place[0] + right), round(place[1] + down))
        cv2.line(picture, begin, end, colour, width, cv2.LINE_AA)

    return draw


def squares(side, *corners, picture_side=SIDE_PX):
    """White squares on grey, given by their upper left corners (x, y), and the mask of them."""
    picture = blank(picture_side)
    for x, y in corners:
        picture[y : y + side, x : x + side] = 255
    return as_picture(picture), picture[..., 0] == 255


def scene(side, seed=1):
    """Smooth coloured clutter without any symmetry, (side, side, 3)."""
    noise = numpy.random.default_rng(seed).random((side, side, 3), numpy.float32)
    smooth = cv2.GaussianBlur(noise, (0, 0), 12)
    return (smooth - smooth.min()) / (smooth.max() - smooth.min())
