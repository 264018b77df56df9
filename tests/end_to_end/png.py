"""The pixels of a PNG of 8-bit RGB without interlacing, as the server makes them; no library."""

import struct
import zlib

BYTES_A_PIXEL = 3


def png_pixels(data):
    """Every pixel as three bytes, row by row from the top."""
    width, height = struct.unpack_from("!II", data, 16)
    assert data[24:26] == b"\x08\x02" and data[28] == 0, "8-bit RGB, not interlaced"
    stream = zlib.decompress(b"".join(content for name, content in _chunks(data) if name == b"IDAT"))
    row_bytes = width * BYTES_A_PIXEL
    above = bytes(row_bytes)
    pixels = []
    for start in range(0, height * (row_bytes + 1), row_bytes + 1):
        above = _unfiltered(stream[start], stream[start + 1 : start + 1 + row_bytes], above)
        pixels += [above[i : i + BYTES_A_PIXEL] for i in range(0, row_bytes, BYTES_A_PIXEL)]
    return pixels


def _chunks(data):
    at = 8
    while at < len(data):
        (length,) = struct.unpack_from("!I", data, at)
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        at += 12 + length


def _unfiltered(kind, line, above):
    row = bytearray(BYTES_A_PIXEL) + line
    corner = bytes(BYTES_A_PIXEL) + above
    for i, up in enumerate(above):
        left, up_left = row[i], corner[i]
        predicted = (0, left, up, (left + up) // 2, _paeth(left, up, up_left))[kind]
        row[i + BYTES_A_PIXEL] = (row[i + BYTES_A_PIXEL] + predicted) & 0xFF
    return bytes(row[BYTES_A_PIXEL:])


def _paeth(left, up, up_left):
    estimate = left + up - up_left
    return min((left, up, up_left), key=lambda neighbour: abs(estimate - neighbour))
