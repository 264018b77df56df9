"""Views of every size, changing all the time: each live frame is a whole JPEG of the size that its header says, and no
picture holds a byte that its scene does not explain.

Twenty seconds, or as many as CUTAWAY_SECONDS says: `CUTAWAY_SECONDS=600 python3 viewports_test.py BINARY`."""

import os
import random
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

from served import HEAD, run, serve
from wire import Client, Picture, jpeg_size, png_size

SECONDS = float(os.environ.get("CUTAWAY_SECONDS", "20"))
SESSIONS = 12 if SECONDS >= 60 else 4
VIEWS = 4
MOST_PATIENCE_S = 5.0

# What once ended the server, what is one pixel wide, and what is odd where chroma is halved.
SIZES = [(2049, 1), (1, 2049), (2060, 200), (2560, 1440), (3840, 1066), (1, 1), (1025, 3), (4096, 999), (640, 480)]
LOOKS = [
    {"lens": {"mode": "magic"}},
    {"lens": {"mode": "cutaway"}},
    {"context": {"filters": [{"name": "kuwahara", "radius": 5}]}},
    {"context": {"filters": [{"name": "sobel"}], "surface": {"opacity": 0.5}}},
    {"context": {"surface": {"opacity": 1.0}}},
]

CONFIG = """
[session]
viewport_pixels = {viewport_pixels}
still_supersampling = 1
rest_ms = 60
[renderer]
view_bytes = {view_bytes}
"""


def serve_with(test, **values):
    file = tempfile.NamedTemporaryFile("w", suffix=".toml", delete=False)
    test.addCleanup(os.unlink, file.name)
    with file:
        file.write(CONFIG.format(**values))
    server = serve("--config", file.name)
    test.addCleanup(lambda: test.assertEqual(server.stop(), 0, "the server ends by itself, without a fault"))
    return server


def check(picture):
    """A live frame is what its header says; anything else is not looked at."""
    if not isinstance(picture, Picture):
        return 0
    if picture.type == 1:
        assert not picture.lossless, "a live frame is lossy"
        assert jpeg_size(picture.data) == (picture.width_px, picture.height_px), "the JPEG's size is another"
        if picture.still:
            assert (picture.width_px, picture.height_px) == picture.viewport, "a still has the view's size"
    else:
        assert picture.lossless
        assert png_size(picture.data) == (picture.width_px, picture.height_px), "the PNG's size is another"
    return 1


class Wanderer:
    """One session whose views change at random, as the limits allow."""

    def __init__(self, server, seed):
        self.random = random.Random(seed)
        self.client = Client(server.port)
        self.limits = self.client.text("capabilities")["limits"]
        self.client.viewport(320, 240)
        self.client.scene({"volume": HEAD})
        self.client.text("scene")
        self.checked = 0
        self.request = 0

    def size(self):
        side_px, pixels = self.limits["viewport_side_px"], self.limits["viewport_pixels"]
        if self.random.random() < 0.6:
            width_px, height_px = self.random.choice(SIZES)
        else:
            width_px, height_px = (int(side_px ** self.random.random()) for _ in range(2))
        return width_px, max(1, min(height_px, pixels // width_px))

    def change(self):
        """Sends something. Returns the view whose refined frame is to be waited for, and its input."""
        kind = self.random.random()
        if kind < 0.7:
            view = self.random.randrange(VIEWS)
            return view, self.client.viewport(*self.size(), view=view)
        if kind < 0.95:
            return 0, self.client.scene(self.random.choice(LOOKS))
        self.request += 1
        self.client.send(type="save_still", request=self.request, width_px=2100, height_px=60)
        return None

    def look(self, until, wanted=lambda picture: False):
        """Checks what comes until then, or until a picture is wanted."""
        while time.monotonic() < until:
            message = self.client.receive(until - time.monotonic())
            self.checked += check(message)
            if isinstance(message, Picture) and wanted(message):
                return

    def wander(self, until):
        try:
            while time.monotonic() < until:
                changed = self.change()
                if changed is None or self.random.random() < 0.4:
                    self.look(time.monotonic() + self.random.choice((0.01, 0.05, 0.4)))
                    continue
                # What did not change the picture makes none: then that is all.
                view, stamp = changed
                self.look(
                    min(until, time.monotonic() + MOST_PATIENCE_S),
                    lambda picture: picture.still and picture.view == view and picture.input >= stamp,
                )
            errors = [text for text in self.client.texts if text["type"] == "error"]
            assert all(error["code"] == "rate-limited" for error in errors), errors
        finally:
            self.client.close()
        return self.checked


class ViewportsTest(unittest.TestCase):
    def wander_about(self, server, seconds):
        wanderers = [Wanderer(server, seed) for seed in range(SESSIONS)]
        until = time.monotonic() + seconds
        with ThreadPoolExecutor(SESSIONS) as pool:
            checked = sum(pool.map(lambda wanderer: wanderer.wander(until), wanderers))
        print(f"{checked} pictures", flush=True)
        self.assertGreater(checked, 0)

    def test_every_frame_is_a_jpeg_of_its_announced_size(self):
        self.wander_about(serve_with(self, viewport_pixels=4096 * 2304, view_bytes=0), SECONDS / 2)

    def test_so_is_one_that_is_drawn_in_parts(self):
        self.wander_about(serve_with(self, viewport_pixels=4096 * 2304, view_bytes=96 << 20), SECONDS / 2)

    def still(self, client, width_px, height_px, view=0):
        """The refined frame of a size."""
        stamp = client.viewport(width_px, height_px, view=view)
        picture = client.frame(input=stamp, still=True, view=view)
        check(picture)
        self.assertEqual(picture.viewport, (width_px, height_px))
        return picture.data

    def test_stills_of_one_scene_and_size_are_one_picture(self):
        for view_bytes in (0, 64 << 20):
            server = serve_with(self, viewport_pixels=4096 * 2304, view_bytes=view_bytes)
            first, second = Client(server.port), Client(server.port)
            for client in (first, second):
                self.addCleanup(client.close)
                client.open(HEAD, 320, 240)
                client.rest()
            # Other frames of the second session in between, so that its buffers held other pictures.
            for i, size in enumerate(((2560, 1440), (2049, 301), (1, 2050))):
                self.still(second, 500 + i, 400)
                self.still(second, 701 + i, 33, view=1)
                self.assertEqual(self.still(first, *size), self.still(second, *size), size)
                self.assertEqual(self.still(first, *size, view=2), self.still(second, *size, view=2), size)

    def test_a_picture_in_parts_is_the_whole_one(self):
        stills = []
        for view_bytes in (0, 64 << 20):
            server = serve_with(self, viewport_pixels=4096 * 2304, view_bytes=view_bytes)
            client = Client(server.port)
            self.addCleanup(client.close)
            client.open(HEAD, 320, 240)
            client.rest()
            client.send(type="save_still", request=1, width_px=1501, height_px=1101)
            stills.append(client.saved(1).data)
        whole, parted = stills
        self.assertEqual(whole, parted)


if __name__ == "__main__":
    run()
