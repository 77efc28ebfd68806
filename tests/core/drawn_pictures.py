# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures drawn from formulas, with soft or hard edges, and files of them written without any library."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.tracing.picture import drawing_of

EXAMPLES = sorted(Path("resources/examples/pictures").glob("*.png"))


def drawn(inside, width, height, fine=8):
    """Part of each pixel (height, width) where inside(x, y) holds; y up, fine x fine samples a pixel."""
    x, y = np.meshgrid(
        (np.arange(width * fine) + 0.5) / fine, height - (np.arange(height * fine) + 0.5) / fine
    )
    return inside(x, y).reshape(height, fine, width, fine).mean(axis=(1, 3))


def coloured(part, shape=(30, 60, 200), background=(255, 255, 255)):
    """Pixels (h, w, 4) of a shape on a plain background."""
    colours = part[..., None] * np.array(shape) + (1 - part[..., None]) * np.array(background)
    return np.dstack([np.rint(colours), np.full(part.shape, 255)]).astype(np.uint8)


def disc(x0, y0, radius):
    return lambda x, y: (x - x0) ** 2 + (y - y0) ** 2 < radius**2


def ring(x0, y0, radius, inner):
    return lambda x, y: disc(x0, y0, radius)(x, y) & ~disc(x0, y0, inner)(x, y)


def box(left, low, right, high):
    return lambda x, y: (left < x) & (x < right) & (low < y) & (y < high)


def stroke(x0, y0, x1, y1, width):
    """A straight pen stroke with round ends."""

    def inside(x, y):
        dx, dy = x1 - x0, y1 - y0
        t = np.clip(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0, 1)
        return np.hypot(x - x0 - t * dx, y - y0 - t * dy) < width / 2

    return inside


def arc(x0, y0, radius, start, stop, width):
    """A circular pen stroke from angle to angle, in degrees."""

    def inside(x, y):
        angle = np.degrees(np.arctan2(y - y0, x - x0)) % 360
        return (np.abs(np.hypot(x - x0, y - y0) - radius) < width / 2) & (start <= angle) & (angle <= stop)

    return inside


def any_of(*shapes):
    return lambda x, y: np.logical_or.reduce([shape(x, y) for shape in shapes])


def png(pixels):
    """Bytes of a PNG file of pixels (h, w), (h, w, 2), (h, w, 3) or (h, w, 4) with 8 or 16 bits."""
    pixels = pixels[..., None] if pixels.ndim == 2 else pixels
    height, width, channels = pixels.shape
    depth = 8 * pixels.dtype.itemsize
    rows = pixels.astype(f">u{depth // 8}").reshape(height, -1)
    lines = b"".join(b"\0" + row.tobytes() for row in rows)
    return png_with(width, height, depth, {1: 0, 2: 4, 3: 2, 4: 6}[channels], zlib.compress(lines))


def png_with(width, height, depth, colour_type, content):
    """Bytes of a PNG file with this head and this packed content."""
    head = struct.pack(">IIBBBBB", width, height, depth, colour_type, 0, 0, 0)
    parts = [(b"IHDR", head), (b"IDAT", content), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in parts
    )


def turned_jpeg(data, orientation):
    """Bytes of a JPEG file with the camera's note on which side is up."""
    entry = struct.pack("<HHIHH", 0x0112, 3, 1, orientation, 0)
    exif = b"Exif\0\0" + b"II*\0" + struct.pack("<IH", 8, 1) + entry + struct.pack("<I", 0)
    return data[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + data[2:]


def outline_of(rgba):
    """The largest shape in pixels (h, w, 4)."""
    return drawing_of(rgba).largest
