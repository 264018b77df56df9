"""Drives `cutaway serve` over the wire as protocol/README.md describes it.

Usage: session_test.py CUTAWAY_BINARY [unittest arguments]
"""

import json
import pathlib
import struct
import sys
import tempfile
import unittest

from wire import Client, Closed, Server, WebSocket, jpeg_size, png_size

BINARY = None
HEAD = "phantom:head@64"
KNEES = "phantom:knees@64"
SILENCE_S = 1.5


def nrrd(size):
    """A whole NRRD file of zeros."""
    head = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {' '.join(map(str, size))}\nencoding: raw\n\n"
    return head.encode() + bytes(size[0] * size[1] * size[2])


class ServedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server(BINARY)
        cls.addClassCleanup(cls.server.stop)

    def connect(self):
        client = Client(self.server.port)
        self.addCleanup(client.close)
        return client

    def showing(self, volume=HEAD, width_px=320, height_px=240):
        """A client that has seen the refined frame of a volume."""
        client = self.connect()
        client.open(volume, width_px, height_px)
        client.rest()
        return client


class HttpTest(ServedTest):
    def test_says_that_it_lives_and_is_ready(self):
        self.assertEqual(self.server.get("/healthz")[0], 200)
        self.assertEqual(self.server.get("/readyz")[0], 200)

    def test_lists_the_volumes_as_the_message_does(self):
        status, headers, body = self.server.get("/api/volumes")
        self.assertEqual((status, headers["Content-Type"]), (200, "application/json"))
        message = self.connect().text("volumes")
        self.assertEqual(json.loads(body)["volumes"], message["volumes"])

    def test_refuses_an_unknown_subprotocol_with_426_naming_its_own(self):
        socket = WebSocket(self.server.port, subprotocol="cutaway.v9")
        self.addCleanup(socket.socket.close)
        self.assertEqual(socket.status, 426)
        status, _, body = self.server.get("/ws")
        self.assertEqual(status, 426)
        self.assertIn(b"cutaway.v1", body)


class BeginningTest(ServedTest):
    def test_capabilities_come_first_and_then_the_volumes(self):
        client = self.connect()
        capabilities = client.receive()
        self.assertEqual(capabilities["type"], "capabilities")
        self.assertEqual(capabilities["protocol"], "cutaway.v1")
        self.assertEqual(capabilities["limits"]["frames_in_flight"], 2)
        self.assertIsInstance(capabilities["software_renderer"], bool)
        self.assertIn("flagship", [style["name"] for style in capabilities["styles"]])
        for kind in ("shading", "filter", "lens_shape"):
            for module in capabilities["modules"][kind]:
                self.assertTrue(module["title"])
                for parameter in module["parameters"]:
                    self.assertIn("default", parameter)
        volumes = client.receive()
        self.assertEqual(volumes["type"], "volumes")
        self.assertIn("phantom:head", [volume["id"] for volume in volumes["volumes"]])

    def test_opening_reports_progress_then_the_scene_then_frames(self):
        client = self.connect()
        opening, message = client.open("phantom:head@72")  # of this test alone: what is loaded is not loaded again
        stages = [text["stage"] for text in client.texts if text["type"] == "loading"]
        order = ["read", "decode", "min_max", "upload", "ready"]
        self.assertEqual(stages[-1], "ready")
        self.assertEqual(stages, sorted(stages, key=order.index))
        self.assertIn("upload", stages)
        self.assertEqual(message["scene"]["volume"], "phantom:head@72")
        self.assertEqual(message["volume"]["size_voxels"], [72, 72, 72])
        self.assertEqual(message["volume"]["units"], "HU")
        self.assertEqual(sum(message["volume"]["histogram"]), 72**3)
        for field in ("camera", "focus", "context", "lens", "light", "background"):
            self.assertIn(field, message["scene"])
        frame = client.frame()
        self.assertEqual(frame.input, opening)
        self.assertEqual(frame.clock_ms, opening * 10.5)

    def test_every_frame_is_what_its_header_says(self):
        client = self.showing()
        for frame in client.frames:
            self.assertEqual((frame.type, frame.lossless), (1, False))
            self.assertEqual(jpeg_size(frame.data), (frame.width_px, frame.height_px))
            self.assertEqual(frame.viewport, (320, 240))
            self.assertGreater(frame.render_us, 0)
        numbers = [frame.number for frame in client.frames]
        self.assertEqual(numbers, sorted(set(numbers)))

    def test_a_viewport_of_one_pixel(self):
        client = self.showing(HEAD, 1, 1)
        self.assertEqual(jpeg_size(client.frames[-1].data), (1, 1))


