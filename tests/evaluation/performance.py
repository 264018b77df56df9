"""The dissertation's table 5.3 measured on this renderer, beside its own figures."""
import json
import subprocess
from dataclasses import dataclass

import acceptance

# Frames per second as the dissertation states them; its hardware, resolution and volumes are not.
# The benchmark's other cases are not the dissertation's.
CASES = (
    acceptance.CONTROL,
    acceptance.LENS,
    "lens + Kuwahara",
    "lens + Sobel",
    acceptance.BOTH_FILTERS,
)
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


def make(benchmark, extent, outdir, progress):
    """Runs the benchmark at one size; keeps its figures as performance.json. extent: Benchmark."""
    measured = _measure(
        benchmark, extent, outdir / "performance.json", extent.edge_voxels, CASES, progress
    )
    small = _measure(
        benchmark,
        extent,
        outdir / "performance-small.json",
        extent.small_edge_voxels,
        [acceptance.BOTH_FILTERS],
        progress,
    )
    rows = {volume: _row(measured, volume) for volume in extent.phantoms}
    small_stages = {
        volume: _frames_of(small, volume, acceptance.BOTH_FILTERS)["stages_ms"]
        for volume in extent.phantoms
    }
    criteria = acceptance.judge(rows, small_stages, extent.least_frames)
    return Table(measured["machine"], extent.size, extent.edge_voxels, rows, criteria)


def _measure(benchmark, extent, file, edge_voxels, cases, progress):
    progress(f"performance: phantoms of {edge_voxels} voxels an edge")
    # Line by line, so that progress shows while it runs and not when it is over.
    command = ["stdbuf", "-oL", benchmark]
    command += ["--sizes", extent.size, "--phantom-size", edge_voxels]
    command += ["--volumes", *extent.phantoms, "--cases", *cases]
    command += ["--least-frames", extent.least_frames, "--seconds", extent.seconds_a_case]
    command += ["--json", file]
    with subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, text=True) as running:
        for line in running.stdout:
            if line.strip():
                progress(f"performance: {line.strip()}")
    if running.returncode != 0:
        raise subprocess.CalledProcessError(running.returncode, command)
    return json.loads(file.read_text())


def _frames_of(measured, volume, case):
    """A phantom's id names its size, behind an @, where that is not the usual one. LookupError for
    a case that was not measured."""
    for frames in measured["frames"]:
        if frames["volume"].split("@")[0] == volume and frames["case"] == case:
            return frames
    told = ", ".join(sorted({f"{f['volume']}: {f['case']}" for f in measured["frames"]}))
    raise LookupError(f"the benchmark measured no case '{case}' of {volume}; it measured {told}")


def _row(measured, volume):
    frames = [_frames_of(measured, volume, case) for case in CASES]
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
        for f, fps in zip(frames, STATED_FPS[volume], strict=True)
    ]
