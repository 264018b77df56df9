"""From a style's pictures of one volume to its figures."""
import numpy

import style_scenes
import tone_measures as measures
from style_limits import FEWEST_PX

STEP = 4 / 255  # that an eye sees along a rim
BESIDE_RIM = 0.01  # of the height: lines so near the rim may be its own


def tones(rgb, masks):
    """Of the picture as it is shown."""
    skin, wall, focus = (_enough(m) for m in (masks.skin, masks.wall, masks.focus))
    found = {}
    cavity = masks.wall | masks.focus
    steps = measures.rim_steps(rgb, masks.skin, cavity)
    if steps.size > FEWEST_PX:
        found["rim"] = float((steps < STEP).mean())
    level = {
        name: float(numpy.median(measures.lightness(rgb[m])))
        for name, m in (("skin", skin), ("wall", wall), ("focus", focus))
        if m is not None
    }
    if "wall" in level:
        found |= {
            f"wall_{other}": abs(level["wall"] - level[other])
            for other in ("skin", "focus")
            if other in level
        }
    if skin is not None:
        found["context_tone"] = measures.spread(measures.luma(rgb[skin]))
        if focus is not None:
            of_focus = max(measures.fine_contrast(rgb, focus), 1 / 255)
            found["context_calm"] = measures.fine_contrast(rgb, skin) / of_focus
    return found


def ramp_halves(rgb, masks, shading):
    """Of the focus' shading alone. shading: a ramp's parameters."""
    if _enough(masks.focus) is None or _enough(masks.skin) is None:
        return {}  # of a slab of few slices there are cut faces alone
    names = ("deepest", "deep", "middle", "light", "lighter", "lightest")
    places = measures.place_on_ramp(rgb[masks.focus], [shading[name] for name in names])
    return {"cool_half": float((places < 0.5).mean()), "warm_half": float((places > 0.5).mean())}


def equal_luma(rgb, masks):
    if _enough(masks.focus) is None:
        return {}
    return {"equal_luma": measures.spread(measures.luma(rgb[masks.focus]))}


def turned_lines(drawn, plain, scene, masks):
    """drawn, plain: with lines and without, each under two lights. At a picture's border, which is
    another one where it is a part, filters see less."""
    ink = numpy.where(
        masks.focus[..., None], *(style_scenes.ink_of(scene[b]) for b in style_scenes.BRANCHES)
    )
    shares, told = zip(*(measures.ink_share(d, p, ink) for d, p in zip(drawn, plain, strict=True)))
    aside_px = round(BESIDE_RIM * drawn[0].shape[0]) + 2
    rim = measures.rim(masks.skin, masks.wall | masks.focus)
    where = (masks.skin | masks.wall | masks.focus) & ~measures.dilated(rim, aside_px)
    where[:, :aside_px] = where[:, -aside_px:] = False
    changed, lines = measures.changed_lines(shares, told, where)
    return {"turned_lines": changed} if lines > FEWEST_PX else {}


def sizes(small, large, small_ink, large_ink, covered):
    """The same at two heights, and the lines of both alone (1 is ink). covered: of the small
    one."""
    times = large.shape[0] // small.shape[0]
    difference = abs(measures.smaller(large, times) - small)[covered].mean() * 255
    found = {"size": float(difference)}
    ratio = measures.width_ratio(measures.smaller(large_ink, times), small_ink)
    return found if numpy.isnan(ratio) else {**found, "line_width": ratio}


def toon_length(rgb, mask, shading):
    """Of the boundary between a flat tone shader's two tones."""
    places = measures.place_between(rgb, shading["dark"], shading["light"])
    return measures.boundary_length(places > 0.5, mask)


def _enough(mask):
    return mask if numpy.count_nonzero(mask) > FEWEST_PX else None