class FlowTest(ServedTest):
    def turn(self, client, steps):
        """A drag: as many cameras as fast as they can be sent."""
        distance = 500.0
        for step in range(steps):
            client.scene({"camera": {"eye_mm": [step * 3.0, -distance, step * 1.0], "target_mm": [0, 0, 0]}})
        return client.inputs

    def test_the_latest_input_wins(self):
        client = self.showing()
        before = len(client.frames)
        last = self.turn(client, 60)
        client.frame(last)
        frames = client.frames[before:]
        shown = [frame.input for frame in frames]
        self.assertEqual(shown, sorted(shown))
        self.assertEqual(shown[-1], last)
        self.assertLess(len(frames), 60, "inputs that came during a frame were not merged")
        revisions = [frame.revision for frame in frames]
        self.assertEqual(revisions, sorted(revisions))

    def test_one_refined_frame_after_rest_and_then_silence(self):
        client = self.showing()
        last = self.turn(client, 5)
        still = client.frame(last, still=True)
        self.assertEqual((still.width_px, still.height_px), (320, 240))
        self.assertIsNone(client.receive(SILENCE_S))

    def test_a_frame_shows_other_pixels_after_another_camera(self):
        client = self.showing()
        before = client.frames[-1].data
        client.scene({"camera": {"eye_mm": [500, 0, 0]}})
        self.assertNotEqual(client.rest().data, before)

    def test_two_frames_at_most_without_acknowledgement(self):
        client = self.connect()
        client.acknowledging = False
        client.open(HEAD)
        for step in range(5):
            self.turn(client, 4)
            client.receive(SILENCE_S / 5)
        while client.receive(SILENCE_S):
            pass
        self.assertEqual(len(client.frames), 2)
        client.acknowledging = True
        client.send(type="ack", frame=client.frames[-1].number)
        self.assertEqual(client.frame(client.inputs).input, client.inputs)

    def test_sessions_do_not_mix(self):
        one = self.showing(HEAD, 320, 240)
        other = self.showing(KNEES, 200, 300)
        last = self.turn(one, 10)
        other.scene({"background": {"colour": [1, 0, 0]}})
        self.assertEqual(one.frame(last).viewport, (320, 240))
        self.assertEqual(other.rest().viewport, (200, 300))


