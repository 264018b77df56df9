"""The dissertation's table 5.3 measured on this renderer, beside its own figures."""
import json
import subprocess
from dataclasses import dataclass

SIZE = "512x512"
# Frames per second as the dissertation states them; its hardware, resolution and volumes are not.
STATED_FPS = {
    "phantom:head": (22, 18, 15, 17, 15),
    "phantom:knees": (15, 13, 12, 11, 10),
    "phantom:abdomen": (14, 10, 9, 10, 9),
}


@dataclass(frozen=True)
class Cell:
    """One configuration on one volume; times in ms, medians; stages in the pipeline's order."""

    case: str
    median_ms: float
    p95_ms: float
    stages_ms: dict
    stated_fps: int


@dataclass(frozen=True)
class Table:
    machine: dict
    size: str
    rows: dict


def make(benchmark, outdir):
    """Runs the benchmark at one size; keeps its figures as performance.json."""
    file = outdir / "performance.json"
    subprocess.run(
        [benchmark, "--sizes", SIZE, "--seconds", "3", "--json", file],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    measured = json.loads(file.read_text())
    rows = {volume: _row(measured, volume, stated) for volume, stated in STATED_FPS.items()}
    return Table(measured["machine"], SIZE, rows)


def _row(measured, volume, stated):
    frames = [frame for frame in measured["frames"] if frame["volume"] == volume]
    return [
        Cell(f["case"], f["median_ms"], f["p95_ms"], f["stages_ms"], fps)
        for f, fps in zip(frames, stated, strict=True)
    ]
