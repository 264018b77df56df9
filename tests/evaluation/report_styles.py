"""The report's part on what the styles' tones, rims and lines measure."""
from html import escape

from html_table import Failing, table
from style_limits import LIMITS


def style_study(study):
    yield "<h2>Styles, measured</h2>"
    yield f'<p class="verdict">{escape(_summary(study))}</p>'
    for name, limit in LIMITS.items():
        cells = [cell for cell in study.cells if name in cell.figures]
        if cells:
            yield f"<h3>{escape(limit.text[0].upper() + limit.text[1:])}</h3>"
            yield _table(name, limit, cells)


def _summary(study):
    figures = sum(len(cell.figures) for cell in study.cells)
    failing = [(cell, name) for cell in study.cells for name in cell.failing()]
    words = [f"{len(failing)} of {figures} figures are beyond their limit, and marked below."]
    words += [
        f"{cell.style} on {cell.volume}: {LIMITS[name].text}; {LIMITS[name].told(cell.figures[name])}"
        for cell, name in failing
    ]
    if study.lensless:
        words.append(f"Not measured, as its first scene has no lens: {', '.join(study.lensless)}")
    return "\n".join(words)


def _table(name, limit, cells):
    styles, volumes = (
        list(dict.fromkeys(getattr(c, k) for c in cells)) for k in ("style", "volume")
    )
    figures = {(c.style, c.volume): c.figures[name] for c in cells}
    return table(
        ("style", *volumes),
        [(s, *(_cell(figures.get((s, v)), limit) for v in volumes)) for s in styles],
    )


def _cell(figure, limit):
    if figure is None:
        return ""
    return limit.told(figure) if limit.holds(figure) else Failing(limit.told(figure))
