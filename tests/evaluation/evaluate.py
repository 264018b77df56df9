"""The evaluation, part by part, with progress on standard error; see `run`."""
import argparse
import pathlib
import sys
import time

import gallery
import performance
import report
import saliency_study
from studio import Studio

PHANTOMS = ("phantom:head", "phantom:abdomen", "phantom:knees")


def main():
    arguments = parse_arguments()
    arguments.outdir.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    with Studio(arguments.build / "cutaway", arguments.data) as studio:
        volumes = volumes_to_show(studio, arguments.quick)
        sheets = gallery.make(studio, volumes, arguments.outdir, progress)
        studied = volumes[:1] if arguments.quick else volumes_to_study(volumes)
        study = saliency_study.make(studio, studied, arguments.outdir, progress)
        renderer = studio.renderer
    progress("performance table")
    table = performance.make(arguments.build / "cutaway-benchmark", arguments.outdir)
    minutes = (time.monotonic() - begun) / 60
    written = report.write(arguments.outdir, renderer, sheets, study, table, minutes)
    print(f"{study.verdict.text}\n\nThe report is {written} ({minutes:.1f} minutes).")


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tests/evaluation/run", description=__doc__)
    parser.add_argument("outdir", type=pathlib.Path, metavar="OUTDIR")
    parser.add_argument("--data", type=pathlib.Path, help="folder whose CTs are shown as well")
    parser.add_argument("--quick", action="store_true", help="one phantom only: a trial")
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.data is not None and not arguments.data.is_dir():
        parser.error(f"--data {arguments.data}: a folder is needed")
    return arguments


def volumes_to_show(studio, quick):
    # A NIfTI or NRRD file does not say that it is a CT; what says that it is an MR is none.
    given = [v["id"] for v in studio.volumes() if v["modality"] != "MR" and v["id"] not in PHANTOMS]
    return list(PHANTOMS[:1]) if quick else [*PHANTOMS, *given]


def volumes_to_study(volumes):
    """The phantoms and one CT: twelve units each are what the time allows on two cores."""
    return volumes[: len(PHANTOMS) + 1]


def progress(what):
    print(f"[{time.strftime('%H:%M:%S')}] {what}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
