import unittest

import acceptance
from performance import Cell

CASES = ("Phong, no lens", "lens", "lens + Kuwahara", "lens + Sobel", "lens + both")
STAGES = {"kuwahara": 10.0, "sobel": 5.0}


def rows(medians, frames=200, stages=STAGES):
    cells = [
        Cell(case, frames, ms, ms + 5, ms, stages, 10)
        for case, ms in zip(CASES, medians, strict=True)
    ]
    return {"phantom:head": cells}


def held(medians=(50, 55, 60, 60, 70), frames=200, small=STAGES):
    criteria = acceptance.judge(rows(medians, frames), {"phantom:head": small}, 200)
    return [c.holds for c in criteria], " ".join(c.told for c in criteria)


class Criteria(unittest.TestCase):
    def test_a_quick_renderer_meets_all(self):
        self.assertEqual(held()[0], [True] * 5)

    def test_fewer_frames_are_told(self):
        holds, told = held(frames=199)
        self.assertEqual(holds, [False, True, True, True, True])
        self.assertIn("fewest 199", told)

    def test_the_slowest_configuration_decides(self):
        holds, told = held((50, 55, 60, 60, 126))
        self.assertEqual(holds, [True, False, True, True, True])
        self.assertIn("lens + both: median 126.0 ms, 7.9 a second", told)
        self.assertTrue(held((50, 55, 60, 60, 125))[0][1])

    def test_the_lens_may_cost_a_quarter(self):
        self.assertTrue(held((40, 50, 60, 60, 70))[0][2])
        holds, told = held((40, 51, 60, 60, 70))
        self.assertFalse(holds[2])
        self.assertIn("phantom:head +27%", told)

    def test_a_filter_that_grows_with_the_volume_is_told(self):
        holds, told = held(small={"kuwahara": 9.0, "sobel": 2.0})
        self.assertEqual(holds[3:], [True, False])
        self.assertIn("+150%: 2.00 and 5.00 ms over 1 volumes", told)
