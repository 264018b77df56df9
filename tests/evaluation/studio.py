"""Pictures from the product itself: a server that serves one client, which asks for stills."""
import pathlib
import sys
import tempfile

import cv2
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "end_to_end"))
from wire import Client, Picture, Server  # noqa: E402  (a client of protocol/README.md)

SMALL_PX = 96  # of the live picture, which nobody looks at
CONFIG = """\
[server]
idle_timeout_ms = 600000
[session]
still_supersampling = 2
rest_ms = 60000
messages_per_second = 1e6
message_burst = 1e6
[log]
level = "warning"
"""


class Studio:
    """`with Studio(binary, data) as studio`. Pictures are (height, width, 3) RGB in [0, 1],
    display-encoded, float32."""

    def __init__(self, binary, data=None):
        self._config = tempfile.NamedTemporaryFile("w", suffix=".toml")
        self._config.write(CONFIG)
        self._config.flush()
        arguments = ["--config", self._config.name]
        if data is not None:
            arguments += ["--data", str(data)]
        self._server = Server(str(binary), *arguments)
        self._client = Client(self._server.port)
        capabilities = self._client.text("capabilities")
        self.renderer = capabilities["renderer"]
        listed = capabilities["styles"]
        self.styles = {style["name"]: style["scene"] for style in listed}
        self.illustrations = [s["name"] for s in listed if s["group"] == "illustration"]
        self._listing = self._client.text("volumes")
        self._requests = 0
        self._volume = None
        self._resets = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._client.close()
        self._server.stop()
        self._config.close()

    def wait_for(self, volumes):
        """Returns once the server lists all of them that are files."""
        files = [volume for volume in volumes if not volume.startswith("phantom:")]

        def lists_all(message):
            listed = {entry["id"] for entry in message["volumes"]}
            return listed.issuperset(files)

        if not lists_all(self._listing):
            self._await(
                lambda m: isinstance(m, dict) and m["type"] == "volumes" and lists_all(m),
                f"a listing of {', '.join(files)}",
            )

    def open(self, volume):
        """Opens the volume with everything chosen anew; returns the scene as the server resolved
        it."""
        if volume == self._volume:
            return self.reset(self.styles["flagship"])
        self._volume = volume
        self._client.viewport(SMALL_PX, SMALL_PX)
        self._client.scene({"volume": volume, **self.styles["flagship"]}, replace=True)
        return self._told_scene(lambda told: told["volume"] == volume)

    def first_scene(self, volume):
        """Opens the volume as it appears to somebody who says nothing of how; returns that scene,
        resolved."""
        self._volume = volume
        self._client.viewport(SMALL_PX, SMALL_PX)
        sent = self._client.scene({"volume": volume}, replace=True)
        return self._await(
            lambda m: isinstance(m, dict)
            and m["type"] == "scene"
            and m["scene"]["volume"] == volume
            and m["input"] >= sent,
            f"the first scene of {volume}",
        )["scene"]

    def reset(self, scene):
        """The open volume with another scene; what the scene leaves out is chosen anew. Returns it
        resolved, its background aside: that is a mark."""
        self._resets += 1
        # The server tells scenes of its own accord too, some time after a change. By its mark the
        # answer is known; a 1024th is exact in any float.
        mark = [self._resets % 1024 / 1024, 0, 0]
        marked = {**scene, "volume": self._volume, "background": {"colour": mark}}
        self._client.scene(marked, replace=True)
        return self._told_scene(lambda told: told["background"]["colour"] == mark)

    def drag_lens(self, x, y):
        """Puts the lens on the surface under a point of the view, (0, 0) its upper left and (1, 1)
        its lower right corner; returns the centre in mm (LPS). Right after reset, whose answer has
        come: the next scene told is this one's."""
        self._client.send_input("drag_lens", position_px=[x * SMALL_PX, y * SMALL_PX])
        return self._told_scene(lambda told: True)["lens"]["centre_mm"]

    def change(self, scene):
        """Merges a partial scene into the one that is shown."""
        self._client.scene(scene)

    def picture(self, width_px, height_px):
        """The scene as it is, lossless."""
        self._requests += 1
        self._client.send(
            type="save_still", request=self._requests, width_px=width_px, height_px=height_px
        )
        still = self._await(
            lambda m: isinstance(m, Picture) and m.type == 2 and m.number == self._requests,
            "a still",
        )
        stored = cv2.imdecode(numpy.frombuffer(still.data, numpy.uint8), cv2.IMREAD_COLOR)
        return stored[..., ::-1].astype(numpy.float32) / 255

    def _told_scene(self, fits):
        """The next resolved scene that fits."""
        return self._await(
            lambda m: isinstance(m, dict) and m["type"] == "scene" and fits(m["scene"]), "a scene"
        )["scene"]

    def _await(self, fits, what):
        """The next message that fits. Whatever the server refuses ends the evaluation at once."""

        def fits_or_refused(message):
            if isinstance(message, dict) and message["type"] == "error":
                raise RuntimeError(f"the server refused: {message}")
            return fits(message)

        return self._client.until(fits_or_refused, what)
