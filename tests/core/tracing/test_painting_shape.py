# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file of a painting with a decoration: its outline is that of the shape that it carries along."""

import struct
import zlib
from base64 import b64encode
from pathlib import Path

import cv2
import numpy as np
import pytest

from BalloonWorkbench.core.artwork.picture import of_drawing
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.tracing.picture_file import SHAPE_KEY, decode, decode_shape, shape_in

SIDE = 300


def ring(fill: bool) -> np.ndarray:
    """A closed line of a pen, inside bare or painted in stripes."""
    rgba = np.zeros((SIDE, SIDE, 4), np.uint8)
    cv2.circle(rgba, (150, 150), 100, (0, 0, 200, 255), 6, cv2.LINE_AA)
    if fill:
        cv2.circle(rgba, (150, 150), 60, (0, 200, 0, 255), 50, cv2.LINE_AA)
    return rgba


def png(rgba: np.ndarray) -> bytes:
    return cv2.imencode(".png", rgba)[1].tobytes()


def with_text(picture: bytes, kind: bytes, text: bytes) -> bytes:
    """A PNG file with one more text in front of its pixels."""
    body = kind + SHAPE_KEY.encode() + b"\0" + text
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    at = picture.index(b"IDAT") - 4
    return picture[:at] + chunk + picture[at:]


@pytest.mark.parametrize("packed", [False, True])
def test_the_outline_is_that_of_the_shape(tmp_path: Path, packed: bool) -> None:
    text = b64encode(png(ring(fill=False)))
    kind, content = (b"zTXt", b"\0" + zlib.compress(text)) if packed else (b"tEXt", text)
    plain, decorated = tmp_path / "plain.png", tmp_path / "decorated.png"
    plain.write_bytes(png(ring(fill=False)))
    decorated.write_bytes(with_text(png(ring(fill=True)), kind, content))
    expected, _ = read_drawing(plain, width=0.3)
    drawing, _ = read_drawing(decorated, width=0.3)
    for loop, other in zip(drawing.largest.loops, expected.largest.loops, strict=True):
        np.testing.assert_array_equal(loop, other)
    np.testing.assert_array_equal(decode_shape(decorated), decode(plain))
    assert (decode(decorated) != decode(plain)).any()
    shape, seen = decode_shape(decorated), decode(decorated)
    low, size = np.zeros(2), np.array(drawing.size)
    both = of_drawing(seen, low, size, shape=shape)
    np.testing.assert_allclose(both.low, of_drawing(shape, low, size).low)
    assert both.pixels[90, 150].tolist() == [0, 200, 0, 255]


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (b"tEXt", b"%%%"),
        (b"tEXt", b64encode(b"no picture")),
        (b"tEXt", b64encode(png(np.zeros((40, 40, 4), np.uint8)))),
        (b"zTXt", b"\0nothing packed"),
        (b"zTXt", b""),
    ],
)
def test_a_shape_of_no_use_is_left_out(tmp_path: Path, kind: bytes, text: bytes) -> None:
    path = tmp_path / "painting.png"
    path.write_bytes(with_text(png(ring(fill=True)), kind, text))
    assert shape_in(path) is None
    np.testing.assert_array_equal(decode_shape(path), decode(path))


def test_files_that_end_too_early(tmp_path: Path) -> None:
    path, content = (
        tmp_path / "cut.png",
        with_text(png(ring(fill=True)), b"tEXt", b64encode(png(ring(False)))),
    )
    for length in (0, 7, 8, 11, 20, 40, 60, 200, 1000):
        path.write_bytes(content[:length])
        assert shape_in(path) is None or length == 1000
