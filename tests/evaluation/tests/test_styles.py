import json
import tempfile
import unittest
from pathlib import Path

import numpy

import made_bodies
import style_figures
import style_scenes
from html_table import Failing, table
from report_styles import style_study as page
from style_limits import LIMITS, Cell
from style_scenes import Masks
from style_study import StyleStudy

LINES = {"name": "depth_lines", "strength": 1, "colour": [0.2, 0.1, 0.1]}
KUWAHARA = {"name": "kuwahara", "radius": 2}


def branch(**changes):
    return {
        "surface": {"opacity": 1},
        "shading": {"name": "tone", "detail": 0, "dark": [0.2, 0.3, 0.4], "light": [0.9, 0.9, 0.9]},
        "filters": [KUWAHARA, LINES],
        **changes,
    }


def scene(**lens):
    cut = {"mode": "cutaway", "opening": "funnel", "funnel_degrees": 8, "cap": "section", **lens}
    return {"focus": branch(), "context": branch(), "lens": cut}


class FakeStudio:
    def __init__(self, picture):
        self._picture, self.shown = picture, []

    def change(self, scene):
        self.shown.append(scene)

    def picture(self, width_px, height_px):
        return self._picture


class Scenes(unittest.TestCase):
    def test_a_mask_holds_what_shows_one_kind_alone(self):
        kinds = {
            "skin": [1, 0, 0],
            "focus": [0, 1, 0],
            "wall": [0, 0, 1],
            "fat, at the volume's end": [0.9, 0.8, 0.5],
            "background": [0, 0, 0],
            "both": [0.5, 0.5, 0],
        }
        studio = FakeStudio(numpy.array([list(kinds.values())], numpy.float32))
        masks = style_scenes.masks(studio, scene(), 6, 1)
        found = {
            name: [n for n, is_in in zip(kinds, getattr(masks, name)[0]) if is_in]
            for name in ("skin", "focus", "wall")
        }
        self.assertEqual(found, {"skin": ["skin"], "focus": ["focus"], "wall": ["wall"]})
        self.assertEqual(masks.covered.tolist(), [[True, True, True, True, False, False]])

    def test_masks_cut_as_the_style_does_and_light_nothing(self):
        studio = FakeStudio(numpy.zeros((1, 1, 3), numpy.float32))
        style_scenes.masks(studio, scene(funnel_degrees=12), 1, 1)
        (shown,) = studio.shown
        self.assertEqual(
            (shown["lens"]["opening"], shown["lens"]["funnel_degrees"]), ("funnel", 12)
        )
        for name in style_scenes.BRANCHES:
            self.assertEqual(
                (shown[name]["occlusion"]["strength"], shown[name]["shadow"]["strength"]), (0, 0)
            )
            self.assertEqual(shown[name]["shading"]["dark"], shown[name]["shading"]["light"])

    def test_lines_are_left_out_and_what_abstracts_stays(self):
        self.assertEqual(style_scenes.without_lines(scene())["focus"]["filters"], [KUWAHARA])
        alone = style_scenes.lines_alone(scene())["context"]["filters"]
        self.assertEqual(alone, [{**LINES, "colour": [0, 0, 0]}])

    def test_only_opaque_surfaces_behind_a_cutaway_are_measured(self):
        self.assertTrue(style_scenes.is_measured(scene()))
        self.assertFalse(style_scenes.is_measured(scene(mode="magic")))
        veiled = {**scene(), "context": branch(surface={"opacity": 0.1})}
        self.assertFalse(style_scenes.is_measured(veiled))


def plate(side=120):
    """A skin with a hole in it, whose wall and focus lie side by side."""
    y, x = numpy.mgrid[:side, :side]
    away = numpy.hypot(x - side / 2, y - side / 2)
    hole, skin = away < 25, (away > 26) & (away < 55)
    return Masks(skin, hole & (x < side / 2), hole & (x >= side / 2), away < 55)


