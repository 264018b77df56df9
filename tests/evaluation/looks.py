"""How a unit of the experiment is drawn: the conditions' looks on one scene, at one size."""
BLACK = [0, 0, 0]
GREY = [128 / 255] * 3


def looks(studio):
    """{condition: the parts of a scene that make its look}."""
    style, phong = studio.styles["flagship"], studio.styles["phong-control"]
    return {
        "A": style,
        "B": phong,
        "C": {**phong, "lens": {**phong["lens"], "mode": "none"}},
        "D": {**style, "focus": style["context"], "context": style["focus"]},
    }


def picture(studio, scene, look, side_px, background=GREY):
    """scene: camera, and the lens' centre and radius."""
    lens = {**look["lens"], **scene["lens"]}
    shown = {"camera": scene["camera"], "lens": lens, "background": {"colour": background}}
    studio.change({**look, **shown})
    return studio.picture(side_px, side_px)


def focus_mask(studio, scene, side_px):
    """Where the cutaway shows the focus: bool (height, width)."""
    lens = {"mode": "cutaway", "cap": "flat"}
    white_on_black = {"focus": _flat(1.0), "context": _flat(0.0), "lens": lens}
    return picture(studio, scene, white_on_black, side_px, BLACK)[..., 0] > 0.5


def _flat(level):
    colour = [level] * 3
    return {
        "shading": {"name": "tone", "detail": 0, "dark": colour, "light": colour},
        "filters": [],
    }
