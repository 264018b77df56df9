"""Clients that come, look at something, save a still and go again, while others stay."""
import itertools
import threading

from wire import Client

VOLUMES = ("phantom:head@64", "phantom:knees@64", "phantom:abdomen@64", "phantom:head@96")
SIZES = ((320, 240), (97, 61), (640, 360), (1, 1))


class Visitors:
    """`with Visitors(port, now_s, count)`: each on a thread of its own. latencies: (seconds, ms from an input to
    the frame that shows it); failures: in words; visits: how many went well."""

    def __init__(self, port, now_s, count):
        self._port, self._now_s = port, now_s
        self._ended = threading.Event()
        self._threads = [threading.Thread(target=self._come_and_go, args=(i,)) for i in range(count)]
        self.latencies, self.failures, self.visits = [], [], 0

    def __enter__(self):
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_):
        self._ended.set()
        for thread in self._threads:
            thread.join()

    def _come_and_go(self, index):
        for visit in itertools.count(index):
            if self._ended.is_set():
                return
            try:
                self._visit(VOLUMES[visit % len(VOLUMES)], SIZES[visit % len(SIZES)])
                self.visits += 1
            except Exception as failure:  # whatever it is, the soak has found it
                self.failures.append(f"{self._now_s():.0f} s: {failure!r}")
                self._ended.wait(1)

    def _visit(self, volume, size):
        client = Client(self._port)
        try:
            client.open(volume, *size)
            client.rest()
            for width_px in (200, 240, 280):
                sent = self._now_s()
                client.frame(client.viewport(width_px, 150))
                self.latencies.append((self._now_s(), 1000 * (self._now_s() - sent)))
            client.send(type="save_still", request=1, width_px=64, height_px=48)
            client.saved(1)
        finally:
            client.close()
