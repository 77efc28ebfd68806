# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's Qt reads the pixels that the engine needs, without a window."""

import struct
import zlib
from pathlib import Path

import numpy as np
import pytest

from BalloonWorkbench.app.drawings.qt_picture import decode
from BalloonWorkbench.core.errors import PictureError

PICTURES = sorted(Path("resources/examples/pictures").glob("*.png"))


def png(pixels):
    """Bytes of a PNG file of 8-bit pixels (h, w, 4)."""
    height, width, _ = pixels.shape
    lines = b"".join(b"\0" + row.tobytes() for row in pixels)
    parts = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)),
        (b"IDAT", zlib.compress(lines)),
        (b"IEND", b""),
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in parts
    )


@pytest.mark.parametrize("width", [1, 3, 64, 101])
def test_pixels_come_as_they_are(width, tmp_path):
    pixels = np.random.default_rng(width).integers(0, 256, (7, width, 4)).astype(np.uint8)
    pixels[..., 3] |= 1  # a clear pixel has no colour to keep
    path = tmp_path / "Käfer 图.txt"
    path.write_bytes(png(pixels))
    assert np.array_equal(decode(path), pixels)


@pytest.mark.parametrize("path", PICTURES, ids=lambda path: path.stem)
def test_the_examples_are_the_same_as_through_opencv(path):
    pytest.importorskip("cv2")
    from BalloonWorkbench.core.tracing.picture_file import decode as decode_with_opencv

    expected, found = decode_with_opencv(path), decode(path)
    seen = expected[..., 3] > 0
    assert np.array_equal(found[seen], expected[seen])
    assert np.array_equal(found[..., 3], expected[..., 3])


@pytest.mark.parametrize(("orientation", "corner"), [(1, (0, 0)), (3, (-1, -1)), (6, (0, -1)), (8, (-1, 0))])
def test_a_camera_picture_is_upright(orientation, corner, tmp_path):
    cv2 = pytest.importorskip("cv2")
    pixels = np.full((60, 80, 3), 255, np.uint8)
    pixels[:30, :40] = (200, 60, 20)
    data = cv2.imencode(".jpg", pixels)[1].tobytes()
    entry = struct.pack("<HHIHH", 0x0112, 3, 1, orientation, 0)
    exif = b"Exif\0\0II*\0" + struct.pack("<IH", 8, 1) + entry + struct.pack("<I", 0)
    path = tmp_path / "photo.jpg"
    path.write_bytes(data[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + data[2:])
    found = decode(path)
    assert found.shape[:2] == ((60, 80) if orientation in {1, 3} else (80, 60))
    assert found[corner][0] < 100 < found[corner][2]


def test_what_is_no_picture_is_refused(tmp_path):
    path = tmp_path / "letter.png"
    path.write_bytes(b"Dear grandmother")
    with pytest.raises(PictureError, match=r"letter\.png"):
        decode(path)