class Figures(unittest.TestCase):
    def picture(self, skin, wall, focus):
        masks = plate()
        rgb = numpy.full((*masks.skin.shape, 3), 0.95)
        for mask, level in ((masks.skin, skin), (masks.wall, wall), (masks.focus, focus)):
            rgb[mask] = level
        return rgb, masks

    def test_a_wall_like_the_skin_closes_the_hole(self):
        found = style_figures.tones(*self.picture(skin=0.8, wall=0.8, focus=0.8))
        self.assertEqual((found["rim"], found["wall_skin"], found["wall_focus"]), (1, 0, 0))
        self.assertEqual(
            Cell("a", "b", found).failing(), ["rim", "wall_skin", "wall_focus", "context_tone"]
        )

    def test_a_dark_wall_opens_it(self):
        found = style_figures.tones(*self.picture(skin=0.8, wall=0.3, focus=0.9))
        self.assertEqual(found["rim"], 0)
        self.assertGreater(min(found["wall_skin"], found["wall_focus"]), 22)

    def test_half_a_focus_in_each_half_of_the_ramp(self):
        rgb, masks = self.picture(0.8, 0.3, 0.2)
        rgb[60:][masks.focus[60:]] = 0.9
        greys = numpy.linspace(0, 1, 6)
        ramp = {
            n: [g] * 3
            for n, g in zip(("deepest", "deep", "middle", "light", "lighter", "lightest"), greys)
        }
        found = style_figures.ramp_halves(rgb, masks, ramp)
        self.assertAlmostEqual(found["cool_half"], 0.5, delta=0.05)
        self.assertAlmostEqual(found["cool_half"] + found["warm_half"], 1)

    def test_what_is_not_there_is_not_judged(self):
        rgb, masks = self.picture(0.8, 0.3, 0.9)
        nothing = numpy.zeros_like(masks.focus)
        found = style_figures.tones(rgb, Masks(masks.skin, nothing, nothing, masks.covered))
        self.assertEqual(list(found), ["context_tone"])

    def test_a_line_along_a_shading_step_turns_with_the_light_and_one_by_depth_does_not(self):
        _, masks = self.picture(0.8, 0.3, 0.9)
        plain = [numpy.full((120, 120, 3), level) for level in (0.8, 0.6)]

        def drawn(*rows):
            both = [p.copy() for p in plain]
            for rgb, row in zip(both, rows):
                rgb[row : row + 3] = LINES["colour"]
            return both

        still, turning = (
            style_figures.turned_lines(d, plain, scene(), masks)
            for d in (drawn(100, 100), drawn(100, 20))
        )
        self.assertEqual(still, {"turned_lines": 0})
        self.assertGreater(turning["turned_lines"], 50)

    def test_one_picture_at_two_sizes_is_alike(self):
        large, ink = numpy.full((480, 480, 3), 0.5), numpy.zeros((480, 480))
        ink[200:208] = 1
        small, small_ink = numpy.full((120, 120, 3), 0.5), numpy.zeros((120, 120))
        small_ink[50:52] = 1
        covered = numpy.ones((120, 120), bool)
        found = style_figures.sizes(small, large, small_ink, ink, covered)
        self.assertEqual(found, {"size": 0, "line_width": 1})
        small_ink[50] = 0
        found = style_figures.sizes(small + 0.1, large, small_ink, ink, covered)
        self.assertEqual(Cell("a", "b", found).failing(), ["size", "line_width"])


class MadeBodies(unittest.TestCase):
    def test_they_differ_by_noise_of_the_stated_size_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            made_bodies.write(folder)
            smooth, noisy = (
                self.values(Path(folder) / name) for name in (made_bodies.SMOOTH, made_bodies.NOISY)
            )
        self.assertAlmostEqual(
            (noisy - smooth).std(), made_bodies.NOISE * made_bodies.CONTRAST, delta=2
        )
        middle = made_bodies.VOXELS // 2
        self.assertEqual(
            (smooth[0, 0, 0], smooth[middle, middle, middle]), (0, 2 * made_bodies.CONTRAST)
        )

    def values(self, path):
        head, data = path.read_bytes().split(b"\n\n", 1)
        self.assertTrue(head.startswith(b"NRRD0004"))
        return numpy.frombuffer(data, "<i2").reshape((made_bodies.VOXELS,) * 3).astype(float)


class Page(unittest.TestCase):
    STUDY = StyleStudy(
        [Cell("flagship", "head", {"rim": 0.5, "size": 1.0}), Cell("toon", "<b>", {"rim": 0.01})],
        ["slab"],
    )

    def test_failing_cells_are_marked_and_told(self):
        text = "".join(page(self.STUDY))
        self.assertIn('<td class="failing">50.0%</td>', text)
        self.assertIn("1 of 3 figures", text)
        self.assertIn("no lens: slab", text)
        self.assertIn("<td>1.0%</td>", text)
        self.assertNotIn("<b>", text)
        self.assertNotIn(LIMITS["toon_focus"].text, text)

    def test_the_figures_are_plain_values(self):
        plain = json.loads(json.dumps(self.STUDY.as_dict()))
        self.assertEqual(plain["failing"], {"flagship on head": ["rim"]})

    def test_a_table_escapes_what_it_marks(self):
        self.assertIn('<td class="failing">&lt;i&gt;</td>', table(("a",), [(Failing("<i>"),)]))