class InteractionTest(ServedTest):
    def test_drag_lens_moves_it_over_the_surface(self):
        client = self.showing()
        dragging = client.send_input("drag_lens", position_px=[190, 120])
        centre = client.text("scene")["scene"]["lens"]["centre_mm"]
        client.frame(dragging)
        dragging = client.send_input("drag_lens", position_px=[140, 110])
        self.assertNotEqual(client.text("scene")["scene"]["lens"]["centre_mm"], centre)
        client.frame(dragging)

    def test_the_lens_is_where_it_was_dragged(self):
        client = self.showing()
        client.send_input("drag_lens", position_px=[160, 120])
        client.scene({"lens": {"mode": "none"}})
        client.send(type="pick", request=1, position_px=[160, 120])
        picked = client.text("picked", request=1)
        client.scene({"lens": {"mode": "cutaway", "centre_mm": None}})
        client.send_input("drag_lens", position_px=[160, 120])
        centre = client.text("scene")["scene"]["lens"]["centre_mm"]
        for axis in range(3):
            self.assertAlmostEqual(picked["position_mm"][axis], centre[axis], delta=0.5)

    def test_pick_answers_with_place_value_and_branch(self):
        client = self.showing()
        client.scene({"lens": {"mode": "none"}})
        client.send(type="pick", request=17, position_px=[160, 120])
        picked = client.text("picked", request=17)
        self.assertEqual((picked["branch"], picked["units"]), ("context", "HU"))
        self.assertEqual(len(picked["position_mm"]), 3)
        client.send(type="pick", request=18, position_px=[0, 0])
        self.assertNotIn("position_mm", client.text("picked", request=18))

    def test_inside_the_lens_the_focus_is_picked(self):
        client = self.showing()
        client.scene({"lens": {"radius_mm": 1500}})
        client.send(type="pick", request=1, position_px=[160, 120])
        self.assertEqual(client.text("picked", request=1)["branch"], "focus")

    def test_save_still_is_a_png_of_its_own_size_and_always_the_same(self):
        client = self.showing()
        for request in (5, 6):
            client.send(type="save_still", request=request, width_px=200, height_px=150)
            client.saved(request)
        first, second = client.stills
        self.assertTrue(first.lossless and first.still)
        self.assertEqual(png_size(first.data), (200, 150))
        self.assertEqual(first.viewport, (200, 150))
        self.assertEqual(first.data, second.data)

    def test_null_takes_a_field_back_and_the_scene_is_told(self):
        client = self.showing()
        client.scene({"lens": {"cap": "open"}})
        client.scene({"lens": {"cap": None}})
        self.assertEqual(client.text("scene")["scene"]["lens"]["cap"], "flat")

    def test_every_style_can_be_applied(self):
        client = self.showing()
        styles = client.texts[0]["styles"]
        for shade, style in enumerate(styles):
            client.scene(style["scene"] | {"background": {"colour": [0, 0, (shade + 1) / len(styles)]}})
            client.rest()
        self.assertFalse([text for text in client.texts if text["type"] == "error"])


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
        cls.server = Server(BINARY, "--data", folder.name)
        cls.addClassCleanup(cls.server.stop)
        cls.listing = cls.scanned()

    @classmethod
    def scanned(cls):
        client = Client(cls.server.port)
        try:
            return client.until(lambda message: message["type"] == "volumes" and message["refused"], "a scan")
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
            server = Server(BINARY, "--data", folder)
            self.addCleanup(server.stop)
            client = Client(server.port)
            self.addCleanup(client.close)
            listed = client.until(lambda message: message["type"] == "volumes" and len(message["volumes"]) > 3, "it")
            path.unlink()
            client.scene({"volume": listed["volumes"][0]["id"]})
            error = client.text("error")
        self.assertEqual(error["field"], "/volume")
        self.assertNotIn(folder, json.dumps(error))


