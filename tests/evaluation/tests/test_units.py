import unittest
from dataclasses import replace
from unittest.mock import patch

import numpy

import extent
import saliency_study
import units

START = {"camera": {"eye_mm": [0, -500, 0], "target_mm": [0, 0, 0]}, "lens": {"radius_mm": 50}}


class FakeStudio:
    """Its focus shows where `shows(azimuth's number, place)` says so."""

    def __init__(self, shows):
        self.shows, self.cameras, self.opened = shows, [], None

    def open(self, volume):
        self.opened = volume
        return START

    def reset(self, scene):
        if scene["camera"]["eye_mm"] not in self.cameras:
            self.cameras.append(scene["camera"]["eye_mm"])

    def drag_lens(self, x, y):
        return [x, y, 0]


def fake_focus_mask(studio, scene, side_px):
    mask = numpy.zeros((side_px, side_px), bool)
    camera = studio.cameras.index(scene["camera"]["eye_mm"])
    if studio.shows(studio.opened, camera, tuple(scene["lens"]["centre_mm"][:2])):
        mask[: side_px // 4, : side_px // 4] = True
    return mask


def find(shows):
    studio = FakeStudio(lambda volume, camera, place: shows(camera, place))
    return studio, units.find(studio, START, 12)


@patch("units.focus_mask", fake_focus_mask)
class Units(unittest.TestCase):
    def test_four_cameras_do_where_every_place_shows_the_focus(self):
        studio, found = find(lambda camera, place: True)
        self.assertEqual((len(found), len(studio.cameras)), (12, 4))
        self.assertEqual(len({unit.name for unit in found}), 12)

    def test_more_places_are_tried_where_the_first_show_nothing(self):
        later = units.LENS_PLACES[6:]
        studio, found = find(lambda camera, place: place in later)
        self.assertEqual((len(found), len(studio.cameras)), (12, 4))

    def test_more_cameras_are_tried_where_the_first_give_too_few(self):
        studio, found = find(lambda camera, place: camera > 2)
        self.assertEqual((len(found), len(studio.cameras)), (12, 7))

    def test_what_is_not_there_is_not_made_up(self):
        _, found = find(lambda camera, place: camera == 0 and place == units.LENS_PLACES[0])
        self.assertEqual(len(found), 1)

    def test_a_camera_turns_about_its_target_and_keeps_its_distance(self):
        for degrees in units.AZIMUTHS_DEGREES:
            eye = units.turned(START["camera"], degrees)["eye_mm"]
            self.assertAlmostEqual(numpy.hypot(*eye[:2]), 500)
        numpy.testing.assert_allclose(
            units.turned(START["camera"], 90)["eye_mm"], [500, 0, 0], atol=1e-9
        )


@patch("units.focus_mask", fake_focus_mask)
class Choice(unittest.TestCase):
    def choose(self, few, most, volumes="abcd"):
        """Which volumes are studied, with how many units; `few` show one unit a camera at most."""
        studio = FakeStudio(
            lambda volume, camera, place: volume not in few or place == units.LENS_PLACES[0]
        )
        choice = saliency_study._Choice(
            studio, list(volumes), replace(extent.FULL, most_studied=most), lambda text: None
        )
        chosen = []
        for volume, found in choice:
            self.assertEqual(studio.opened, volume)
            chosen.append((volume, len(found)))
        return chosen, [(volume, len(found)) for volume, found in choice.passed_over]

    def test_the_next_volume_takes_the_place_of_one_with_too_few_units(self):
        chosen, passed_over = self.choose(few="b", most=3)
        self.assertEqual(chosen, [("a", 12), ("c", 12), ("d", 12)])
        self.assertEqual(passed_over, [("b", 7)])

    def test_one_with_too_few_units_is_studied_where_there_is_no_other(self):
        chosen, passed_over = self.choose(few="b", most=4)
        self.assertEqual(chosen, [("a", 12), ("c", 12), ("d", 12), ("b", 7)])
        self.assertEqual(passed_over, [])


class Overlap(unittest.TestCase):
    def test_results_come_in_order_and_drawing_is_at_most_one_ahead(self):
        drawn, done = [], []

        def draw():
            for n in range(6):
                self.assertLessEqual(n - len(done), 2)
                drawn.append(n)
                yield n

        for result in saliency_study._overlapped(lambda n: n * n, draw()):
            done.append(result)
        self.assertEqual(done, [n * n for n in range(6)])

    def test_an_error_at_work_is_not_lost(self):
        with self.assertRaises(ZeroDivisionError):
            list(saliency_study._overlapped(lambda n: 1 / n, iter([1, 0, 2])))
