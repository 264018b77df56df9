"""A newcomer's first minute, from outside: a picture of a phantom, then one of a stack of TIFF slices.

Usage: newcomer.py stack DIR     writes the slices
       newcomer.py visit PORT    sees both on the server there, whose data folder has that stack and nothing else
"""

import math
import pathlib
import struct
import sys

from png import png_pixels
from wire import Client, jpeg_size

SIDE = 48  # voxels
WIDTH_PX, HEIGHT_PX = 320, 240
FEWEST_COLOURS = 100  # a shaded ball has thousands, an empty picture one or two


def tiff(rows):
    """A little-endian TIFF of one strip of 8-bit grey."""
    pixels = b"".join(rows)
    tags = (
        (256, len(rows[0])), (257, len(rows)), (258, 8), (259, 1), (262, 1), (273, 8), (277, 1), (278, len(rows)),
        (279, len(pixels)),
    )  # fmt: skip
    directory = struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags)
    return struct.pack("<2sHI", b"II", 42, 8 + len(pixels)) + pixels + directory + bytes(4)


def ball_row(y, z):
    middle = (SIDE - 1) / 2
    return bytes(round(255 * max(0, 1 - math.dist((x, y, z), (middle,) * 3) / middle)) for x in range(SIDE))


def write_stack(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for z in range(SIDE):
        (folder / f"slice_{z:03}.tif").write_bytes(tiff([ball_row(y, z) for y in range(SIDE)]))


def see(client, volume, request):
    """A live frame of the volume, and what a still of it shows."""
    client.open(volume, WIDTH_PX, HEIGHT_PX)
    frame = client.rest()
    assert jpeg_size(frame.data) == (frame.width_px, frame.height_px), "a frame of another size than announced"
    client.send(type="save_still", request=request, width_px=WIDTH_PX, height_px=HEIGHT_PX)
    colours = len(set(png_pixels(client.saved(request).data)))
    assert colours >= FEWEST_COLOURS, f"{volume}: {colours} colours, expected {FEWEST_COLOURS} or more"
    print(f"seen: {volume}, {len(frame.data)} bytes of JPEG, {colours} colours", flush=True)


def finished_listing(client):
    """The list of volumes once all folders were looked through; it may have come already."""

    def fits(message):
        return isinstance(message, dict) and message["type"] == "volumes" and not message["scanning"]

    return next(filter(fits, client.texts), None) or client.until(fits, "the list of volumes")


def visit(port):
    client = Client(port)
    see(client, "phantom:head", 1)
    listing = finished_listing(client)
    (stack,) = [volume for volume in listing["volumes"] if volume["format"] == "image stack"]
    assert stack["size_voxels"] == [SIDE] * 3, stack
    see(client, stack["id"], 2)
    client.close()


if __name__ == "__main__":
    command, argument = sys.argv[1:]
    if command == "stack":
        write_stack(pathlib.Path(argument))
    else:
        visit(int(argument))
