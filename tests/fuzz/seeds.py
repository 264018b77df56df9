"""Writes the corpora with which the targets begin: the protocol's fixtures, and small files made here.

usage: seeds.py FIXTURES_DIR CORPORA_DIR
"""

import json
import pathlib
import shutil
import struct
import sys
import zlib

SIZE = (4, 3, 2)  # voxels
VOXELS = bytes(range(SIZE[0] * SIZE[1] * SIZE[2]))


def nifti():
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 2, 8)  # uint8
    struct.pack_into("<8f", header, 76, 1, 1.5, 2, 2.5, 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    header[123] = 2  # mm
    struct.pack_into("<hh", header, 252, 0, 1)
    struct.pack_into("<12f", header, 280, 1.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2.5, 0)
    header[344:348] = b"n+1\0"
    return {"sform.nii": bytes(header) + VOXELS}


def nrrd():
    head = (
        "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 3 2\n"
        "space directions: (1.5,0,0) (0,2,0) (0,0,2.5)\nspace origin: (0,0,0)\n"
    )
    spaced = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 3 2\nspacings: 1 2 3\nencoding: ascii\n\n"
    return {
        "raw.nrrd": head.encode() + b"encoding: raw\n\n" + VOXELS,
        "gzip.nrrd": head.encode() + b"encoding: gzip\n\n" + zlib.compress(VOXELS, wbits=31),
        "ascii.nrrd": spaced.encode() + " ".join(map(str, VOXELS)).encode(),
    }


def metaimage():
    head = (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
        "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\nElementSpacing = 1.5 2 2.5\nDimSize = 4 3 2\n"
        "ElementType = MET_UCHAR\n"
    )
    packed = zlib.compress(VOXELS)
    return {
        "raw.mha": head.encode() + b"ElementDataFile = LOCAL\n" + VOXELS,
        "zlib.mha": head.encode()
        + f"CompressedData = True\nCompressedDataSize = {len(packed)}\nElementDataFile = LOCAL\n".encode()
        + packed,
    }


def tiff_page(at, next_page):
    """The directory of a grey page of 4x3 whose pixels lie at byte 8."""
    tags = ((256, 4), (257, 3), (258, 8), (259, 1), (262, 1), (273, 8), (277, 1), (278, 3), (279, 12))
    entries = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags)
    page = struct.pack("<H", len(tags)) + entries
    return page + struct.pack("<I", at + len(page) + 4 if next_page else 0)


def tiff():
    pixels = VOXELS[:12]
    first = struct.pack("<2sHI", b"II", 42, 20) + pixels
    page = tiff_page(20, True)
    return {"pages.tif": first + page + tiff_page(20 + len(page), False)}


def element(group, number, kind, value):
    value += b" " * (len(value) % 2)
    if kind in (b"OB", b"OW", b"SQ"):
        return struct.pack("<HH2sHI", group, number, kind, 0, len(value)) + value
    return struct.pack("<HH2sH", group, number, kind, len(value)) + value


def dicom():
    item = struct.pack("<HHI", 0xFFFE, 0xE000, 8 + 2) + element(0x0008, 0x1150, b"UI", b"1\0")
    meta = element(0x0002, 0x0010, b"UI", b"1.2.840.10008.1.2.1\0")
    meta = element(0x0002, 0x0000, b"UL", struct.pack("<I", len(meta))) + meta
    body = (
        element(0x0008, 0x0060, b"CS", b"CT")
        + element(0x0008, 0x1140, b"SQ", item)
        + element(0x0020, 0x0032, b"DS", b"0\\0\\2.5")
        + element(0x0028, 0x0010, b"US", struct.pack("<H", 3))
        + element(0x0028, 0x0011, b"US", struct.pack("<H", 4))
        + element(0x7FE0, 0x0010, b"OB", VOXELS[:12])
    )
    return {"slice.dcm": bytes(128) + b"DICM" + meta + body}


def sidecar():
    full = {
        "title": "seed", "modality": "CT", "units": "HU", "spacing_mm": [1, 2, 3], "origin_lps_mm": [0, 0, 0],
        "direction_lps": [1, 0, 0, 0, 1, 0, 0, 0, 1], "rescale": {"slope": 1, "intercept": -1024},
    }  # fmt: skip
    return {"full.json": json.dumps(full).encode(), "spacing.json": b'{"spacing_mm": [1, 1, 1]}'}


def frame(first, payload):
    """As a client sends it; the mask is 0."""
    length = len(payload)
    size = struct.pack(">B", 0x80 | length) if length < 126 else struct.pack(">BH", 0x80 | 126, length)
    return bytes([first]) + size + bytes(4) + payload


def frames():
    size = {"type": "viewport", "input": 1, "clock_ms": 1, "width_px": 64, "height_px": 48}
    scene = {"type": "scene", "input": 2, "clock_ms": 2, "scene": {"volume": "ball"}}
    goodbye = frame(0x88, struct.pack(">H", 1000))
    return {
        "session": frame(0x81, b"{}\n") + goodbye,
        "pieces": frame(0x01, b'{"type"') + frame(0x89, b"ping") + frame(0x80, b":0}") + frame(0x82, b"\x01") + goodbye,
        "ball": frame(0x81, json.dumps(size).encode()) + frame(0x81, json.dumps(scene).encode()) + frame(0x8A, b""),
    }


def http():
    upgrade = (
        "GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: cutaway.v1\r\n\r\n"
    )
    return {
        "get": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        "head": b"HEAD /readyz HTTP/1.1\r\nHost: localhost:1\r\nConnection: close\r\n\r\n",
        "volumes": b"GET /api/volumes HTTP/1.1\r\nHost: 127.0.0.1\r\nAccept-Encoding: gzip\r\n\r\n",
        "post": b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 4\r\n\r\nbody",
        "chunks": b"PUT / HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\n2;a=b\r\nok\r\n0\r\nT: u\r\n\r\n",
        "upgrade": upgrade.encode(),
    } | {name: upgrade.encode() + said for name, said in frames().items()}


MADE = {"nifti": nifti, "nrrd": nrrd, "metaimage": metaimage, "tiff": tiff, "dicom": dicom, "sidecar": sidecar,
        "http": http}  # fmt: skip


def main(fixtures, corpora):
    for name, make in MADE.items():
        (corpora / name).mkdir(parents=True, exist_ok=True)
        for file, content in make().items():
            (corpora / name / file).write_bytes(content)
    (corpora / "message").mkdir(parents=True, exist_ok=True)
    for path in (fixtures / "valid").glob("client-message-*.json"):
        shutil.copy(path, corpora / "message")


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
