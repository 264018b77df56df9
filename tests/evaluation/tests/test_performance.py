import json
import pathlib
import tempfile
import unittest

import performance
from report_performance import performance as page

# Answers as cutaway-benchmark does; refuses to run without the least number of frames.
BENCHMARK = """#!/usr/bin/python3
import json, sys
options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
frames = int(options["--least-frames"])
size = int(options["--phantom-size"])
assert options["--sizes"] == "512x512"
cases = ["Phong, no lens", "lens", "lens + Kuwahara", "lens + Sobel", "lens + both"]
print("measuring", size)
json.dump({
    "machine": {"renderer": "r", "processor": "p", "cores": 2},
    "frames": [
        {"volume": f"phantom:{v}" + ("" if size == 256 else f"@{size}"), "case": c,
         "frames": frames, "median_ms": 50.0 + n, "p95_ms": 60.0, "device_ms": 49.0,
         "stages_ms": {"ray cast": 30.0, "kuwahara": 8.0, "sobel": 4.0}}
        for v in ("head", "abdomen", "knees") for n, c in enumerate(cases)
        if c in options.get("--cases", c)
    ],
}, open(options["--json"], "w"))
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

    def test_every_case_has_two_hundred_frames_and_all_criteria_are_judged(self):
        table = performance.make(self.benchmark, self.folder, self.told.append)
        self.assertEqual([len(row) for row in table.rows.values()], [5, 5, 5])
        self.assertEqual({c.frames for row in table.rows.values() for c in row}, {200})
        self.assertEqual([c.holds for c in table.criteria], [True] * 5)
        self.assertIn("performance: measuring 256", self.told)
        self.assertIn("performance: measuring 128", self.told)
        self.assertEqual(
            len(json.loads((self.folder / "performance.json").read_text())["frames"]), 15
        )

    def test_the_page_tells_the_frames_and_each_criterion(self):
        text = "".join(page(performance.make(self.benchmark, self.folder, self.told.append)))
        self.assertEqual(text.count("<td>200</td>"), 15)
        self.assertEqual(text.count("<td>holds</td>"), 5)

    def test_a_benchmark_that_fails_stops_the_evaluation(self):
        self.benchmark.write_text("#!/bin/sh\nexit 2\n")
        with self.assertRaises(performance.subprocess.CalledProcessError):
            performance.make(self.benchmark, self.folder, self.told.append)
