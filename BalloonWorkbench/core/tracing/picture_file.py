# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture files: what they are, how large, and their pixels."""

from __future__ import annotations

import struct
import zlib
from base64 import b64decode
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import MissingPackageError, PictureError
from BalloonWorkbench.core.files.user_file import read_user_file
from BalloonWorkbench.core.tracing.raster import opencv

#: A picture with more pixels than this is refused before it is unpacked, so that it takes less than 1 GB: a
#: JPEG, which can be unpacked at half its size; others; others of 16 bits.
MOST_PIXELS, _MOST_PLAIN, _MOST_DEEP = 100_000_000, 64_000_000, 40_000_000
_HALVED = 40_000_000  # a JPEG with more pixels is unpacked at half its size
_MOST_BYTES = 256 << 20
# Passes over a JPEG of which it gets sharper and sharper; programs write about ten.
_MOST_SCANS = 100
_ROWS = 64  # that are turned into plain colours at once
_HEAD = 1 << 22  # a JPEG may carry megabytes of previews and colour profiles before its size
_PNG = b"\x89PNG\r\n\x1a\n"
#: Name of the text in the PNG file of a painting with the shape that its decoration lies on.
SHAPE_KEY = "FilmBalloonShape"
_JPEG = b"\xff\xd8\xff"
_JPEG_FRAMES = {0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF}


def picture_size(path: Path) -> tuple[int, int]:
    """Width and height in pixels from the head of a PNG, JPEG, BMP or WebP file, without unpacking it.

    InputError where the file cannot be read, PictureError where it is none of these or too large.
    """
    head = read_user_file(path, _HEAD)
    try:
        size = _size(head)
    except (struct.error, IndexError):
        size = None
    if size is None or min(size) < 1:
        raise PictureError(f"'{path.name}' is not a picture that can be read. Save it as PNG, JPEG or BMP.")
    most = _most_pixels(head)
    if size[0] * size[1] > most:
        raise PictureError(
            f"'{path.name}' has {size[0]} x {size[1]} pixels, more than {most // 10**6} million. "
            "Make it smaller; 2000 pixels across are plenty."
        )
    return size


def _most_pixels(head: bytes) -> int:
    """Of a picture that starts like this."""
    if head.startswith(_JPEG):
        return MOST_PIXELS
    return _MOST_DEEP if head.startswith(b"\x89PNG") and head[24:25] > b"\x08" else _MOST_PLAIN


def is_picture(head: bytes) -> bool:
    """Whether a file that starts like this is a picture of a known kind."""
    return head.startswith((b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"BM")) or (
        head.startswith(b"RIFF") and head[8:12] == b"WEBP"
    )


def _size(head: bytes) -> tuple[int, int] | None:
    if not is_picture(head):
        return None
    if head.startswith(b"\x89PNG"):
        return struct.unpack(">II", head[16:24])
    if head.startswith(b"BM"):
        (kind,) = struct.unpack("<I", head[14:18])
        width, height = struct.unpack("<HH", head[18:22]) if kind == 12 else struct.unpack("<ii", head[18:26])
        return width, abs(height)
    if head.startswith(b"RIFF"):
        return _webp_size(head)
    return _jpeg_size(head)


def _webp_size(head: bytes) -> tuple[int, int] | None:
    kind = head[12:16]
    if kind == b"VP8X":
        return 1 + int.from_bytes(head[24:27], "little"), 1 + int.from_bytes(head[27:30], "little")
    if kind == b"VP8L":
        bits = int.from_bytes(head[21:25], "little")
        return 1 + (bits & 0x3FFF), 1 + (bits >> 14 & 0x3FFF)
    if kind == b"VP8 ":
        width, height = struct.unpack("<HH", head[26:30])
        return width & 0x3FFF, height & 0x3FFF
    return None


def _jpeg_size(head: bytes) -> tuple[int, int] | None:
    at = 2
    while head[at] == 0xFF:
        marker = head[at + 1]
        if marker in {0xFF, 0x01} or 0xD0 <= marker <= 0xD8:  # padding, or markers without content
            at += 1 if marker == 0xFF else 2
            continue
        if marker in _JPEG_FRAMES:
            height, width = struct.unpack(">HH", head[at + 5 : at + 9])
            return width, height
        at += 2 + int.from_bytes(head[at + 2 : at + 4], "big")
    return None


