"""The report's part on performance."""
from html import escape

from html_table import table, yes_no


def performance(measured):
    yield "<h2>Performance</h2>"
    machine = measured.machine
    yield (
        f"<p>{escape(machine['renderer'])} on {escape(machine['processor'])}, {machine['cores']} "
        f"cores; {measured.size} pixels, one ray a pixel, phantoms of {measured.edge_voxels} voxels "
        "an edge. A frame is timed from the scene to the JPEG. The dissertation's own figures stand "
        "in brackets; its hardware, resolution and volumes are not stated, so only the ratios "
        "within a row compare.</p>"
    )
    yield table(
        ("criterion", "", "measured"),
        [(c.text, yes_no(c.holds), c.told) for c in measured.criteria],
    )
    yield from _frames(measured.rows)
    yield from _stages(measured.rows)


def _frames(rows):
    cases = [cell.case for cell in next(iter(rows.values()))]
    told = {
        "frames per second": lambda c: f"{1000 / c.median_ms:.1f} ({c.stated_fps})",
        "ms a frame, median": lambda c: f"{c.median_ms:.1f} ({1000 / c.stated_fps:.1f})",
        "ms a frame, 95th percentile": lambda c: f"{c.p95_ms:.1f}",
        "ms of the renderer by its timer, median": lambda c: f"{c.device_ms:.1f}",
        "frames": lambda c: c.frames,
    }
    for what, of_cell in told.items():
        yield table(
            (what, *cases),
            [(volume, *(of_cell(cell) for cell in row)) for volume, row in rows.items()],
        )


def _stages(rows):
    for volume, row in rows.items():
        stages = list(dict.fromkeys(stage for cell in row for stage in cell.stages_ms))
        yield table(
            (f"{volume}: ms by stage, medians", *stages),
            [(c.case, *(f"{c.stages_ms.get(s, 0):.2f}" for s in stages)) for c in row],
        )
