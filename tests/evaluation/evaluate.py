"""The evaluation, part by part, with progress on standard error; see `run`."""
import argparse
import pathlib
import sys
import time

import data_sets
import extent
import gallery
import performance
import report
import saliency_study
import style_study
from studio import Studio


def main():
    arguments = parse_arguments()
    arguments.outdir.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    wanted = extent.QUICK if arguments.quick else extent.FULL
    cutaway = arguments.build / "cutaway"
    volumes, measured = volumes_to_show(arguments, cutaway, wanted)
    with Studio(cutaway, arguments.data) as studio:
        studio.wait_for({*volumes, *measured})
        styles = style_study.make(studio, cutaway, measured, wanted, progress)
        sheets = gallery.make(studio, volumes, wanted, arguments.outdir, progress)
        study = saliency_study.make(studio, volumes, wanted, arguments.outdir, progress)
        renderer = studio.renderer
    report.write_figures(arguments.outdir, study, styles)
    progress(f"saliency: {study.verdict.outcome}")
    benchmark = arguments.build / "cutaway-benchmark"
    table = performance.make(benchmark, wanted.benchmark, arguments.outdir, progress)
    minutes = (time.monotonic() - begun) / 60
    written = report.write(
        arguments.outdir, renderer, sheets, styles, study, table, minutes, wanted
    )
    print(f"{study.verdict.text}\n\nThe report is {written} ({minutes:.1f} minutes).")


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tests/evaluation/run", description=__doc__)
    parser.add_argument("outdir", type=pathlib.Path, metavar="OUTDIR")
    parser.add_argument("--data", type=pathlib.Path, help="folder whose CTs are shown as well")
    parser.add_argument("--quick", action="store_true", help="all parts, little of each: a trial")
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.data is not None and not arguments.data.is_dir():
        parser.error(f"--data {arguments.data}: a folder is needed")
    return arguments


def volumes_to_show(arguments, cutaway, wanted):
    """Those of the figures and the experiment, and those on which styles are measured."""
    phantoms = list(wanted.phantoms)
    if arguments.quick or arguments.data is None:
        return phantoms, phantoms
    progress(f"reading {arguments.data}")
    volumes = data_sets.read(cutaway, arguments.data)
    found, others = data_sets.cts(volumes)
    progress(f"CTs: {', '.join(found) or 'none'}; not CTs: {', '.join(others) or 'none'}")
    return phantoms + found, phantoms + data_sets.with_two_surfaces(volumes)


def progress(what):
    print(f"[{time.strftime('%H:%M:%S')}] {what}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
