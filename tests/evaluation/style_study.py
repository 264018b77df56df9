"""Every illustration style that shades surfaces behind a cutaway, on every volume whose first scene
has such a lens: do its tones, rim and lines say what they are to say? One table, held against
`style_limits`. """
import tempfile
from dataclasses import asdict, dataclass

import made_bodies
import style_figures
import style_scenes
from style_limits import Cell
from studio import Studio

ISOLUMINANT, RAMP_STYLE = "isoluminant", "flagship"
OTHER_LIGHT = {"frame": "camera", "direction": [0.7, -0.2, 0.6]}
TIMES = 4  # of the small picture's height: 360 and 1440


@dataclass(frozen=True)
class StyleStudy:
    """lensless: volumes whose first scene has no cutaway."""

    cells: list
    lensless: list

    def as_dict(self):
        return {
            **asdict(self),
            "failing": {f"{c.style} on {c.volume}": c.failing() for c in self.cells if c.failing()},
        }


def make(studio, cutaway, volumes, extent, progress):
    """cutaway: the binary, for a server of its own that shows made bodies."""
    cells, lensless = [], []
    styles = _styles(studio)[: extent.most_styles]
    for volume in volumes:
        progress(f"styles: {volume}")
        first = studio.first_scene(volume)
        if first["lens"]["mode"] != "cutaway" or first["lens"]["radius_mm"] == 0:
            lensless.append(volume)
            continue
        cells += _Volume(studio, volume, extent.style_px).cells(styles)
    progress("styles: bodies with and without noise")
    return StyleStudy(cells + _toon_cells(cutaway, studio, styles, extent.style_px[1]), lensless)


def _styles(studio):
    """The flagship first, as the server lists them."""
    return [n for n in studio.illustrations if style_scenes.is_measured(studio.styles[n])]


class _Volume:
    """The open volume, as it first appears, in one style after the other."""

    def __init__(self, studio, volume, size_px):
        self._studio, self._volume, self._size = studio, volume, size_px
        self._masks = {}
        width, height = size_px
        stripe_px = round(width / 10 / 2) * 2  # for pictures that cost much
        self._stripe = slice((width - stripe_px) // 2, (width + stripe_px) // 2)
        self._turned = slice(width // 3, width - width // 3)

    def cells(self, styles):
        return [*(self._cell(style) for style in styles), self._isoluminant()]

    def _cell(self, style):
        scene = self._studio.styles[style]
        masks = self._masks_of(scene)
        drawn = self._drawn(scene)
        figures = style_figures.tones(drawn, masks)
        if style == RAMP_STYLE:
            alone = self._drawn(scene, style_scenes.shading_alone(scene))
            figures |= style_figures.ramp_halves(alone, masks, scene["focus"]["shading"])
        figures |= self._under_two_lights(scene, drawn, masks)
        figures |= self._at_two_sizes(scene, drawn, masks)
        return Cell(style, self._volume, figures)

    def _isoluminant(self):
        scene = self._studio.styles[ISOLUMINANT]
        figures = style_figures.equal_luma(self._drawn(scene), self._masks_of(scene))
        return Cell(ISOLUMINANT, self._volume, figures)

    def _masks_of(self, scene):
        cut = str(style_scenes.cut_of(scene))
        if cut not in self._masks:
            self._masks[cut] = style_scenes.masks(self._studio, scene, *self._size)
        return self._masks[cut]

    def _under_two_lights(self, scene, drawn, masks):
        """Of the middle alone, where the lens is."""
        middle, size = self._turned, self._width_of(self._turned)
        plain = style_scenes.without_lines(scene)
        turned = {"light": OTHER_LIGHT}
        return style_figures.turned_lines(
            (drawn[:, middle], self._drawn(scene, turned, size_px=size)),
            (
                self._drawn(scene, plain, size_px=size),
                self._drawn(scene, plain, turned, size_px=size),
            ),
            scene,
            masks.cropped(middle),
        )

    def _at_two_sizes(self, scene, drawn, masks):
        """Of a stripe: the larger picture has sixteen times the pixels."""
        stripe = self._stripe
        large = [TIMES * n for n in self._width_of(stripe)]
        lines = style_scenes.lines_alone(scene)
        return style_figures.sizes(
            drawn[:, stripe],
            self._drawn(scene, size_px=large),
            *(
                1 - self._drawn(scene, lines, size_px=s)[..., 1]
                for s in (self._width_of(stripe), large)
            ),
            masks.covered[:, stripe],
        )

    def _width_of(self, columns):
        return columns.stop - columns.start, self._size[1]

    def _drawn(self, *scenes, size_px=None):
        for scene in scenes:
            self._studio.change(scene)
        return self._studio.picture(*(size_px or self._size))


def _toon_cells(cutaway, studio, styles, side_px):
    """Of the styles whose tones have a step."""
    stepped = [
        s
        for s in styles
        if any(style_scenes.is_stepped(studio.styles[s][b]) for b in style_scenes.BRANCHES)
    ]
    if not stepped:
        return []
    with tempfile.TemporaryDirectory() as folder:
        made_bodies.write(folder)
        with Studio(cutaway, folder) as bodies:
            bodies.wait_for([made_bodies.SMOOTH, made_bodies.NOISY])
            return [_toon_cell(bodies, style, side_px) for style in stepped]


def _toon_cell(bodies, style, side_px):
    smooth, noisy = (
        _toon_lengths(bodies, bodies.styles[style], volume, side_px)
        for volume in (made_bodies.SMOOTH, made_bodies.NOISY)
    )
    figures = {
        f"toon_{branch}": noisy[branch] / smooth[branch] for branch in smooth if smooth[branch] > 0
    }
    return Cell(style, "made body", figures)


def _toon_lengths(bodies, style, volume, side_px):
    """Under the same lens, camera and values: what the noise makes of the first look is another
    question."""
    bodies.open(volume)
    for scene in (style, made_bodies.VIEW, made_bodies.SURFACES):
        bodies.change(scene)
    bodies.change(style_scenes.shading_alone(style))
    drawn = bodies.picture(side_px, side_px)
    masks = style_scenes.masks(bodies, style, side_px, side_px)
    shown = {"focus": masks.focus, "context": masks.skin}
    return {
        branch: style_figures.toon_length(drawn, shown[branch], style[branch]["shading"])
        for branch in style_scenes.BRANCHES
        if style_scenes.is_stepped(style[branch])
    }
