"""The units of a data set: cameras and lens positions from which some of the focus shows."""
import math
from dataclasses import dataclass

import numpy

from looks import focus_mask

# Later ones are tried only where earlier ones give too few units.
AZIMUTHS_DEGREES = (0, -40, 40, 75, -75, 20, -20)
LENSES_A_CAMERA = 3
# Of the view, off the middle so that a bias to the centre is no help.
LENS_PLACES = (
    (0.42, 0.4), (0.6, 0.42), (0.5, 0.62), (0.36, 0.56), (0.64, 0.6), (0.5, 0.3),
    (0.36, 0.36), (0.64, 0.36), (0.4, 0.7), (0.6, 0.74), (0.3, 0.46), (0.7, 0.5),
)  # fmt: skip
LEAST_FOCUS, MOST_FOCUS = 0.01, 0.35  # share of the picture
SEARCH_PX = 192  # side of the picture that tells the share


@dataclass(frozen=True)
class Unit:
    """name: unique within its data set. scene: camera and lens, without a look."""

    name: str
    scene: dict


def find(studio, start, wanted):
    """Units of the open volume, so many as are wanted where so many are found. start: its scene as
    resolved on opening."""
    found = []
    for azimuth in AZIMUTHS_DEGREES:
        missing = min(LENSES_A_CAMERA, wanted - len(found))
        found += _of_camera(studio, start, azimuth, missing)
    return found


def _of_camera(studio, start, azimuth, wanted):
    camera = turned(start["camera"], azimuth)
    found = []
    for place in LENS_PLACES:
        if len(found) == wanted:
            break
        scene = _lens_at(studio, camera, start["lens"]["radius_mm"], place)
        if LEAST_FOCUS < focus_mask(studio, scene, SEARCH_PX).mean() < MOST_FOCUS:
            found.append(Unit(f"{azimuth:+d} degrees, lens at {place}", scene))
    return found


def _lens_at(studio, camera, radius_mm, place):
    studio.reset({"camera": camera, "lens": {"radius_mm": radius_mm}})
    lens = {"radius_mm": radius_mm, "centre_mm": studio.drag_lens(*place)}
    return {"camera": camera, "lens": lens}


def turned(camera, degrees):
    """The camera turned about the patient's axis through its target."""
    angle = math.radians(degrees)
    arm = numpy.subtract(camera["eye_mm"], camera["target_mm"])
    turned_arm = [
        arm[0] * math.cos(angle) - arm[1] * math.sin(angle),
        arm[0] * math.sin(angle) + arm[1] * math.cos(angle),
        arm[2],
    ]
    eye = [float(value) for value in numpy.add(camera["target_mm"], turned_arm)]
    return {**camera, "eye_mm": eye, "up": [0, 0, 1]}
