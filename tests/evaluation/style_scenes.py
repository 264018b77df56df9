"""What a style is drawn as beside itself, so that it can be measured: flat colours that tell what
each pixel shows, its lines alone, its light without them. All are partial scenes that say what they
are after any other one. """
from dataclasses import dataclass, fields

import numpy

# Filters that draw lines. The rest abstract, and stay where lines are left out.
LINES = ("depth_lines", "sobel", "dog", "xdog", "fdog", "canny")
BRANCHES = ("focus", "context")
BLACK, WHITE = [0, 0, 0], [1, 1, 1]
RED, GREEN, BLUE = [1, 0, 0], [0, 1, 0], [0, 0, 1]
PURE = 0.98  # a pixel whose share of one kind is larger shows nothing else


@dataclass(frozen=True)
class Masks:
    """What each pixel shows and nothing else: context before or beside the lens, the cavity's wall,
    focus. The faces at which the volume ends are none of these. covered: whatever is not background
    alone."""

    skin: object
    wall: object
    focus: object
    covered: object

    def cropped(self, columns):
        return Masks(*(getattr(self, field.name)[:, columns] for field in fields(self)))


def is_measured(scene):
    """Whether a style has shaded surfaces behind a cutaway."""
    opaque = all(scene[branch]["surface"].get("opacity", 1) == 1 for branch in BRANCHES)
    return scene["lens"]["mode"] == "cutaway" and opaque


def is_stepped(branch):
    """Whether its light falls in two flat tones."""
    return branch["shading"]["name"] == "tone" and branch["shading"]["detail"] == 0


def cut_of(scene):
    """The part of its lens that says what is cut away."""
    return {key: scene["lens"][key] for key in ("mode", "opening", "funnel_degrees")}


def masks(studio, scene, width_px, height_px, pure=PURE):
    """Of the open volume in a style. pure: the share of its kind that a pixel needs. Faces that are
    cut get the colours of tissue, and the wall its own over them: so the volume's end is neither
    skin nor wall."""
    wall = {"strength": 1, "colour": BLUE, "deepening": 0, "edge_mm": 0}
    shown = {
        "lens": {**cut_of(scene), "cap": "section", "wall": wall},
        "background": {"colour": BLACK},
    }
    studio.change({"focus": flat(GREEN), "context": flat(RED), **shown})
    shares = studio.picture(width_px, height_px)
    skin, focus, wall = (
        (shares[..., i] > pure) & (numpy.delete(shares, i, axis=2).max(axis=2) < 1 - pure)
        for i in range(3)
    )
    return Masks(skin, wall, focus, shares.max(axis=2) > 0.5)


def flat(colour):
    """A branch in one colour, whatever the light."""
    return {
        "shading": {"name": "tone", "detail": 0, "dark": colour, "light": colour},
        "normals": {"scale": "fixed", "scale_mm": 0},
        **_unshadowed(),
        "filters": [],
    }


def lines_alone(scene):
    """Black on white."""
    ink = {
        branch: {
            **flat(WHITE),
            "filters": [_black(f) for f in scene[branch]["filters"] if is_line(f)],
        }
        for branch in BRANCHES
    }
    wall = {"strength": 1, "colour": WHITE, "deepening": 0, "edge_mm": 0}
    return {
        **ink,
        "lens": {**cut_of(scene), "cap": "flat", "wall": wall},
        "background": {"colour": WHITE},
    }


def without_lines(scene):
    return {
        branch: {"filters": [f for f in scene[branch]["filters"] if not is_line(f)]}
        for branch in BRANCHES
    }


def shading_alone(scene):
    """Of both branches: what the shading model makes of the light, without lines and without other
    surfaces' shadow."""
    return {
        branch: {**scene[branch], **_unshadowed(), **without_lines(scene)[branch]}
        for branch in BRANCHES
    }


def is_line(filter):
    return filter["name"] in LINES


def ink_of(branch):
    """Colour of a branch's last lines."""
    lines = [f for f in branch["filters"] if is_line(f)]
    if not lines:
        return numpy.array(BLACK, float)
    return numpy.array(
        WHITE if lines[-1].get("mode") == "brighten" else lines[-1].get("colour", BLACK), float
    )


def _unshadowed():
    return {"occlusion": {"strength": 0}, "shadow": {"strength": 0}}


def _black(line):
    if "colour" in line:
        return {**line, "colour": BLACK}
    return {**line, "mode": "darken"} if "mode" in line else line
