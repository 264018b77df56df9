"""The designed experiment: units of data set, camera and lens position, each in four conditions,
under every saliency model.
"""
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import controls
import saliency
import units
from looks import focus_mask, looks, picture
from saliency.experiment import CONDITIONS
from sheets import sheet


@dataclass(frozen=True)
class Study:
    """passed_over: (volume, its units) of those that gave too few while others gave enough."""

    results: dict
    verdict: object
    controls: list
    requirements: list
    sheet_files: list
    passed_over: list


@dataclass(frozen=True)
class Drawn:
    """One unit's pictures by condition and its focus mask; is_first: of its volume."""

    volume: str
    unit: str
    pictures: dict
    focus: object
    is_first: bool


@dataclass(frozen=True)
class Examination:
    volume: str
    observations: list
    readings: dict
    sheet_file: str | None


def make(studio, volumes, extent, outdir, progress):
    """Studies up to `extent.most_studied` volumes in the order given; one with too few units only
    where the others do not suffice."""
    chosen = _Choice(studio, volumes, extent, progress)
    drawn = _draw(studio, chosen, extent.study_px, progress)
    examined = list(_overlapped(lambda one: _examine(one, outdir), drawn))
    results = saliency.analyse([o for e in examined for o in e.observations])
    readings = [e.readings for e in examined]
    requirements = controls.requirements(readings, [e.volume for e in examined])
    return Study(
        results,
        saliency.judge(results, requirements),
        controls.means(readings),
        requirements,
        [(e.volume, e.sheet_file) for e in examined if e.sheet_file],
        chosen.passed_over,
    )


class _Choice:
    """Iterates over (volume, units), the volume open."""

    def __init__(self, studio, volumes, extent, progress):
        self._studio, self._volumes, self._progress = studio, volumes, progress
        self._most, self._units = extent.most_studied, extent.units
        self.passed_over = []

    def __iter__(self):
        taken = 0
        for volume in self._volumes:
            if taken == self._most:
                return
            found = units.find(self._studio, self._studio.open(volume), self._units)
            self._progress(f"saliency: {volume}, {len(found)} units")
            if len(found) < self._units:
                self.passed_over.append((volume, found))
                continue
            taken += 1
            yield volume, found
        yield from self._fill(self._most - taken)

    def _fill(self, missing):
        """Those with too few units, the most first, for want of better ones."""
        self.passed_over.sort(key=lambda pair: -len(pair[1]))
        while missing > 0 and self.passed_over and self.passed_over[0][1]:
            volume, found = self.passed_over.pop(0)
            self._studio.open(volume)
            missing -= 1
            yield volume, found


def _draw(studio, chosen, side_px, progress):
    for volume, found in chosen:
        for number, unit in enumerate(found, 1):
            focus = focus_mask(studio, unit.scene, side_px)
            pictures = {
                c: picture(studio, unit.scene, look, side_px) for c, look in looks(studio).items()
            }
            progress(f"saliency: {volume}, unit {number} of {len(found)}")
            yield Drawn(volume, unit.name, pictures, focus, number == 1)


def _overlapped(work, items):
    """work(item) of each in order; one is worked on while the next is drawn, and no third waits."""
    with ThreadPoolExecutor(1) as pool:
        underway = None
        for item in items:
            if underway is not None:
                yield underway.result()
            underway = pool.submit(work, item)
        if underway is not None:
            yield underway.result()


def _examine(drawn, outdir):
    examined = {
        (condition, model): saliency.examine(rgb, model)
        for condition, rgb in drawn.pictures.items()
        for model in saliency.MODELS
    }
    return Examination(
        drawn.volume,
        _observations(drawn, examined),
        controls.read(drawn.pictures, examined, drawn.focus),
        _winners_sheet(drawn, examined, outdir) if drawn.is_first else None,
    )


def _observations(drawn, examined):
    return [
        saliency.Observation(
            drawn.volume,
            drawn.unit,
            condition,
            model,
            saliency.scores(e.saliency_px, e.fixations, drawn.focus),
        )
        for (condition, model), e in examined.items()
    ]


def _winners_sheet(drawn, examined, outdir):
    """The picture with its most salient regions circled, for each model and condition."""
    rows = [
        [
            saliency.draw_fixations(rgb, examined[condition, model].fixations)[::2, ::2]
            for condition, rgb in drawn.pictures.items()
        ]
        for model in saliency.MODELS
    ]
    file = f"winners-{''.join(c if c.isalnum() else '-' for c in drawn.volume)}.png"
    columns = [f"{condition}: {text}" for condition, text in CONDITIONS.items()]
    saliency.write_picture(outdir / file, sheet(rows, list(saliency.MODELS), columns))
    return file