class BadInputTest(ServedTest):
    def refused(self, client, code, field=None):
        error = client.text("error")
        self.assertEqual(error["code"], code, error)
        if field is not None:
            self.assertEqual(error.get("field"), field, error)
        return error

    def test_each_is_refused_and_the_session_goes_on(self):
        client = self.showing()
        for raw in (b"", b"{", b"nonsense", b"\x00", b"[" * 5000):
            client.socket.send(WebSocket.TEXT, raw)
            self.refused(client, "malformed-json")
        client.socket.send(WebSocket.BINARY, b"\x01\x02\x03")
        self.refused(client, "not-text")
        client.send(type="reboot")
        self.refused(client, "unknown-message")
        client.send(type="ack", frame=1, extra=1)
        self.refused(client, "unknown-field", "/extra")
        client.send(type="pick", request=4)
        self.assertEqual(self.refused(client, "missing-field", "/position_px")["request"], 4)
        bad = client.scene({"lens": {"radius_mm": "large"}})
        self.assertEqual(self.refused(client, "wrong-type", "/lens/radius_mm")["input"], bad)
        client.scene({"lens": {"radius_mm": -1}})
        self.assertIn("2000", self.refused(client, "out-of-range", "/lens/radius_mm")["expected"])
        client.scene({"focus": {"shading": {"name": "sparkle"}}})
        self.refused(client, "unknown-module")
        client.scene({"camera": {"eye_mm": [1, 2, 3], "target_mm": [1, 2, 3]}})
        self.refused(client, "invalid-scene")
        client.viewport(100_000, 100_000)
        self.refused(client, "out-of-range")
        client.socket.send(
            WebSocket.TEXT, b'{"type":"scene","input":1,"clock_ms":0,"scene":{"lens":{"radius_mm":1e999}}}'
        )
        self.refused(client, "not-finite")
        client.frame(client.scene({"background": {"colour": [0, 0.1, 0.1]}}))

    def test_a_camera_inside_the_bone_is_rendered(self):
        client = self.showing()
        client.frame(client.scene({"camera": {"eye_mm": [0, 0, 60], "target_mm": [0, 0, 0], "up": [0, 1, 0]}}))

    def test_over_64_kib_is_refused_and_the_session_goes_on(self):
        client = self.showing()
        for size in (64 * 1024 + 1, 1_000_000):
            client.socket.send(WebSocket.TEXT, b" " * size)
            error = self.refused(client, "too-large")
            self.assertEqual(error["expected"], "at most 65536 bytes")
            self.assertEqual(error["received"], f"{size} bytes")
        client.frame(client.scene({"background": {"colour": [0, 0.1, 0.1]}}))

    def test_over_16_mib_closes_with_1009(self):
        client = self.connect()
        client.socket.announce(WebSocket.TEXT, (16 << 20) + 1)
        with self.assertRaises(Closed) as closed:
            while True:
                client.receive()
        self.assertEqual(closed.exception.code, 1009)

    def test_text_that_is_not_utf8_closes_with_1007(self):
        client = self.connect()
        client.socket.send(WebSocket.TEXT, b'{"type":"\xc3\x28"}')
        with self.assertRaises(Closed) as closed:
            while True:
                client.receive()
        self.assertEqual(closed.exception.code, 1007)

    def test_a_client_that_dies_disturbs_nobody(self):
        client = self.showing()
        for _ in range(5):
            dying = self.connect()
            dying.viewport(640, 480)
            dying.scene({"volume": HEAD})
            dying.socket.socket.setsockopt(1, 13, struct.pack("ii", 1, 0))  # SO_LINGER: reset
            dying.socket.socket.close()
        client.frame(client.scene({"background": {"colour": [0.1, 0.1, 0.1]}}))


class ReconnectTest(ServedTest):
    def test_the_view_is_restored(self):
        client = self.connect()
        client.open(HEAD)
        client.scene({"camera": {"eye_mm": [300, -400, 100]}, "lens": {"radius_mm": 33}})
        client.send_input("drag_lens", position_px=[150, 110])
        scene = client.text("scene")["scene"]
        client.rest()
        client.send(type="save_still", request=1, width_px=160, height_px=120)
        before = client.saved(1)
        client.close()
        again = self.connect()
        again.viewport(320, 240)
        again.scene(scene, replace=True)
        again.text("loading", stage="ready")
        again.rest()
        again.send(type="save_still", request=1, width_px=160, height_px=120)
        self.assertEqual(again.saved(1).data, before.data)


class StopTest(unittest.TestCase):
    def test_stopping_says_going_away_and_ends_well(self):
        server = Server(BINARY)
        client = Client(server.port)
        client.open(HEAD)
        server.process.terminate()
        with self.assertRaises(Closed) as closed:
            while True:
                client.receive()
        self.assertEqual(closed.exception.code, 1001)
        client.socket.close()
        self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    BINARY = sys.argv.pop(1)
    unittest.main(verbosity=2)
