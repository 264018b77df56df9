"""Drives `cutaway serve` over the wire as protocol/README.md describes it: a session from its beginning to its end.

Usage: session_test.py CUTAWAY_BINARY [unittest arguments]
"""

import json
import unittest

from served import HEAD, KNEES, ServedTest, run, serve
from wire import Client, Closed, WebSocket, jpeg_size

SILENCE_S = 1.5


class HttpTest(ServedTest):
    def test_says_that_it_lives_and_is_ready(self):
        self.assertEqual(self.server.get("/healthz")[0], 200)
        self.assertEqual(self.server.get("/readyz")[0], 200)

    def test_lists_the_volumes_as_the_message_does(self):
        status, headers, body = self.server.get("/api/volumes")
        self.assertEqual((status, headers["Content-Type"]), (200, "application/json"))
        message = self.connect().text("volumes")
        self.assertEqual(json.loads(body)["volumes"], message["volumes"])
        self.assertFalse(json.loads(body)["scanning"])

    def test_refuses_an_unknown_subprotocol_with_426_naming_its_own(self):
        socket = WebSocket(self.server.port, subprotocol="cutaway.v9")
        self.addCleanup(socket.socket.close)
        self.assertEqual(socket.status, 426)
        status, _, body = self.server.get("/ws")
        self.assertEqual(status, 426)
        self.assertIn(b"cutaway.v1", body)

    def test_answers_only_what_was_meant_for_this_machine(self):
        for path in ("/", "/api/volumes", "/ws"):
            self.assertEqual(self.server.get(path, headers={"Host": "evil.example"})[0], 421)
        self.assertEqual(self.server.get("/healthz", headers={"Host": "localhost"})[0], 200)


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
        client.scene({"context": {"shadow": {"strength": 0}, "occlusion": {"strength": 0}},
                      "focus": {"shadow": {"strength": 0}, "occlusion": {"strength": 0}}})
        last = self.turn(client, 5)
        still = client.frame(last, still=True)
        self.assertEqual((still.width_px, still.height_px), (320, 240))
        self.assert_silent(client)

    def test_what_takes_longer_comes_in_one_still_more(self):
        client = self.showing()
        still = client.frame(self.turn(client, 5), still=True)
        finished = client.receive(SILENCE_S)
        if finished is None:
            self.skipTest("the machine is fast enough to have it in the first still")
        self.assertEqual((finished.still, finished.revision), (True, still.revision))
        self.assertNotEqual(finished.data, still.data)
        self.assert_silent(client)

    def assert_silent(self, client):
        picture = client.receive(SILENCE_S)
        self.assertTrue(picture is None, "a picture came")

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
        server = serve()
        client = Client(server.port)
        client.open(HEAD)
        server.process.terminate()
        with self.assertRaises(Closed) as closed:
            while True:
                client.receive()
        self.assertEqual(closed.exception.code, 1001)
        client.socket.close()
        self.assertEqual(server.process.wait(timeout=60), 0)  # a second signal would end it at once


if __name__ == "__main__":
    run()
