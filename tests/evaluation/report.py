"""The report: one HTML page beside its pictures, and the figures as JSON."""
import json
from dataclasses import asdict
from html import escape

from report_performance import performance
from report_saliency import saliency_study
from report_styles import style_study

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 80rem; padding: 0 1rem; color: #1a1a1a }
img { max-width: 100%; height: auto; border: 1px solid #ddd } figure { margin: 2rem 0 }
table { border-collapse: collapse; margin: 1rem 0 } td, th { border: 1px solid #ccc; padding: 0.3rem 0.7rem; text-align: right }
th:first-child, td:first-child { text-align: left } .verdict { background: #f4f1ea; padding: 1rem; white-space: pre-line }
.failing { background: #f3d5d0; font-weight: bold }
small { color: #666 }
"""


def write(outdir, renderer, sheets, styles, study, table, minutes, extent):
    """Writes report.html; returns its path."""
    body = "\n".join(
        [
            "<h1>Evaluation of focus + context illustration</h1>",
            f"<p>Renderer: {escape(renderer)}. Made in {minutes:.1f} minutes. Not for diagnostic use.</p>",
            *_extent(extent),
            *_gallery(sheets),
            *style_study(styles),
            *saliency_study(study),
            *performance(table),
        ]
    )
    page = outdir / "report.html"
    page.write_text(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Evaluation</title><style>{STYLE}</style>'
        f"<body>{body}</body></html>"
    )
    return page


def _extent(extent):
    if extent.is_quick:
        yield (
            '<p class="verdict"><b>The quick form</b>, which shows that every part works: one small '
            f"phantom, {extent.units} units, small pictures, few frames. None of its figures is a "
            "claim.</p>"
        )


def write_figures(outdir, study, styles):
    """Writes saliency.json and styles.json: early, so that they are there whatever becomes of the rest."""
    (outdir / "styles.json").write_text(json.dumps(styles.as_dict(), indent=1))
    (outdir / "saliency.json").write_text(json.dumps(_plain(study), indent=1))


def _plain(study):
    return {
        "outcome": study.verdict.outcome,
        "models": {model: result.as_dict() for model, result in study.results.items()},
        "requirements": [{**asdict(r), "holds": r.holds} for r in study.requirements],
    }


def _gallery(sheets):
    yield "<h2>Gallery</h2>"
    for made in sheets:
        yield (
            f'<figure><img src="{made.file}" alt="{escape(made.figure.title)}">'
            f"<figcaption><b>{escape(made.figure.title)}.</b> {escape(made.figure.caption)}</figcaption></figure>"
        )
