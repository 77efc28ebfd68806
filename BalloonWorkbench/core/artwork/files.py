# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork as files: PNG that knows its resolution, PDF in real size."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from BalloonWorkbench.core.artwork.picture import Pixels
from BalloonWorkbench.core.artwork.sheet import Sheet
from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.pages.fonts import fonts_for
from BalloonWorkbench.core.pages.pdf import POINT, draw_line, pdf, picture
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import INCH, to_mm

_LINE = 0.25  # mm


def artwork_files(front: Sheet, back: Sheet) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Contents of the files of both sides by name, and why one was left out: a package that is missing."""
    return sheet_files({"artwork-front": front, "artwork-back": back})


def sheet_files(sheets: Mapping[str, Sheet]) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """The same of any sheets, by the names of their pictures."""
    files = {f"{name}.png": png_bytes(sheet.pixels, sheet.dpi) for name, sheet in sheets.items()}
    try:
        return files | {"artwork.pdf": artwork_pdf(tuple(sheets.values()))}, ()
    except MissingPackageError as error:
        return files, (f"artwork.pdf was left out. {error}",)


def png_bytes(pixels: Pixels, dpi: float) -> bytes:
    """Pixels (h, w, 4) as PNG with the resolution in its header (chunk pHYs: pixels per metre)."""
    height, width = pixels.shape[:2]
    lines = pixels.reshape(height, 4 * width)
    above = np.concatenate([np.zeros((1, 4 * width), dtype=np.uint8), lines[:-1]])
    # filter "up": the difference to the line above, which is mostly nothing
    filtered = np.empty((height, 4 * width + 1), dtype=np.uint8)
    filtered[:, 0] = 2
    filtered[:, 1:] = lines - above
    metre = round(dpi / INCH)
    return b"".join(
        (
            b"\x89PNG\r\n\x1a\n",
            _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)),
            _chunk(b"sRGB", b"\0"),
            _chunk(b"pHYs", struct.pack(">IIB", metre, metre, 1)),
            _chunk(b"IDAT", zlib.compress(filtered.tobytes(), 6)),
            _chunk(b"IEND", b""),
        )
    )


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def artwork_pdf(sheets: Sequence[Sheet]) -> bytes:
    """A page in real size for each sheet: the picture, and the marks as lines.

    The same bytes for the same sheets. MissingPackageError without matplotlib.
    """
    title = "Balloon artwork"
    return pdf(title, fonts_for(title, ""), [(_size(sheet), partial(_draw, sheet)) for sheet in sheets])


def _size(sheet: Sheet) -> tuple[float, float]:
    """Width and height [mm]."""
    width, height = sheet.size
    return to_mm(width), to_mm(height)


def _draw(sheet: Sheet, axes: Any) -> None:
    picture(axes, sheet.pixels, (0.0, 0.0, *_size(sheet)))
    for contour in sheet.pattern.of(Role.REGISTRATION):
        draw_line(axes, to_mm(contour.points - sheet.origin), contour.closed, lw=_LINE / POINT)
