"""The dissertation's figures as lists of styles: one sheet each, a row for each volume."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """name: of its file. columns: (label, style of server/styles, changes to it)."""

    name: str
    title: str
    caption: str
    columns: tuple


def _styles(*named):
    return tuple((label, style, {}) for label, style in named)


FIGURES = (
    Figure(
        "tone",
        "Flexible tone shading",
        "From two flat tones to a smooth ramp with one parameter.",
        _styles(("detail 0", "tone-toon"), ("detail 0.5", "tone-half"), ("detail 1", "tone-smooth")),
    ),
    Figure(
        "gooch",
        "Gooch shading against the control",
        "The classic warm-to-cool light beside Phong's.",
        _styles(("Gooch", "gooch-classic"), ("Phong", "phong-control")),
    ),
    Figure(
        "kuwahara",
        "Kuwahara abstraction of the context",
        "Windows of 2, 5, 7 and 10 pixels; 2 and 3 are one filter, 10 rounds up to 11.",
        _styles(*((f"window {w}", f"kuwahara-{w}") for w in (2, 5, 7, 10))),
    ),
    Figure(
        "sobel-bright",
        "Sobel lines on the focus, brightened",
        "Strength 0.3, 0.7 and 1.",
        _styles(*((f"strength {s / 10}", f"sobel-{s:02d}-bright") for s in (3, 7, 10))),
    ),
    Figure(
        "sobel-dark",
        "Sobel lines on the focus, darkened",
        "Strength 0.3, 0.7 and 1.",
        _styles(*((f"strength {s / 10}", f"sobel-{s:02d}-dark") for s in (3, 7, 10))),
    ),
    Figure(
        "toon-sobel",
        "Toon with lines",
        "Two flat tones and dark lines on both branches.",
        _styles(("toon + Sobel", "toon-sobel")),
    ),
    Figure(
        "lenses",
        "The lenses",
        "The same look without a lens, under the Magic Lens and with the 3-D cutaway.",
        (
            ("no lens", "flagship", {"lens": {"mode": "none"}}),
            ("Magic Lens", "magic-lens", {}),
            ("cutaway, tone only", "cutaway", {}),
        ),
    ),
    Figure(
        "flagship",
        "The flagship style and its controls",
        "Focus in smooth tones with lines, context in flat tones: against Phong with and without the lens.",
        (
            ("flagship", "flagship", {}),
            ("Phong, cutaway", "phong-control", {}),
            ("Phong, no lens", "phong-control", {"lens": {"mode": "none"}}),
        ),
    ),
)