def shape_in(path: Path) -> bytes | None:
    """A painting's shape as it is without its decoration, a PNG file, from the painting's own; None without.

    It is a text of that file before its pixels, packed or plain, in Base64; of no use is one of another size.
    """
    data = path.read_bytes() if path.stat().st_size <= _MOST_BYTES else b""
    at = len(_PNG)
    while data.startswith(_PNG) and at + 8 < len(data) and data[at + 4 : at + 8] != b"IDAT":
        (length,) = struct.unpack(">I", data[at : at + 4])
        name, _, text = data[at + 8 : at + 8 + length].partition(b"\0")
        if name == SHAPE_KEY.encode():
            shape = _plain(text, is_packed=data[at + 4 : at + 8] == b"zTXt")
            return shape if shape[:4] == _PNG[:4] and shape[16:24] == data[16:24] else None
        at += 12 + length
    return None


def _plain(text: bytes, is_packed: bool) -> bytes:
    """What a text of a PNG file says in Base64; nothing where it is damaged."""
    try:
        return b64decode(zlib.decompressobj().decompress(text[1:], _MOST_BYTES) if is_packed else text)
    except (zlib.error, ValueError):
        return b""


def decode_shape(path: Path) -> NDArray[np.uint8]:
    """As `decode`, of a painting with a decoration its shape alone: where its outline comes from."""
    shape = shape_in(path)
    return decode(path) if shape is None else _unpacked(np.frombuffer(shape, np.uint8), path.name)


def decode(path: Path) -> NDArray[np.uint8]:
    """Pixels (h, w, 4) of a picture file as red, green, blue, alpha, upright; by OpenCV.

    16-bit and grey pictures come as 8-bit colours, a very large JPEG at half its size. MissingPackageError
    without OpenCV, PictureError for a file that it cannot unpack.
    """
    if path.stat().st_size > _MOST_BYTES:
        raise PictureError(f"'{path.name}' is larger than {_MOST_BYTES >> 20} MB. Save it as JPEG or PNG.")
    # Not cv2.imread: it cannot open names with letters outside the system's code page everywhere.
    return _unpacked(np.fromfile(path, dtype=np.uint8), path.name)


def _unpacked(data: NDArray[np.uint8], file_name: str) -> NDArray[np.uint8]:
    """The pixels of `decode` from the content of a file."""
    cv2 = opencv()
    if cv2 is None:
        raise MissingPackageError(
            "Pictures need OpenCV, which is missing or does not work here. Install the package "
            "python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD."
        )
    # Cameras turn a JPEG by a note in the file, which OpenCV follows only when it converts to plain colours;
    # the other kinds may have transparency, which it would lose by that.
    upright = data[:3].tobytes() == _JPEG
    mode = cv2.IMREAD_COLOR if upright else cv2.IMREAD_UNCHANGED
    if upright and _jpeg_pixels(data) > _HALVED:
        mode = cv2.IMREAD_REDUCED_COLOR_2
    if upright and data.tobytes().count(b"\xff\xda") > _MOST_SCANS:
        raise PictureError(f"'{file_name}' is damaged. Save it as PNG, JPEG or BMP once more.")
    try:
        pixels = cv2.imdecode(data, mode)
    except (cv2.error, MemoryError):
        pixels = None
    if pixels is None or pixels.dtype not in (np.uint8, np.uint16):
        raise PictureError(
            f"'{file_name}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more."
        )
    return _rgba(pixels if pixels.ndim == 3 else pixels[..., None])


def _jpeg_pixels(data: NDArray[np.uint8]) -> int:
    """As its head says; 0 where it says nothing."""
    try:
        width, height = _jpeg_size(data[:_HEAD].tobytes()) or (0, 0)
    except (struct.error, IndexError):
        return 0
    return width * height


def _rgba(pixels: NDArray[np.uint8] | NDArray[np.uint16]) -> NDArray[np.uint8]:
    """Pixels (h, w, 4) of 8 bits from grey, grey and alpha, or blue, green, red and perhaps alpha (h, w, k).

    Some rows at a time: a photograph of 16 bits takes hundreds of megabytes already.
    """
    height, width, channels = pixels.shape
    rgba = np.full((height, width, 4), 255, dtype=np.uint8)
    for top in range(0, height, _ROWS):
        rows = pixels[top : top + _ROWS]
        if rows.dtype == np.uint16:
            rows = np.rint(rows / 257.0).astype(np.uint8)
        part = rgba[top : top + _ROWS]
        part[..., :3] = rows[..., 2::-1] if channels > 2 else rows[..., :1]
        if channels in (2, 4):
            part[..., 3] = rows[..., -1]
    return rgba
