"""The report of a soak: what was judged, and every figure over time."""
from html import escape

WIDTH_PX, HEIGHT_PX, MARGIN_PX = 860, 220, 48
MOST_POINTS = 2000
STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 60rem; padding: 0 1rem; color: #1a1a1a }
table { border-collapse: collapse } td, th { border: 1px solid #ccc; padding: .3rem .7rem; text-align: left }
svg { width: 100%; height: auto; background: #fafafa } text { font-size: 12px; fill: #555 }
polyline { fill: none; stroke: #2a6f97; stroke-width: 1.2 } line { stroke: #bbb } .grows { color: #a4161a; font-weight: bold }
"""


def report(title, facts, verdicts, plots):
    """facts: sentences. plots: (title, unit, samples)."""
    rows = "".join(_row(verdict) for verdict in verdicts)
    return (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style>'
        f"<h1>{escape(title)}</h1>{''.join(f'<p>{escape(fact)}</p>' for fact in facts)}"
        "<table><tr><th>figure<th>median<th>grown after the warm-up<th>allowed<th></tr>"
        f"{rows}</table>{''.join(plot(*each) for each in plots)}</html>\n"
    )


def _row(verdict):
    limit = verdict.limit
    outcome = "flat" if verdict.holds else '<span class="grows">GROWS</span>'
    figures = "".join(
        f"<td>{value:.1f} {limit.unit}" for value in (verdict.median, verdict.grown, verdict.allowed)
    )
    return f"<tr><td>{limit.figure}{figures}<td>{outcome}</tr>"


def plot(title, unit, samples):
    """A line over time as SVG, its y axis from 0."""
    if len(samples) < 2:
        return f"<h2>{escape(title)}</h2><p>Nothing was measured.</p>"
    samples = samples[:: -(-len(samples) // MOST_POINTS)]
    last_s, top = samples[-1][0], max(value for _, value in samples) * 1.1 or 1

    def place(second, value):
        x = MARGIN_PX + (WIDTH_PX - 2 * MARGIN_PX) * second / last_s
        return f"{x:.1f},{HEIGHT_PX - 30 - (HEIGHT_PX - 50) * value / top:.1f}"

    points = " ".join(place(*sample) for sample in samples)
    base = HEIGHT_PX - 30
    return (
        f'<h2>{escape(title)}</h2><svg viewBox="0 0 {WIDTH_PX} {HEIGHT_PX}" role="img" aria-label="{escape(title)}">'
        f'<line x1="{MARGIN_PX}" x2="{WIDTH_PX - MARGIN_PX}" y1="{base}" y2="{base}"/>'
        f'<text x="4" y="24">{top / 1.1:.0f} {unit}</text><text x="4" y="{base}">0</text>'
        f'<text x="{WIDTH_PX - MARGIN_PX}" y="{HEIGHT_PX - 8}" text-anchor="end">{last_s:.0f} s</text>'
        f'<polyline points="{points}"/></svg>'
    )
