"""What a client may send wrong, and clients that die.

Usage: bad_input_test.py CUTAWAY_BINARY [unittest arguments]
"""

import struct
import threading

from png import png_pixels
from served import HEAD, ServedTest, run
from wire import Closed, WebSocket


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
        limit = client.texts[0]["limits"]["viewport_side_px"]
        client.viewport(100_000, 100_000)
        self.assertEqual(self.refused(client, "out-of-range", "/width_px")["expected"], f"1 to {limit} px")
        limit = client.texts[0]["limits"]["still_side_px"]
        client.send(type="save_still", request=5, width_px=64, height_px=limit + 1)
        self.assertEqual(self.refused(client, "out-of-range", "/height_px")["expected"], f"1 to {limit} px")
        client.send(type="ack", frame=2_147_483_700)
        self.refused(client, "out-of-range", "/frame")
        client.socket.send(
            WebSocket.TEXT, b'{"type":"scene","input":7,"clock_ms":0,"scene":{"lens":{"radius_mm":1e999}}}'
        )
        self.assertEqual(self.refused(client, "not-finite", "/lens/radius_mm")["input"], 7)
        client.frame(client.scene({"background": {"colour": [0, 0.1, 0.1]}}))

    def picked(self, client):
        client.send(type="pick", request=1, position_px=[160, 120])
        return client.text("picked", request=1)

    def share_of_background(self, client):
        client.send(type="save_still", request=2, width_px=80, height_px=60)
        pixels = png_pixels(client.saved(2).data)
        return pixels.count(b"\x00\x00\xff") / len(pixels)

    def test_a_camera_inside_the_bone_is_rendered(self):
        client = self.connect()
        _, opened = client.open(HEAD)
        front = {"eye_mm": [2.2, -678, 0], "target_mm": [2.2, -15, 0], "up": [0, 0, 1]}
        client.scene({"camera": front, "lens": {"radius_mm": 1500}, "background": {"colour": [0, 0, 1]}})
        x, y, z = self.picked(client)["position_mm"]  # from the front, of the skull
        self.assertGreater(self.share_of_background(client), 0.2)
        eye = [x, y + 3, z]
        # A lens that begins there, with no skin before it, cuts a face into what it holds: bone.
        lens = {"centre_mm": [x, y + 3 + 500, z], "radius_mm": 500}
        client.scene({"lens": lens, "context": {"surface": {"iso_value": 3000}}})
        picked = self.picked(client)
        self.assertEqual(picked["branch"], "focus")
        self.assertAlmostEqual(picked["position_mm"][1], eye[1], delta=0.5)
        self.assertGreater(picked["value"], opened["volume"]["inner_iso_value"] + 100, "the eye is in no bone")
        inside = {"eye_mm": eye, "target_mm": [x, y + 100, z]}
        client.scene({"camera": inside, "lens": {"mode": "none"}, "context": {"surface": {"iso_value": -200}}})
        # No cut where the eye stands: it sees the walls of the cavities around it.
        share = self.share_of_background(client)
        self.assertLess(share, 0.5)
        self.assertNotEqual(self.picked(client).get("branch"), "focus")
        self.assertFalse([text for text in client.texts if text["type"] == "error"])

    def largest_viewport(self, client):
        limits = client.texts[0]["limits"]
        side_px = min(limits["viewport_side_px"], int(limits["viewport_pixels"] ** 0.5))
        client.viewport(side_px, side_px)
        return side_px

    def test_the_largest_viewport_leaves_the_others_undisturbed(self):
        """Frames are counted, not time: one that is small gets many while the large one's refined frame is drawn."""
        small = self.showing(HEAD, 64, 48)
        large = self.showing(HEAD, 64, 48)
        side_px = self.largest_viewport(large)
        seen = threading.Event()

        def wait_for_refined_frame():
            self.assertEqual(large.rest().viewport, (side_px, side_px))
            seen.set()

        waiting = threading.Thread(target=wait_for_refined_frame)
        waiting.start()
        before = len(small.frames)
        while not seen.is_set():
            small.frame(small.scene({"camera": {"eye_mm": [small.inputs * 2.0, -500, 0]}}))
        waiting.join()
        self.assertGreater(len(small.frames) - before, 8)

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


if __name__ == "__main__":
    run()
