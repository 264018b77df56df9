"""The designed experiment: units of data set, camera and lens position, each in four conditions,
under every saliency model.
"""
import math
from dataclasses import dataclass

import numpy

import saliency
from saliency.experiment import CONDITIONS, UNITS_PER_DATA_SET
from saliency.metrics import nss
from sheets import sheet

SIDE_PX = 768
GREY = [128 / 255] * 3
AZIMUTHS_DEGREES = (0, -40, 40, 75)
LENSES_A_CAMERA = UNITS_PER_DATA_SET // len(AZIMUTHS_DEGREES)
# Of the view, off the middle so that a bias to the centre is no help.
LENS_PLACES = ((0.42, 0.4), (0.6, 0.42), (0.5, 0.62), (0.36, 0.56), (0.64, 0.6), (0.5, 0.3))
LEAST_FOCUS, MOST_FOCUS = 0.01, 0.35  # share of the picture


@dataclass(frozen=True)
class Control:
    """Means over all units of one condition. nss_elsewhere: of the same maps on the focus mask moved
    over the body. detail_*: mean |Laplacian| of the luma."""

    condition: str
    nss: float
    nss_elsewhere: float
    detail_focus: float
    detail_context: float


@dataclass(frozen=True)
class Study:
    results: dict
    verdict: object
    controls: list
    sheet_files: list
    units: int


def make(studio, volumes, outdir, progress):
    observations, controls, files = [], [], []
    for volume in volumes:
        start = studio.open(volume)
        units = _units(studio, start)
        progress(f"saliency: {volume}, {len(units)} units")
        for number, (unit, scene, focus) in enumerate(units):
            pictures = {c: _picture(studio, scene, look) for c, look in _looks(studio).items()}
            examined = _examine(pictures)
            observations += _observations(volume, unit, examined, focus)
            controls.append(_controls(pictures, examined, focus))
            if number == 0:
                files.append(_winners_sheet(volume, pictures, examined, outdir))
            progress(f"saliency: {volume}, unit {number + 1} of {len(units)}")
    results = saliency.analyse(observations)
    return Study(results, saliency.judge(results), _means(controls), files, len(controls))


def _units(studio, start):
    """(name, scene without a look, focus mask) for each camera and lens position that shows some of
    the focus."""
    units = []
    for azimuth in AZIMUTHS_DEGREES:
        camera = _turned(start["camera"], azimuth)
        found = []
        for place in LENS_PLACES:
            scene = {"camera": camera, "lens": {"radius_mm": start["lens"]["radius_mm"]}}
            studio.reset(scene)
            scene["lens"]["centre_mm"] = studio.drag_lens(*place)
            focus = _focus_mask(studio, scene)
            if LEAST_FOCUS < focus.mean() < MOST_FOCUS:
                found.append((f"{azimuth:+d} degrees, lens at {place}", scene, focus))
            if len(found) == LENSES_A_CAMERA:
                break
        units += found
    return units


def _turned(camera, degrees):
    """The camera turned about the patient's axis through its target."""
    angle = math.radians(degrees)
    arm = numpy.subtract(camera["eye_mm"], camera["target_mm"])
    turned = [
        arm[0] * math.cos(angle) - arm[1] * math.sin(angle),
        arm[0] * math.sin(angle) + arm[1] * math.cos(angle),
        arm[2],
    ]
    eye = [float(value) for value in numpy.add(camera["target_mm"], turned)]
    return {**camera, "eye_mm": eye, "up": [0, 0, 1]}


def _flat(level):
    colour = [level] * 3
    return {
        "shading": {"name": "tone", "detail": 0, "dark": colour, "light": colour},
        "filters": [],
    }


def _focus_mask(studio, scene):
    mask_look = {
        "focus": _flat(1.0),
        "context": _flat(0.0),
        "lens": {"mode": "cutaway", "cap": "flat"},
        "background": {"colour": [0, 0, 0]},
    }
    return _picture(studio, scene, mask_look)[..., 0] > 0.5


def _looks(studio):
    style, phong = studio.styles["flagship"], studio.styles["phong-control"]
    return {
        "A": style,
        "B": phong,
        "C": {**phong, "lens": {**phong["lens"], "mode": "none"}},
        "D": {**style, "focus": style["context"], "context": style["focus"]},
    }


def _picture(studio, scene, look):
    lens = {**look["lens"], **scene["lens"]}
    background = look["background"] if look["background"]["colour"] == [0, 0, 0] else {"colour": GREY}
    studio.change({**look, "camera": scene["camera"], "lens": lens, "background": background})
    return studio.picture(SIDE_PX, SIDE_PX)


def _examine(pictures):
    return {
        (condition, model): saliency.examine(rgb, model)
        for condition, rgb in pictures.items()
        for model in saliency.MODELS
    }


def _observations(volume, unit, examined, focus):
    return [
        saliency.Observation(
            volume, unit, condition, model, saliency.scores(e.saliency_px, e.fixations, focus)
        )
        for (condition, model), e in examined.items()
    ]


def _controls(pictures, examined, focus):
    """{condition: (nss, nss elsewhere, detail in the focus, detail in the context)} of one unit."""
    body = numpy.abs(pictures["A"] - GREY[0]).max(axis=2) > 0.02
    moved = saliency.moved_masks(focus, body)
    rows = {}
    for condition, rgb in pictures.items():
        salient = examined[condition, saliency.PRIMARY].saliency_px
        elsewhere = saliency.shuffled_nss(salient, moved)
        rows[condition] = (
            nss(salient, focus),
            float("nan") if elsewhere is None else elsewhere,
            saliency.detail(rgb, focus),
            saliency.detail(rgb, body & ~focus),
        )
    return rows


def _means(controls):
    return [
        Control(condition, *(float(v) for v in numpy.nanmean([c[condition] for c in controls], axis=0)))
        for condition in CONDITIONS
    ]


def _winners_sheet(volume, pictures, examined, outdir):
    """The picture with its most salient regions circled, for each model and condition."""
    rows = [
        [
            saliency.draw_fixations(rgb, examined[condition, model].fixations)[::2, ::2]
            for condition, rgb in pictures.items()
        ]
        for model in saliency.MODELS
    ]
    file = f"winners-{''.join(c if c.isalnum() else '-' for c in volume)}.png"
    columns = [f"{condition}: {text}" for condition, text in CONDITIONS.items()]
    saliency.write_picture(outdir / file, sheet(rows, list(saliency.MODELS), columns))
    return volume, file
