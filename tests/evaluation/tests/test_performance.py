import json
import pathlib
import tempfile
import unittest

import performance
from extent import FULL, QUICK
from report_performance import performance as page

# Answers as cutaway-benchmark does, which has more cases than the dissertation and may put them in
# any order.
BENCHMARK = """#!/usr/bin/python3
import json, sys
options, name = {}, None
for word in sys.argv[1:]:
    if word.startswith("--"):
        name = word
    else:
        options.setdefault(name, []).append(word)
frames = int(options["--least-frames"][0])
size = int(options["--phantom-size"][0])
cases = ["magic sphere lens alone", "lens + both", "Phong, no lens", "lens", "lens + Kuwahara",
         "lens + Sobel", "kuwahara alone"]
wanted = lambda text, parts: any(part in text for part in parts)
print("measuring", size)
json.dump({
    "machine": {"renderer": "r", "processor": "p", "cores": 2},
    "frames": [
        {"volume": f"phantom:{v}" + ("" if size == 256 else f"@{size}"), "case": c,
         "frames": frames, "median_ms": 50.0 + n, "p95_ms": 60.0, "device_ms": 49.0,
         "stages_ms": {"ray cast": 30.0, "kuwahara": 8.0, "sobel": 4.0}}
        for v in ("head", "abdomen", "knees") for n, c in enumerate(cases)
        if wanted(c, options["--cases"]) and wanted(f"phantom:{v}", options["--volumes"])
    ],
}, open(options["--json"][0], "w"))
"""


class Performance(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.benchmark = self.folder / "cutaway-benchmark"
        self.benchmark.write_text(BENCHMARK)
        self.benchmark.chmod(0o755)
        self.told = []

    def make(self, wanted=FULL):
        return performance.make(self.benchmark, wanted.benchmark, self.folder, self.told.append)

    def test_every_case_has_two_hundred_frames_and_all_criteria_are_judged(self):
        table = self.make()
        self.assertEqual(
            [tuple(cell.case for cell in row) for row in table.rows.values()],
            [performance.CASES] * 3,
        )
        fps = [cell.stated_fps for cell in table.rows["phantom:head"]]
        self.assertEqual(fps, [22, 18, 15, 17, 15])
        self.assertEqual({c.frames for row in table.rows.values() for c in row}, {200})
        self.assertEqual([c.holds for c in table.criteria], [True] * 5)
        self.assertIn("performance: measuring 256", self.told)
        self.assertIn("performance: measuring 128", self.told)
        kept = json.loads((self.folder / "performance.json").read_text())["frames"]
        self.assertLessEqual(15, len(kept))

    def test_the_quick_form_has_all_cases_of_one_phantom(self):
        table = self.make(QUICK)
        self.assertEqual([len(row) for row in table.rows.values()], [5])
        self.assertEqual([c.holds for c in table.criteria], [True] * 5)

    def test_a_case_that_the_benchmark_has_no_more_is_named(self):
        self.benchmark.write_text(BENCHMARK.replace('"lens + Sobel",', ""))
        with self.assertRaisesRegex(LookupError, r"no case 'lens \+ Sobel' of phantom:head"):
            self.make()

    def test_the_page_tells_the_frames_and_each_criterion(self):
        text = "".join(page(self.make()))
        self.assertEqual(text.count("<td>200</td>"), 15)
        self.assertEqual(text.count("<td>holds</td>"), 5)

    def test_a_benchmark_that_fails_stops_the_evaluation(self):
        self.benchmark.write_text("#!/bin/sh\nexit 2\n")
        with self.assertRaises(performance.subprocess.CalledProcessError):
            self.make()
