"""A client of the wire that protocol/README.md describes, on plain sockets: no library and nothing of the server's."""

import base64
import hashlib
import http.client
import json
import os
import re
import signal
import socket
import struct
import subprocess
import tempfile
import time
from dataclasses import dataclass

GENEROUS_S = 120.0  # for a software renderer on a busy machine


class Closed(Exception):
    """The other side has closed the connection."""

    def __init__(self, code=None):
        super().__init__(f"closed with {code}")
        self.code = code


class WebSocket:
    """RFC 6455, as much of it as a client needs."""

    TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
    GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"

    def __init__(self, port, subprotocol="cutaway.v1", path="/ws", source="127.0.0.1"):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=GENEROUS_S, source_address=(source, 0))
        self.buffer = b""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(
            (
                f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: {subprotocol}\r\n\r\n"
            ).encode()
        )
        while b"\r\n\r\n" not in self.buffer:
            self._fill()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        lines = head.decode().split("\r\n")
        self.status = int(lines[0].split()[1])
        self.headers = {name.lower(): value.strip() for name, value in (line.split(":", 1) for line in lines[1:])}
        if self.status == 101:
            accept = base64.b64encode(hashlib.sha1((key + self.GUID).encode()).digest()).decode()
            assert self.headers["sec-websocket-accept"] == accept, "the server's handshake does not fit the key"

    def send(self, opcode, payload):
        mask = os.urandom(4)
        masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))
        self.socket.sendall(self.head(opcode, len(payload)) + mask + masked)

    def announce(self, opcode, length):
        """Sends the head of a message and nothing of its payload."""
        self.socket.sendall(self.head(opcode, length) + os.urandom(4))

    @staticmethod
    def head(opcode, length):
        if length < 126:
            return struct.pack("!BB", 0x80 | opcode, 0x80 | length)
        if length < 65536:
            return struct.pack("!BBH", 0x80 | opcode, 0x80 | 126, length)
        return struct.pack("!BBQ", 0x80 | opcode, 0x80 | 127, length)

    def receive(self, timeout_s=GENEROUS_S):
        """The next message as (opcode, payload); None when none comes in time."""
        deadline = time.monotonic() + timeout_s
        parts = []
        kind = None
        while True:
            frame = self._frame(deadline)
            if frame is None:
                return None
            final, opcode, payload = frame
            if opcode == self.PING:
                self.send(self.PONG, payload)
                continue
            if opcode == self.PONG:
                continue
            if opcode == self.CLOSE:
                raise Closed(struct.unpack("!H", payload[:2])[0] if len(payload) >= 2 else None)
            kind = opcode or kind
            parts.append(payload)
            if final:
                return kind, b"".join(parts)

    def close(self):
        try:
            self.send(self.CLOSE, struct.pack("!H", 1000))
        except OSError:
            pass
        self.socket.close()

    def _frame(self, deadline):
        if not self._want(2, deadline):
            return None
        first, second = self.buffer[0], self.buffer[1]
        assert not second & 0x80, "a server never masks"
        length, offset = second & 0x7F, 2
        if length == 126:
            self._want(4, None)
            length, offset = struct.unpack("!H", self.buffer[2:4])[0], 4
        elif length == 127:
            self._want(10, None)
            length, offset = struct.unpack("!Q", self.buffer[2:10])[0], 10
        self._want(offset + length, None)
        payload = self.buffer[offset : offset + length]
        self.buffer = self.buffer[offset + length :]
        return bool(first & 0x80), first & 0x0F, payload

    def _want(self, count, deadline):
        while len(self.buffer) < count:
            remaining = GENEROUS_S if deadline is None else deadline - time.monotonic()
            if remaining <= 0:
                return False
            self.socket.settimeout(remaining)
            try:
                self._fill()
            except TimeoutError:
                if deadline is None:
                    raise
                return False
        return True

    def _fill(self):
        try:
            received = self.socket.recv(1 << 20)
        except ConnectionResetError:
            raise Closed() from None
        if not received:
            raise Closed()
        self.buffer += received


@dataclass
class Picture:
    """A binary message."""

    type: int
    view: int
    still: bool
    lossless: bool
    number: int
    revision: int
    input: int
    clock_ms: float
    render_us: int
    encode_us: int
    width_px: int
    height_px: int
    viewport: tuple
    data: bytes

    @staticmethod
    def parse(message):
        magic, version, kind, flags, _, header_bytes, view = struct.unpack_from("<IBBBBHH", message, 0)
        assert message[:4] == b"CTWF" and magic == 0x46575443
        assert version == 1 and header_bytes >= 56 and view <= 3
        number, revision, last_input, clock_ms = struct.unpack_from("<IIId", message, 12)
        render_us, encode_us, width, height, viewport_width, viewport_height, size = struct.unpack_from(
            "<IIHHHHI", message, 32
        )
        data = message[header_bytes:]
        assert len(data) == size, f"{size} bytes were announced and {len(data)} came"
        return Picture(
            kind, view, bool(flags & 1), bool(flags & 2), number, revision, last_input, clock_ms, render_us, encode_us,
            width, height, (viewport_width, viewport_height), data,
        )  # fmt: skip


