"""How the cost of a frame grows with the volume and with the pixels, JPEG with threads, and a server with sessions.

Measures and prints; asserts nothing but that it could measure. Every figure stands beside one of the same run: the
volume of 256 voxels an edge, the smallest picture, one thread, one session. What is being done, to standard error.

Usage: scaling.py --binaries DIR [--json FILE] [--parts PART...] [...]    (tests/benchmark/scaling builds and starts it)
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import scaling_figures as figures

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS / "end_to_end"))
from wire import Server  # noqa: E402

CASES = ("Phong, no lens", "flagship")  # the control and the flagship


def say(words):
    print(words, file=sys.stderr, flush=True)


class Run:
    """The programs that are measured, and where their reports go."""

    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.gpu = ["--require-gpu"] if options.require_gpu else []

    def binary(self, name):
        return str(self.options.binaries / name)

    def benchmark(self, *arguments):
        """The report of cutaway-benchmark, whose table goes to standard error as it comes."""
        report = self.folder / "benchmark.json"
        command = [self.binary("cutaway-benchmark"), *self.gpu, *map(str, arguments), "--json", str(report)]
        subprocess.run(command, check=True, stdout=sys.stderr)
        return json.loads(report.read_text())

    def frames(self, edges, sizes):
        return self.benchmark(
            "--volumes", "phantom:head", "--phantom-size", *edges, "--sizes", *sizes, "--cases", *CASES,
            "--seconds", self.options.seconds,
        )  # fmt: skip

    def machine(self):
        """Fails at once where nothing renders."""
        return self.benchmark("--volumes", "none of them")["machine"]

    def volumes(self):
        say(f"Volumes of {', '.join(map(str, self.options.edges))} voxels an edge, {self.options.size}")
        return figures.volume_rows(self.frames(self.options.edges, [self.options.size]))

    def pixels(self):
        say(f"Pictures of {', '.join(self.options.sizes)}, {self.options.edge} voxels an edge")
        return figures.pixel_rows(self.frames([self.options.edge], self.options.sizes))

    def jpeg(self):
        say(f"JPEG with {', '.join(map(str, self.options.threads))} threads")
        return figures.jpeg_rows(self.benchmark(
            "--volumes", "phantom:head", "--phantom-size", self.options.edge, "--sizes", *self.options.jpeg_sizes,
            "--jpeg-threads", *self.options.threads, "--seconds", self.options.seconds,
        ))  # fmt: skip

    def sessions(self):
        return figures.session_rows([self.load(clients) for clients in self.options.clients])

    def load(self, clients):
        """The load client's report; the server is a new one, so that each number of clients finds the same."""
        say(f"Sessions: {clients}")
        report = self.folder / "load.json"
        report.unlink(missing_ok=True)
        server = Server(self.binary("cutaway"), "--config", self.server_configuration(clients), *self.gpu)
        try:
            done = subprocess.run(
                [self.binary("cutaway-load"), str(self.options.script), "--clients", str(clients),
                 "--url", f"ws://127.0.0.1:{server.port}/ws", "--seconds", str(self.options.session_seconds),
                 "--json", str(report)],
                stdout=subprocess.PIPE, text=True,
            )  # fmt: skip
        finally:
            server.stop()
        if not report.exists():
            raise SystemExit(f"scaling: cutaway-load measured nothing with {clients} clients: {done.stdout}")
        return json.loads(report.read_text())

    def server_configuration(self, clients):
        path = self.folder / "cutaway.toml"
        path.write_text(f"[server]\nsessions = {clients}\nconnections = {2 * clients + 16}\n")
        return str(path)


PARTS = {"volumes": Run.volumes, "pixels": Run.pixels, "jpeg": Run.jpeg, "sessions": Run.sessions}


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scaling", description=__doc__.split("\n\n")[0], formatter_class=argparse.ArgumentDefaultsHelpFormatter
    )
    cores = len(os.sched_getaffinity(0))
    add = parser.add_argument
    add("--json", type=Path, help="file for the figures")
    add("--parts", nargs="+", choices=PARTS, default=list(PARTS), help="what to measure")
    add("--edges", nargs="+", type=int, default=[64, 128, 192, 256, 384, 512], help="of the volumes, voxels")
    add("--size", default="512x512", help="of the picture in which volumes are compared")
    add("--edge", type=int, default=256, help="of the volume of which pictures are compared, voxels")
    add("--sizes", nargs="+", default=["256x256", "512x512", "1280x720", "1920x1080"], help="of the pictures compared")
    add("--jpeg-sizes", nargs="+", default=["512x512", "1280x720", "1920x1080"], help="of the pictures compressed")
    add("--threads", nargs="+", type=int, default=figures.doublings(cores), help="that compress at once")
    add("--seconds", type=float, default=2.0, help="for each case")
    add("--clients", nargs="+", type=int, default=[1, 2, 4, 8, 16, 30], help="sessions at once")
    add("--session-seconds", type=float, default=12.0, help="for each number of clients")
    add("--script", type=Path, default=TESTS / "load" / "scripts" / "sessions.json", help="what each client does")
    add("--require-gpu", action="store_true", help="refuse software rendering")
    add("--binaries", type=Path, required=True, help="folder of cutaway, cutaway-benchmark and cutaway-load")
    return parser.parse_args(arguments)


def main():
    options = parse(sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        run = Run(options, Path(folder))
        measured = {"machine": run.machine()}
        for part in options.parts:
            measured[part] = PARTS[part](run)
    print(figures.tables(measured))
    if options.json:
        options.json.write_text(json.dumps(measured, indent=2) + "\n")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as failed:
        sys.exit(f"scaling: {Path(failed.cmd[0]).name} ended with {failed.returncode}")
