"""The report: one HTML page beside its pictures, and the figures as JSON."""
import json
from html import escape

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 80rem; padding: 0 1rem; color: #1a1a1a }
img { max-width: 100%; height: auto; border: 1px solid #ddd } figure { margin: 2rem 0 }
table { border-collapse: collapse; margin: 1rem 0 } td, th { border: 1px solid #ccc; padding: 0.3rem 0.7rem; text-align: right }
th:first-child, td:first-child { text-align: left } .verdict { background: #f4f1ea; padding: 1rem; white-space: pre-line }
small { color: #666 }
"""


def write(outdir, renderer, sheets, study, table, minutes):
    """Writes report.html and saliency.json; returns the page's path."""
    plain = {model: result.as_dict() for model, result in study.results.items()}
    (outdir / "saliency.json").write_text(json.dumps(plain, indent=1))
    body = "\n".join(
        [
            "<h1>Evaluation of focus + context illustration</h1>",
            f"<p>Renderer: {escape(renderer)}. Made in {minutes:.1f} minutes. Not for diagnostic use.</p>",
            *_gallery(sheets),
            *_saliency(study),
            *_performance(table),
        ]
    )
    page = outdir / "report.html"
    page.write_text(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Evaluation</title><style>{STYLE}</style>'
        f"<body>{body}</body></html>"
    )
    return page


def _gallery(sheets):
    yield "<h2>Gallery</h2>"
    for made in sheets:
        yield (
            f'<figure><img src="{made.file}" alt="{escape(made.figure.title)}">'
            f"<figcaption><b>{escape(made.figure.title)}.</b> {escape(made.figure.caption)}</figcaption></figure>"
        )


def _saliency(study):
    yield "<h2>Saliency</h2>"
    yield f'<p class="verdict">{escape(study.verdict.text)}</p>'
    for model, result in study.results.items():
        yield f"<h3>{escape(model)}</h3>"
        yield _table(
            ("condition", "NSS", "AUC", "mass ratio", "first winner in the focus"),
            [
                (c, *(f"{m[k]:.3f}" for k in ("nss", "auc", "mass_ratio")), f"{result.hit_rates[c]:.0%}")
                for c, m in result.means.items()
            ],
        )
        yield _table(
            ("difference of NSS", "mean", "95 % over units", "95 % over data sets", "sign-flip p", "Wilcoxon p", "Cliff's delta"),
            [_difference(c) for (_, measure), c in result.comparisons.items() if measure == "nss"],
        )
        yield _table(
            ("first winner", "both", "first only", "second only", "neither", "McNemar p"),
            [
                (f"{h.first} against {h.second}", h.both, h.only_first, h.only_second, h.neither, f"{h.mcnemar_p:.3g}")
                for h in result.hits.values()
            ],
        )
    yield "<h3>Controls (primary model, means over units)</h3>"
    yield _table(
        ("condition", "NSS on the focus", "NSS on it moved elsewhere", "detail in the focus", "detail in the context"),
        [
            (c.condition, f"{c.nss:.3f}", f"{c.nss_elsewhere:.3f}", f"{c.detail_focus:.4f}", f"{c.detail_context:.4f}")
            for c in study.controls
        ],
    )
    for volume, file in study.sheet_files:
        yield (
            f'<figure><img src="{file}" alt="Most salient regions, {escape(volume)}">'
            f"<figcaption>The most salient regions in order, {escape(volume)}: circles at the winners, "
            "outlines of their proto-objects.</figcaption></figure>"
        )


def _difference(c):
    def interval(pair):
        return f"{pair[0]:+.3f} to {pair[1]:+.3f}"

    return (
        f"{c.first} minus {c.second}", f"{c.mean:+.3f}", interval(c.units_interval), interval(c.clustered_interval),
        f"{c.sign_flip_p:.2g}", f"{c.wilcoxon_p:.2g}", f"{c.cliffs_delta:+.2f}",
    )  # fmt: skip


def _performance(table):
    yield "<h2>Performance</h2>"
    machine = table.machine
    yield (
        f"<p>{escape(machine['renderer'])} on {escape(machine['processor'])}, {machine['cores']} cores; {table.size} "
        "pixels, one ray a pixel, volumes of 256 voxels an edge; medians. The dissertation's own figures stand in "
        "brackets; its hardware, resolution and volumes are not stated, so only the ratios within a row compare.</p>"
    )
    cases = [cell.case for cell in next(iter(table.rows.values()))]
    yield _table(
        ("frames per second", *cases),
        [
            (volume, *(f"{1000 / cell.median_ms:.1f} ({cell.stated_fps})" for cell in row))
            for volume, row in table.rows.items()
        ],
    )
    yield _table(
        ("ms a frame, p95", *cases),
        [
            (volume, *(f"{cell.median_ms:.1f}, {cell.p95_ms:.1f}" for cell in row))
            for volume, row in table.rows.items()
        ],
    )
    for volume, row in table.rows.items():
        stages = list(dict.fromkeys(stage for cell in row for stage in cell.stages_ms))
        yield _table(
            (f"{volume}: ms by stage", *stages),
            [(cell.case, *(f"{cell.stages_ms.get(s, 0):.2f}" for s in stages)) for cell in row],
        )


def _table(head, rows):
    cells = "".join(f"<th>{escape(str(cell))}</th>" for cell in head)
    lines = "".join("<tr>" + "".join(f"<td>{escape(str(c))}</td>" for c in row) + "</tr>" for row in rows)
    return f"<table><tr>{cells}</tr>{lines}</table>"
