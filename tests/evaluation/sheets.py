"""Labelled sheets of pictures."""
import cv2
import numpy

PAPER = 1.0
GAP_PX = 8
LABEL_PX = 30
FONT = cv2.FONT_HERSHEY_SIMPLEX
INK = (0.1, 0.1, 0.1)


def sheet(rows, row_labels, column_labels):
    """A grid of pictures of one size, (height, width, 3) in [0, 1], with a label over each column
    and at the left of each row."""
    height, width = rows[0][0].shape[:2]
    across = GAP_PX + LABEL_PX + len(rows[0]) * (width + GAP_PX)
    down = GAP_PX + LABEL_PX + len(rows) * (height + GAP_PX)
    paper = numpy.full((down, across, 3), PAPER, numpy.float32)
    for column, label in enumerate(column_labels):
        x = GAP_PX + LABEL_PX + column * (width + GAP_PX)
        paper[GAP_PX : GAP_PX + LABEL_PX, x : x + width] = _label(label, width)
    for row, (pictures, label) in enumerate(zip(rows, row_labels)):
        y = GAP_PX + LABEL_PX + row * (height + GAP_PX)
        turned = numpy.rot90(_label(label, height))
        paper[y : y + height, GAP_PX : GAP_PX + LABEL_PX] = turned
        for column, picture in enumerate(pictures):
            x = GAP_PX + LABEL_PX + column * (width + GAP_PX)
            paper[y : y + height, x : x + width] = picture
    return paper


def _label(text, width):
    strip = numpy.full((LABEL_PX, width, 3), PAPER, numpy.float32)
    scale = 0.6
    text_width = cv2.getTextSize(text, FONT, scale, 1)[0][0]
    scale *= min(1.0, (width - 8) / max(text_width, 1))
    text_width = cv2.getTextSize(text, FONT, scale, 1)[0][0]
    place = ((width - text_width) // 2, LABEL_PX - 9)
    cv2.putText(strip, text, place, FONT, scale, INK, 1, cv2.LINE_AA)
    return strip