def jpeg_size(data):
    """Width and height from the frame header of a JPEG."""
    assert data[:2] == b"\xff\xd8" and data[-2:] == b"\xff\xd9", "not a whole JPEG"
    position = 2
    while True:
        marker, length = struct.unpack_from("!HH", data, position)
        if marker in (0xFFC0, 0xFFC1, 0xFFC2):
            height, width = struct.unpack_from("!HH", data, position + 5)
            return width, height
        position += 2 + length


def png_size(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    return struct.unpack_from("!II", data, 16)


class Client:
    """A session: sends inputs, acknowledges frames, keeps what came."""

    def __init__(self, port, source="127.0.0.1"):
        """source: an address of this machine, such as 127.0.0.2."""
        self.socket = WebSocket(port, source=source)
        assert self.socket.status == 101, self.socket.status
        self.texts = []
        self.frames = []
        self.stills = []
        self.inputs = 0
        self.acknowledging = True

    def send(self, **message):
        self.socket.send(WebSocket.TEXT, json.dumps(message).encode())

    def send_input(self, type, **fields):
        self.inputs += 1
        self.send(type=type, input=self.inputs, clock_ms=self.inputs * 10.5, **fields)
        return self.inputs

    def scene(self, scene, replace=False):
        return self.send_input("scene", scene=scene, replace=replace)

    def viewport(self, width_px, height_px, view=0):
        return self.send_input("viewport", view=view, width_px=width_px, height_px=height_px)

    def receive(self, timeout_s=GENEROUS_S):
        """The next message as a dict or Picture, a frame acknowledged; None when none comes in time."""
        received = self.socket.receive(timeout_s)
        if received is None:
            return None
        kind, payload = received
        if kind == WebSocket.TEXT:
            message = json.loads(payload)
            self.texts.append(message)
            return message
        picture = Picture.parse(payload)
        (self.frames if picture.type == 1 else self.stills).append(picture)
        if picture.type == 1 and self.acknowledging:
            self.send(type="ack", view=picture.view, frame=picture.number)
        return picture

    def until(self, wanted, what):
        """Receives on until a message fits."""
        deadline = time.monotonic() + GENEROUS_S
        while time.monotonic() < deadline:
            message = self.receive(max(0.0, deadline - time.monotonic()))
            if message is not None and wanted(message):
                return message
        raise AssertionError(f"{what} did not come")

    def text(self, type, **fields):
        def fits(message):
            return isinstance(message, dict) and all(
                message.get(name) == value for name, value in {"type": type, **fields}.items()
            )

        return self.until(fits, f"a message '{type}' {fields}")

    def frame(self, input=0, still=None, view=0):
        """A live frame of the view that shows this input or a later one."""

        def fits(message):
            return (
                isinstance(message, Picture)
                and message.type == 1
                and message.view == view
                and message.input >= input
                and (still is None or message.still == still)
            )

        return self.until(fits, f"a frame of input {input}")

    def saved(self, request):
        return self.until(
            lambda message: isinstance(message, Picture) and message.type == 2 and message.number == request,
            "the saved still",
        )

    def preview(self, request):
        return self.until(
            lambda message: isinstance(message, Picture) and message.type == 3 and message.number == request,
            "the preview",
        )

    def open(self, volume, width_px=320, height_px=240):
        self.viewport(width_px, height_px)
        opening = self.scene({"volume": volume})
        message = self.text("scene")
        return opening, message

    def rest(self):
        """Waits for the refined frame of the newest input."""
        return self.frame(self.inputs, still=True)

    def close(self):
        self.socket.close()


class Server:
    """`cutaway serve` on a free port; `process`: of subprocess.Popen."""

    def __init__(self, binary, *arguments, **process):
        self.log = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen(
            [binary, "serve", "--listen", "127.0.0.1:0", *arguments],
            **{"stdout": subprocess.PIPE, "stderr": self.log, "text": True, **process},
        )
        for line in self.process.stdout:
            found = re.fullmatch(r"Cutaway is at http://127\.0\.0\.1:(\d+)/\n", line)
            if found:
                self.port = int(found[1])
                return
        raise AssertionError(f"the server did not start:\n{self.output()}")

    def get(self, path, method="GET", headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=GENEROUS_S)
        try:
            connection.request(method, path, headers=headers or {})
            response = connection.getresponse()
            return response.status, response.headers, response.read()
        finally:
            connection.close()

    def resident_bytes(self):
        """Memory that the server holds now."""
        with open(f"/proc/{self.process.pid}/statm", encoding="ascii") as numbers:
            return int(numbers.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def await_words(self, words):
        """Returns once the log has them."""
        deadline = time.monotonic() + GENEROUS_S
        while words not in self.output():
            assert time.monotonic() < deadline, f"'{words}' was not logged:\n{self.output()}"
            time.sleep(0.01)

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        status = self.process.wait(GENEROUS_S)
        self.process.stdout.close()
        self.log.close()
        return status
