"""What a style's picture of a volume is held against. Source: the product's own aims for its
illustration styles."""
from dataclasses import dataclass

FEWEST_PX = 50  # of a kind of pixel: fewer tell nothing


@dataclass(frozen=True)
class Limit:
    """text: what is asked. least, most: of the figure; None: no such bound. form: how it is
    told."""

    text: str
    least: float | None = None
    most: float | None = None
    form: str = ".2f"

    def holds(self, figure):
        return (self.least is None or figure >= self.least) and (
            self.most is None or figure <= self.most
        )

    def told(self, figure):
        return f"{figure:{self.form}}"


LIMITS = {
    "rim": Limit(
        "share of the lens' rim whose step is below 4/255: at most 5 %", most=0.05, form=".1%"
    ),
    "wall_skin": Limit("median L* of the wall at least 22 from the skin's", least=22, form=".1f"),
    "wall_focus": Limit("median L* of the wall at least 22 from the focus'", least=22, form=".1f"),
    "context_tone": Limit(
        "luma of the context, 5th to 95th percentile: at least 0.15 wide", least=0.15
    ),
    "context_calm": Limit(
        "RMS contrast at the scale of 1 % of the height: of the context at most 0.7 of the focus'",
        most=0.7,
    ),
    "cool_half": Limit(
        "flagship's shading: share of the focus in the cool half of its ramp, at least 20 %",
        least=0.2,
        form=".0%",
    ),
    "warm_half": Limit("the same in the warm half", least=0.2, form=".0%"),
    "equal_luma": Limit(
        "isoluminant: luma of the focus, 5th to 95th percentile: at most 0.25 wide", most=0.25
    ),
    "turned_lines": Limit(
        "line pixels, rim apart, that change when only the light turns: none", most=0, form=".0f"
    ),
    "size": Limit(
        "mean difference of 360 and 1440 px of height over covered pixels: at most 6/255",
        most=6,
        form=".1f",
    ),
    "line_width": Limit(
        "line width per height at 1440 px, of that at 360 px: within 15 %", least=0.85, most=1.15
    ),
    "toon_context": Limit(
        "toon boundary with 15 % noise, of that without: context, at most 1.15", most=1.15
    ),
    "toon_focus": Limit("the same of the focus", most=1.15),
}


@dataclass(frozen=True)
class Cell:
    """One style on one volume: figures by the limits' names; a limit is missing where nothing
    tells."""

    style: str
    volume: str
    figures: dict

    def failing(self):
        return [name for name, figure in self.figures.items() if not LIMITS[name].holds(figure)]
