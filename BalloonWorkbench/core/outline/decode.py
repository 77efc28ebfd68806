# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture files: what they are, how large, and their pixels."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError, MissingPackageError, PictureError
from BalloonWorkbench.core.outline.raster import opencv

#: A picture with more pixels than this is refused before it is unpacked.
MOST_PIXELS = 100_000_000
_HEAD = 1 << 22  # a JPEG may carry megabytes of previews and colour profiles before its size
_JPEG_FRAMES = {0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF}


def picture_size(path: Path) -> tuple[int, int]:
    """Width and height in pixels from the head of a PNG, JPEG, BMP or WebP file, without unpacking it.

    InputError where the file cannot be read, PictureError where it is none of these or too large.
    """
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD)
    except FileNotFoundError:
        raise InputError(f"There is no file '{path}'. Check the name and the folder.") from None
    except OSError as error:
        raise InputError(
            f"'{path}' cannot be read ({error.strerror}). Check the name and its access."
        ) from None
    try:
        size = _size(head)
    except (struct.error, IndexError):
        size = None
    if size is None or min(size) < 1:
        raise PictureError(f"'{path.name}' is not a picture that can be read. Save it as PNG, JPEG or BMP.")
    if size[0] * size[1] > MOST_PIXELS:
        raise PictureError(
            f"'{path.name}' has {size[0]} x {size[1]} pixels, more than {MOST_PIXELS // 10**6} million. "
            "Make it smaller; 2000 pixels across are plenty."
        )
    return size


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


def decode(path: Path) -> NDArray[np.uint8]:
    """Pixels (h, w, 4) of a picture file as red, green, blue, alpha, upright; by OpenCV.

    16-bit and grey pictures come as 8-bit colours. MissingPackageError without OpenCV, PictureError for a
    file that it cannot unpack.
    """
    cv2 = opencv()
    if cv2 is None:
        raise MissingPackageError(
            "Pictures need OpenCV, which is missing or does not work here. Install the package "
            "python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD."
        )
    # Not cv2.imread: it cannot open names with letters outside the system's code page everywhere.
    data = np.fromfile(path, dtype=np.uint8)
    # Cameras turn a JPEG by a note in the file, which OpenCV follows only when it converts to plain colours;
    # the other kinds may have transparency, which it would lose by that.
    upright = data[:3].tobytes() == b"\xff\xd8\xff"
    try:
        pixels = cv2.imdecode(data, cv2.IMREAD_COLOR if upright else cv2.IMREAD_UNCHANGED)
    except cv2.error:
        pixels = None
    if pixels is None or pixels.dtype not in (np.uint8, np.uint16):
        raise PictureError(
            f"'{path.name}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more."
        )
    if pixels.dtype == np.uint16:
        pixels = np.rint(pixels / 257.0).astype(np.uint8)
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    if pixels.shape[2] < 3:
        grey, alpha = pixels[..., :1], pixels[..., 1:]
        pixels = np.concatenate([grey, grey, grey, alpha], axis=2)
    if pixels.shape[2] == 3:
        pixels = np.dstack([pixels, np.full(pixels.shape[:2], 255, np.uint8)])
    return np.ascontiguousarray(pixels[..., [2, 1, 0, 3]])
