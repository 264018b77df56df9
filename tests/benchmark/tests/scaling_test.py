"""What tests/benchmark/scaling makes of its reports; with the programs, that it measures all parts.

Usage: scaling_test.py [BINARIES] [unittest arguments]
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCHMARK = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(BENCHMARK))
import scaling_figures as figures  # noqa: E402

BINARIES = None
SMALL_SCRIPT = {
    "title": "Small", "volume": "phantom:head@32", "style": "flagship",
    "roles": [{
        "name": "mover", "viewport": {"width_px": 64, "height_px": 48}, "inputs_per_second": 20,
        "motion": [{"for_s": 2, "motion": {"orbit": {"degrees_per_second": 60}}}],
    }],
}  # fmt: skip
MACHINE = {"processor": "A processor", "cores": 2, "renderer": "A renderer", "software_renderer": True}


def frame(case, edge=64, size=(512, 512), ms=10.0):
    return {
        "volume": "phantom:head", "size_voxels": [edge, edge, edge - 4], "size_px": list(size), "case": case,
        "frames": 5, "median_ms": ms, "p95_ms": 2 * ms, "device_ms": ms / 2, "stages_ms": {},
    }  # fmt: skip


def load_report(clients, fps, p95, errors=0):
    return {
        "clients_count": clients,
        "clients": [{"frames_per_second": each} for each in fps],
        "together": {
            "latency_ms": {"count": 0} if p95 is None else {"count": 9, "p50": p95 / 2, "p95": p95},
            "render_ms": {"count": 9, "p50": 3.0}, "bytes_per_frame": {"count": 9, "mean": 5000.0},
            "least_frames_per_second": min((each for each in fps if each), default=None),
            "errors": errors, "stale_frames": 0, "disconnects": 0, "clients_without_frame": 0,
        },
    }  # fmt: skip


class FiguresTest(unittest.TestCase):
    def test_doublings_end_with_the_most(self):
        self.assertEqual(figures.doublings(1), [1])
        self.assertEqual(figures.doublings(2), [1, 2])
        self.assertEqual(figures.doublings(6), [1, 2, 4, 6])
        self.assertEqual(figures.doublings(8), [1, 2, 4, 8])

    def test_each_volume_stands_beside_256_of_its_own_case(self):
        frames = [frame("control", 64, ms=5.0), frame("control", 256, ms=10.0), frame("control", 512, ms=12.0)]
        frames += [frame("flagship", 256, ms=20.0), frame("flagship", 512, ms=30.0)]
        rows = figures.volume_rows({"frames": frames})
        self.assertEqual([row["edge_voxels"] for row in rows], [64, 256, 512, 256, 512])
        self.assertEqual([row["times_reference"] for row in rows], [0.5, 1.0, 1.2, 1.0, 1.5])

    def test_without_256_the_smallest_is_the_yardstick(self):
        rows = figures.volume_rows({"frames": [frame("control", 128, ms=6.0), frame("control", 64, ms=3.0)]})
        self.assertEqual([row["times_reference"] for row in rows], [2.0, 1.0])
        self.assertEqual(rows[0]["reference_voxels"], 64)

    def test_each_picture_stands_beside_the_smallest(self):
        rows = figures.pixel_rows({
            "frames": [frame("control", size=(1000, 1000), ms=30.0), frame("control", size=(500, 500), ms=10.0)]
        })  # fmt: skip
        self.assertEqual([row["times_smallest"] for row in rows], [3.0, 1.0])
        self.assertEqual([row["times_pixels"] for row in rows], [4.0, 1.0])
        self.assertEqual([row["ms_a_megapixel"] for row in rows], [30.0, 40.0])

    def jpeg(self, threads, quality=80, rate=100.0):
        return {
            "volume": "v", "size_px": [512, 512], "chroma": "4:2:0", "quality": quality, "jpeg_bytes": 9000,
            "threads": threads, "pictures_per_second": rate, "mb_per_second": rate * 0.4,
        }  # fmt: skip

    def test_threads_stand_beside_one_of_the_same_quality(self):
        report = {"jpeg": [self.jpeg(1), self.jpeg(2, rate=190.0), self.jpeg(1, 92, 50.0), self.jpeg(2, 92, 80.0)]}
        rows = figures.jpeg_rows(report)
        self.assertEqual([row["times_one_thread"] for row in rows], [1.0, 1.9, 1.0, 1.6])
        self.assertAlmostEqual(rows[1]["mb_per_second_a_thread"], 38.0)
        self.assertIsNone(figures.jpeg_rows({"jpeg": [self.jpeg(2)]})[0]["times_one_thread"])

    def test_sessions_add_their_frames_and_stand_beside_one(self):
        rows = figures.session_rows([load_report(1, [30.0], 20.0), load_report(3, [20.0, 19.0, None], 50.0, errors=2)])
        self.assertEqual([row["frames_per_second"] for row in rows], [30.0, 39.0])
        self.assertEqual(rows[1]["frames_times_one_session"], 1.3)
        self.assertEqual(rows[1]["p95_times_one_session"], 2.5)
        self.assertEqual(rows[1]["faults"]["errors"], 2)

    def test_a_run_in_which_nobody_was_served_has_no_figures(self):
        (row,) = figures.session_rows([load_report(1, [None], None)])
        self.assertIsNone(row["latency_p95_ms"])
        self.assertIsNone(row["p95_times_one_session"])
        self.assertIn("-", figures.tables({"machine": MACHINE, "sessions": [row]}))

    def test_tables_name_the_machine_and_what_went_wrong(self):
        text = figures.tables({
            "machine": MACHINE,
            "volumes": figures.volume_rows({"frames": [frame("control", 64, ms=5.0), frame("control", 256)]}),
            "sessions": figures.session_rows([load_report(1, [30.0], 20.0, errors=3)]),
        })  # fmt: skip
        self.assertIn("A processor, 2 cores; A renderer (software)", text)
        self.assertIn("x is times that of 256", text)
        self.assertRegex(text, r"control +64 +5\.0 +10\.0 +2\.5 +0\.50")
        self.assertIn("3 errors", text)
        self.assertNotIn("JPEG", text)

    def test_columns_stand_under_their_heads(self):
        text = figures.table("title", ["name", "ms"], [["a", "1.0"], ["longer", "1000"]])
        self.assertEqual(text, "title\n  name      ms\n  a        1.0\n  longer  1000")


class ScalingTest(unittest.TestCase):
    """With the smallest volumes and pictures: that it measures, not how fast anything is."""

    def scaling(self, *arguments):
        command = [sys.executable, "-B", BENCHMARK / "scaling.py", "--binaries", BINARIES, *arguments]
        return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=600)

    def setUp(self):
        if BINARIES is None:
            self.skipTest("no programs were named")

    def test_all_parts_are_measured_and_written(self):
        with tempfile.TemporaryDirectory() as folder:
            report, script = (pathlib.Path(folder) / name for name in ("scaling.json", "script.json"))
            script.write_text(json.dumps(SMALL_SCRIPT))
            done = self.scaling(
                "--edges", "32", "48", "--size", "64x48", "--edge", "32", "--sizes", "32x32", "64x48",
                "--jpeg-sizes", "64x48", "--threads", "1", "2", "--seconds", "0.1", "--clients", "1", "2",
                "--session-seconds", "8", "--script", script, "--json", report,
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            measured = json.loads(report.read_text())
        self.assertEqual([row["edge_voxels"] for row in measured["volumes"]], [32, 32, 48, 48])
        self.assertEqual(len({row["case"] for row in measured["pixels"]}), 2)
        self.assertEqual([row["threads"] for row in measured["jpeg"]], [1, 2, 1, 2])
        self.assertEqual({row["quality"] for row in measured["jpeg"]}, {80, 92})
        self.assertEqual([row["clients"] for row in measured["sessions"]], [1, 2])
        for row in measured["sessions"]:
            self.assertGreater(row["frames_per_second"], 0)
            for name in ("errors", "disconnects", "clients_without_frame"):
                self.assertEqual(row["faults"][name], 0, name)
        self.assertIn(measured["machine"]["renderer"], done.stdout)
        self.assertIn("phantom:head@48", done.stderr, "progress goes to standard error")

    def test_what_cannot_be_measured_is_said(self):
        done = self.scaling("--parts", "pixels", "--edge", "31")
        self.assertEqual(done.returncode, 1)
        self.assertIn("expected 32 to 512 voxels an edge; got 31", done.stderr)
        self.assertIn("cutaway-benchmark ended with 1", done.stderr)


if __name__ == "__main__":
    if len(sys.argv) > 1 and pathlib.Path(sys.argv[1]).is_dir():
        BINARIES = sys.argv.pop(1)
    unittest.main(verbosity=2)
