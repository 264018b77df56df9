"""A process from outside: its memory, descriptors and threads, second by second."""
import os
import pathlib
import threading
import time

FIGURES = ("memory", "descriptors", "threads")
INTERVAL_S = 0.5


def look(pid):
    """{figure: value} now. OSError where there is no such process, or its descriptors are not for us to see, as where
    a server's process.core_dumps is off."""
    process = pathlib.Path(f"/proc/{pid}")
    status = dict(line.split(":", 1) for line in (process / "status").read_text().splitlines())
    return {
        "memory": int(status["VmRSS"].split()[0]) / 1024,
        "descriptors": len(os.listdir(process / "fd")),
        "threads": int(status["Threads"]),
    }


class Watch:
    """`with Watch(pid) as watch`; samples: {figure: [(seconds, value)]}."""

    def __init__(self, pid):
        self._pid = pid
        self._begun = time.monotonic()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._sample)
        self.samples = {figure: [] for figure in FIGURES}

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._ended.set()
        self._thread.join()

    def now_s(self):
        return time.monotonic() - self._begun

    def _sample(self):
        while not self._ended.wait(INTERVAL_S):
            try:
                seen = look(self._pid)
            except (OSError, KeyError):  # it has ended, which others notice
                return
            for figure, value in seen.items():
                self.samples[figure].append((self.now_s(), value))
