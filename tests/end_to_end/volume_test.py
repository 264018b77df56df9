"""Opening volumes, from phantoms and from a data folder.

Usage: volume_test.py CUTAWAY_BINARY [unittest arguments]
"""

import json
import pathlib
import tempfile
import unittest

from served import HEAD, KNEES, ServedTest, run, serve
from wire import Client


def nrrd(size):
    """A whole NRRD file of zeros."""
    head = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {' '.join(map(str, size))}\nencoding: raw\n\n"
    return head.encode() + bytes(size[0] * size[1] * size[2])


class VolumeTest(ServedTest):
    def test_another_volume_with_the_style_kept_and_the_view_chosen_anew(self):
        client = self.showing()
        client.scene({"background": {"colour": [0.5, 0, 0]}, "camera": {"eye_mm": [900, 0, 0]}})
        client.rest()
        client.scene({"volume": KNEES})
        client.text("loading", volume=KNEES, stage="ready")
        message = client.text("scene")
        self.assertEqual(message["scene"]["volume"], KNEES)
        self.assertEqual(message["scene"]["background"]["colour"], [0.5, 0, 0])
        self.assertNotEqual(message["scene"]["camera"]["eye_mm"][0], 900)
        client.rest()

    def test_a_cancelled_load_leaves_what_was_shown(self):
        client = self.showing()
        client.scene({"volume": "phantom:abdomen@512"})
        client.send(type="cancel_load")
        client.text("loading", volume="phantom:abdomen@512", stage="cancelled")
        shown = client.scene({"background": {"colour": [0, 0.2, 0]}})
        client.frame(shown)
        client.send_input("drag_lens", position_px=[150, 100])
        self.assertEqual(client.text("scene")["scene"]["volume"], HEAD)

    def test_an_unknown_volume_leaves_what_was_shown(self):
        client = self.showing()
        bad = client.scene({"volume": "nowhere"})
        error = client.text("error")
        self.assertEqual((error["code"], error["field"], error["received"]), ("unknown-volume", "/volume", "nowhere"))
        self.assertEqual(error["input"], bad)
        client.text("loading", volume="nowhere", stage="failed")
        client.frame(client.scene({"background": {"colour": [0, 0.2, 0]}}))

    def test_changes_during_a_load_are_kept(self):
        client = self.showing()
        client.scene({"volume": "phantom:knees@80"})
        client.scene({"background": {"colour": [0, 0, 0.5]}})
        client.text("loading", stage="ready")
        message = client.text("scene")
        self.assertEqual(message["scene"]["background"]["colour"], [0, 0, 0.5])


class DataTest(unittest.TestCase):
    """A data folder with files that cannot be shown."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        (cls.folder / "long.nrrd").write_bytes(nrrd((20_000, 4, 4)))
        (cls.folder / "short.nrrd").write_bytes(nrrd((8, 8, 8))[:-5])
        cls.server = serve("--data", folder.name)
        cls.addClassCleanup(cls.server.stop)
        cls.listing = cls.scanned()

    @classmethod
    def scanned(cls):
        client = Client(cls.server.port)
        try:
            return client.until(lambda message: message["type"] == "volumes" and not message["scanning"], "a scan")
        finally:
            client.close()

    def setUp(self):
        if not any(volume["format"] == "NRRD" for volume in self.listing["volumes"]):
            self.skipTest("this build reads no files")
        self.client = Client(self.server.port)
        self.addCleanup(self.client.close)

    def test_a_broken_file_is_listed_from_the_data_folder_on(self):
        self.assertEqual([entry["path"] for entry in self.listing["refused"]], ["short.nrrd"])
        self.assertNotIn(str(self.folder), json.dumps(self.listing))

    def test_a_volume_that_the_renderer_cannot_hold_leaves_what_was_shown(self):
        (long_one,) = [volume["id"] for volume in self.listing["volumes"] if volume["format"] == "NRRD"]
        self.client.open(HEAD)
        self.client.rest()
        before = len(self.client.texts)
        self.client.scene({"volume": long_one})
        error = self.client.text("error")
        self.assertEqual((error["code"], error["field"], error["received"]), ("volume-refused", "/volume", "20000"))
        self.client.text("loading", volume=long_one, stage="failed")
        stages = [text["stage"] for text in self.client.texts[before:] if text["type"] == "loading"]
        self.assertEqual(stages, ["failed"], "voxels were read for nothing")
        self.client.frame(self.client.scene({"background": {"colour": [0, 0.2, 0]}}))

    def test_a_file_that_is_gone_is_refused_without_its_path(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "gone.nrrd"
            path.write_bytes(nrrd((8, 8, 8)))
            server = serve("--data", folder)
            self.addCleanup(server.stop)
            client = Client(server.port)
            self.addCleanup(client.close)
            listed = client.until(lambda message: message["type"] == "volumes" and len(message["volumes"]) > 3, "it")
            path.unlink()
            client.scene({"volume": listed["volumes"][0]["id"]})
            error = client.text("error")
        self.assertEqual(error["field"], "/volume")
        self.assertNotIn(folder, json.dumps(error))


if __name__ == "__main__":
    run()
