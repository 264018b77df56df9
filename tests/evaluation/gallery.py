"""One sheet for each of the dissertation's figures, on every volume."""
from dataclasses import dataclass

import saliency
from figures import FIGURES, Figure
from sheets import sheet


@dataclass(frozen=True)
class GallerySheet:
    figure: Figure
    file: str


def make(studio, volumes, extent, outdir, progress):
    """Draws every figure; volume by volume, so that each is opened once."""
    rows = {figure.name: [] for figure in FIGURES}
    for volume in volumes:
        progress(f"gallery: {volume}")
        start = studio.open(volume)
        for figure in FIGURES:
            rows[figure.name].append(
                [_picture(studio, start, *c[1:], extent.sheet_px) for c in figure.columns]
            )
    made = []
    for figure in FIGURES:
        file = f"figure-{figure.name}.png"
        labels = [label for label, _, _ in figure.columns]
        saliency.write_picture(outdir / file, sheet(rows[figure.name], volumes, labels))
        made.append(GallerySheet(figure, file))
    return made


def _picture(studio, start, style, changes, size_px):
    """The volume's first look, in another style."""
    studio.change({**start, **studio.styles[style]})
    studio.change({"lens": {k: start["lens"][k] for k in ("centre_mm", "radius_mm")}})
    studio.change(changes)
    return studio.picture(*size_px)
