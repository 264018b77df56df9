"""Runs the load client against `cutaway serve`, as a person does.

Usage: load_client_test.py CUTAWAY_BINARY LOAD_BINARY [unittest arguments]
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "end_to_end"))
from wire import Server  # noqa: E402

SERVER_BINARY = LOAD_BINARY = None
HELD, NOT_HELD, WRONG_USAGE = 0, 1, 2


def script(thresholds, **fields):
    return {
        "title": "Three at a small picture",
        "volume": "phantom:head@32",
        "style": "flagship",
        "roles": [
            {
                "name": "viewer",
                "viewport": {"width_px": 96, "height_px": 72},
                "inputs_per_second": 20,
                "motion": [
                    {"for_s": 1.2, "motion": {"orbit": {"degrees_per_second": 60}}},
                    {"for_s": 1.2, "think_s": [0.5, 0.5], "motion": {"drag_lens": {}}},
                ],
            }
        ],
        "thresholds": thresholds,
        **fields,
    }


class LoadClientTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server(SERVER_BINARY)
        cls.addClassCleanup(cls.server.stop)
        cls.url = f"ws://127.0.0.1:{cls.server.port}/ws"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def load(self, document, *arguments, url=None):
        """Exit status, standard output, standard error."""
        path = self.folder / "script.json"
        path.write_text(json.dumps(document))
        command = [LOAD_BINARY, path, "--url", url or self.url, *arguments]
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout, done.stderr

    def test_three_clients_are_served_and_the_thresholds_hold(self):
        report, page = self.folder / "report.json", self.folder / "report.html"
        status, output, errors = self.load(
            script({"frames_per_second": 0.1, "first_frame_s": 60}),
            "--clients", 3, "--seconds", 4, "--json", report, "--html", page, "--watch-pid", self.server.process.pid,
        )  # fmt: skip
        self.assertEqual(status, HELD, output + errors)
        self.assertNotIn("NOT HELD", output)
        figures = json.loads(report.read_text())
        self.assertEqual(len(figures["clients"]), 3)
        for client in figures["clients"]:
            self.assertGreater(client["frames"], 3)
            self.assertGreater(client["latency_ms"]["count"], 0)
            self.assertEqual((client["errors"], client["stale_frames"], client["disconnected"]), (0, 0, False))
        self.assertGreater(figures["memory"][0]["mib"], 10)
        self.assertIn("</svg>", page.read_text())

    def test_an_impossible_threshold_is_named_with_what_was_measured(self):
        status, output, _ = self.load(script({"latency_p95_ms": 0.001}), "--clients", 1, "--seconds", 3)
        self.assertEqual(status, NOT_HELD, output)
        self.assertRegex(output, r"NOT HELD +latency p95 +expected at most 0\.001 ms, measured \d")

    def test_a_slow_link_and_a_slow_reader_are_served_too(self):
        document = script({"frames_per_second": 0.1})
        document["roles"][0]["link"] = {"bytes_per_second": 100000, "delay_ms": 10}
        sleeper = json.loads(json.dumps(document["roles"][0]))
        document["roles"].append({**sleeper, "name": "sleeper", "reading": {"stops_after_s": 0.5, "for_s": 1}})
        status, output, errors = self.load(document, "--clients", 2, "--seconds", 5)
        self.assertEqual(status, HELD, output + errors)

    def test_what_the_server_refuses_is_reported_in_its_words(self):
        status, output, _ = self.load(script({}, volume="phantom:nothing"), "--clients", 1, "--seconds", 1)
        self.assertEqual(status, NOT_HELD)
        self.assertIn("unknown-volume", output)
        status, output, _ = self.load(script({}, style="no-such"), "--clients", 1, "--seconds", 1)
        self.assertEqual(status, NOT_HELD)
        self.assertIn("expected one of", output)
        status, output, _ = self.load(script({}), "--clients", 1, "--seconds", 1, url="ws://127.0.0.1:1/ws")
        self.assertEqual(status, NOT_HELD)
        self.assertIn("refused", output)

    def test_an_address_without_the_path_is_said_to_be_one(self):
        page = self.folder / "index.html"
        page.write_text("<!doctype html><title>the page</title>")
        server = Server(SERVER_BINARY, "--web-root", self.folder)
        self.addCleanup(server.stop)
        for path, answer in (("", 200), ("/", 200), ("/wss", 404)):
            url = f"ws://127.0.0.1:{server.port}{path}"
            status, output, _ = self.load(script({}), "--clients", 1, "--seconds", 1, url=url)
            self.assertEqual(status, NOT_HELD)
            self.assertIn(f"the server answers {answer} and no WebSocket at the path {path or '/'}; expected ws:", output)
            self.assertNotIn("<", output)

    def test_wrong_usage_and_wrong_scripts_are_told_apart(self):
        self.assertEqual(self.load(script({}), url="http://127.0.0.1/ws")[0], WRONG_USAGE)
        self.assertEqual(self.load(script({}), "--clients", 0)[0], WRONG_USAGE)
        self.assertEqual(self.load(script({}), "--seconds", 2, "--ramp", 3)[0], WRONG_USAGE)
        status, _, errors = self.load(script({"fairness": 3}))
        self.assertEqual(status, NOT_HELD)
        self.assertIn("/thresholds/fairness: expected a number, 0 to 1; came 3", errors)


if __name__ == "__main__":
    SERVER_BINARY, LOAD_BINARY = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
