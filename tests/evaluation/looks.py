"""How a unit of the experiment is drawn: the conditions' looks on one scene, at one size."""
import style_scenes

GREY = [128 / 255] * 3


def looks(studio):
    """{condition: the parts of a scene that make its look}. A is the flagship as it is shipped; all
    that have a lens cut the same away."""
    style, phong = studio.styles["flagship"], studio.styles["phong-control"]
    return {
        "A": style,
        "B": {**phong, "lens": {**phong["lens"], **style_scenes.cut_of(style)}},
        "C": {**phong, "lens": {**phong["lens"], "mode": "none"}},
        "D": {**style, "focus": style["context"], "context": style["focus"]},
    }


def picture(studio, scene, look, side_px):
    """scene: camera, and the lens' centre and radius."""
    _show(studio, scene, look)
    studio.change({"background": {"colour": GREY}})
    return studio.picture(side_px, side_px)


def focus_mask(studio, scene, side_px):
    """Where the conditions' cutaway shows the focus: bool (height, width)."""
    style = studio.styles["flagship"]
    _show(studio, scene, style)
    return style_scenes.masks(studio, style, side_px, side_px, pure=0.5).focus


def _show(studio, scene, look):
    studio.change({**look, "camera": scene["camera"], "lens": {**look["lens"], **scene["lens"]}})
