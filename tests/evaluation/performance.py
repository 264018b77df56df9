"""The dissertation's table 5.3 measured on this renderer, beside its own figures."""
import json
import subprocess
from dataclasses import dataclass

import acceptance

SIZE = "512x512"
EDGE_VOXELS = 256  # of the phantoms in the table
SMALL_EDGE_VOXELS = 128  # of those that show whether the filters' cost depends on the volume
LEAST_FRAMES = 200
# Half of it is for the stages, whose medians need some dozen frames.
SECONDS_A_CASE = 4
# Frames per second as the dissertation states them; its hardware, resolution and volumes are not.
STATED_FPS = {
    "phantom:head": (22, 18, 15, 17, 15),
    "phantom:knees": (15, 13, 12, 11, 10),
    "phantom:abdomen": (14, 10, 9, 10, 9),
}


@dataclass(frozen=True)
class Cell:
    """One configuration on one volume; times in ms, medians over the frames; device_ms: of the
    renderer alone, by its own timer; stages in the pipeline's order."""

    case: str
    frames: int
    median_ms: float
    p95_ms: float
    device_ms: float
    stages_ms: dict
    stated_fps: int


@dataclass(frozen=True)
class Table:
    """rows: {volume: [Cell]}. criteria: what the figures are held against."""

    machine: dict
    size: str
    edge_voxels: int
    rows: dict
    criteria: list


def make(benchmark, outdir, progress):
    """Runs the benchmark at one size; keeps its figures as performance.json."""
    measured = _measure(benchmark, outdir / "performance.json", EDGE_VOXELS, [], progress)
    small = _measure(
        benchmark,
        outdir / "performance-small.json",
        SMALL_EDGE_VOXELS,
        ["--cases", acceptance.BOTH_FILTERS],
        progress,
    )
    rows = {
        volume: _row(_frames_of(measured, volume), stated) for volume, stated in STATED_FPS.items()
    }
    small_stages = {volume: _frames_of(small, volume)[0]["stages_ms"] for volume in STATED_FPS}
    criteria = acceptance.judge(rows, small_stages, LEAST_FRAMES)
    return Table(measured["machine"], SIZE, EDGE_VOXELS, rows, criteria)


def _measure(benchmark, file, edge_voxels, options, progress):
    progress(f"performance: phantoms of {edge_voxels} voxels an edge")
    # Line by line, so that progress shows while it runs and not when it is over.
    command = [
        "stdbuf",
        "-oL",
        benchmark,
        "--sizes",
        SIZE,
        "--phantom-size",
        edge_voxels,
        "--json",
        file,
    ]
    command += ["--least-frames", LEAST_FRAMES, "--seconds", SECONDS_A_CASE, *options]
    with subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, text=True) as running:
        for line in running.stdout:
            if line.strip():
                progress(f"performance: {line.strip()}")
    if running.returncode != 0:
        raise subprocess.CalledProcessError(running.returncode, command)
    return json.loads(file.read_text())


def _frames_of(measured, volume):
    """A phantom's id names its size, behind an @, where that is not the usual one."""
    return [f for f in measured["frames"] if f["volume"].split("@")[0] == volume]


def _row(frames, stated):
    return [
        Cell(
            f["case"],
            f["frames"],
            f["median_ms"],
            f["p95_ms"],
            f["device_ms"],
            f["stages_ms"],
            fps,
        )
        for f, fps in zip(frames, stated, strict=True)
    ]
