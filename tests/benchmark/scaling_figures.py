"""From the reports of cutaway-benchmark and cutaway-load to rows in which each figure stands beside its yardstick."""

REFERENCE_EDGE = 256


def doublings(most):
    """1, 2, 4 and so on, and the most."""
    return [1 << power for power in range(most.bit_length()) if 1 << power < most] + [most]


def ratio(value, reference):
    return None if value is None or not reference else value / reference


def with_ratio(rows, name, figure, same, is_reference):
    """Adds `name`: the figure by that of the reference row among those that agree in `same`; None without one."""
    references = {tuple(map(str, map(row.get, same))): row for row in reversed(rows) if is_reference(row)}
    for row in rows:
        reference = references.get(tuple(map(str, map(row.get, same))), {})
        row[name] = ratio(row[figure], reference.get(figure))
    return rows


def volume_rows(report):
    rows = [{"edge_voxels": max(frame["size_voxels"]), **_frame(frame)} for frame in report["frames"]]
    edges = {row["edge_voxels"] for row in rows}
    reference = REFERENCE_EDGE if REFERENCE_EDGE in edges else min(edges)
    for row in rows:
        row["reference_voxels"] = reference
    return with_ratio(rows, "times_reference", "median_ms", ["case"], lambda row: row["edge_voxels"] == reference)


def pixel_rows(report):
    rows = [{**_frame(frame), "pixels": frame["size_px"][0] * frame["size_px"][1]} for frame in report["frames"]]
    fewest = min(row["pixels"] for row in rows)
    for row in rows:
        row["ms_a_megapixel"] = 1e6 * row["median_ms"] / row["pixels"]
        row["times_pixels"] = row["pixels"] / fewest
    return with_ratio(rows, "times_smallest", "median_ms", ["case"], lambda row: row["pixels"] == fewest)


def _frame(frame):
    return {name: frame[name] for name in ("case", "size_px", "frames", "median_ms", "p95_ms", "device_ms")}


def jpeg_rows(report):
    names = ("size_px", "chroma", "quality", "jpeg_bytes", "threads", "pictures_per_second", "mb_per_second")
    rows = [{name: row[name] for name in names} for row in report["jpeg"]]
    for row in rows:
        row["mb_per_second_a_thread"] = row["mb_per_second"] / row["threads"]
    return with_ratio(
        rows, "times_one_thread", "pictures_per_second", ["size_px", "chroma", "quality"],
        lambda row: row["threads"] == 1,
    )  # fmt: skip


def session_rows(reports):
    rows = [_session_row(report) for report in reports]
    with_ratio(rows, "frames_times_one_session", "frames_per_second", [], lambda row: row["clients"] == 1)
    return with_ratio(rows, "p95_times_one_session", "latency_p95_ms", [], lambda row: row["clients"] == 1)


def _session_row(report):
    together = report["together"]
    latency, sizes = together["latency_ms"], together["bytes_per_frame"]
    return {
        "clients": report["clients_count"],
        "frames_per_second": sum(client["frames_per_second"] or 0.0 for client in report["clients"]),
        "least_frames_per_second": together["least_frames_per_second"],
        "latency_p50_ms": latency.get("p50"),
        "latency_p95_ms": latency.get("p95"),
        "bytes_a_frame": sizes.get("mean"),
        "render_p50_ms": together["render_ms"].get("p50"),
        "faults": {
            name: together[name] for name in ("errors", "stale_frames", "disconnects", "clients_without_frame")
        },
    }  # fmt: skip


def _times(value):
    return "-" if value is None else f"{value:.2f}"


def _figure(value):
    return "-" if value is None else f"{value:.0f}" if value >= 1000 else f"{value:.1f}"


def _size(row):
    return "{} x {}".format(*row["size_px"])


def _volume_line(row):
    return [row["case"], row["edge_voxels"], _figure(row["median_ms"]), _figure(row["p95_ms"]),
            _figure(row["device_ms"]), _times(row["times_reference"])]  # fmt: skip


def _pixel_line(row):
    return [row["case"], _size(row), _figure(row["median_ms"]), _figure(row["p95_ms"]), _figure(row["device_ms"]),
            _figure(row["ms_a_megapixel"]), _times(row["times_pixels"]), _times(row["times_smallest"])]  # fmt: skip


def _jpeg_line(row):
    return [f"{row['chroma']} at {row['quality']}", _size(row), row["threads"], _figure(row["pictures_per_second"]),
            _figure(row["mb_per_second"]), _figure(row["mb_per_second_a_thread"]),
            _times(row["times_one_thread"])]  # fmt: skip


def _session_line(row):
    faults = ", ".join(f"{count} {name}" for name, count in row["faults"].items() if count)
    return [row["clients"], _figure(row["frames_per_second"]), _figure(row["least_frames_per_second"]),
            _figure(row["latency_p50_ms"]), _figure(row["latency_p95_ms"]), _figure(row["render_p50_ms"]),
            _figure(row["bytes_a_frame"]), _times(row["frames_times_one_session"]),
            _times(row["p95_times_one_session"]), faults or "none"]  # fmt: skip


FRAME_HEAD = ["median ms", "95th", "renderer"]
TABLES = {
    "volumes": (
        "Frame time against the volume; x is times that of {reference_voxels}",
        ["case", "edge", *FRAME_HEAD, "x"], _volume_line,
    ),
    "pixels": (
        "Frame time against the picture",
        ["case", "size", *FRAME_HEAD, "ms/Mpixel", "x pixels", "x ms"], _pixel_line,
    ),
    "jpeg": (
        "JPEG from planes, MB of planes",
        ["chroma, quality", "size", "threads", "pictures/s", "MB/s", "MB/s each", "x 1 thread"], _jpeg_line,
    ),
    "sessions": (
        "Sessions that never rest; input to frame, ms",
        ["sessions", "frames/s", "least", "p50", "p95", "render ms", "bytes", "x frames", "x p95", "faults"],
        _session_line,
    ),
}  # fmt: skip


def table(title, head, lines):
    """Columns as wide as what is in them, the first to the left."""
    cells = [head, *([str(cell) for cell in line] for line in lines)]
    widths = [max(map(len, column)) for column in zip(*cells)]
    return "\n".join([title, *("  " + "  ".join(
        cell.ljust(width) if column == 0 else cell.rjust(width)
        for column, (cell, width) in enumerate(zip(line, widths))
    ).rstrip() for line in cells)])  # fmt: skip


def tables(measured):
    machine = measured["machine"]
    software = " (software)" if machine["software_renderer"] else ""
    parts = [f"{machine['processor']}, {machine['cores']} cores; {machine['renderer']}{software}"]
    for name, (title, head, line) in TABLES.items():
        if name in measured:
            rows = measured[name]
            parts.append(table(title.format(**rows[0]), head, [line(row) for row in rows]))
    return "\n\n".join(parts)
