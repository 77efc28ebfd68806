# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork as files: PNG that knows its resolution, PDF in real size."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from BalloonWorkbench.core.artwork.picture import Pixels
from BalloonWorkbench.core.artwork.sheet import Sheet
from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.marks.style import CROSSES
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.machines.writers.pdf import show
from BalloonWorkbench.core.pages.fonts import fonts_for
from BalloonWorkbench.core.pages.pdf import POINT, draw_area, draw_line, pdf, picture
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import INCH, to_mm


def artwork_files(
    front: Sheet, back: Sheet, machines: Sequence[Machine] = ()
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Contents of the files of both sides by name, and why one was left out: a package that is missing.

    machines  those of a print shop that know the cut by a spot colour get a PDF with both
    """
    return sheet_files({"artwork-front": front, "artwork-back": back}, machines)


def sheet_files(
    sheets: Mapping[str, Sheet], machines: Sequence[Machine] = ()
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """The same of any sheets, by the names of their pictures."""
    files = {f"{name}.png": png_bytes(sheet.pixels, sheet.dpi) for name, sheet in sheets.items()}
    sides = tuple(sheets.values())
    shops = {f"artwork-{each.name}.pdf": each for each in machines if each.spots}
    try:
        made = {name: artwork_pdf(sides, shop) for name, shop in shops.items()}
        return files | {"artwork.pdf": artwork_pdf(sides)} | made, ()
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


def artwork_pdf(sheets: Sequence[Sheet], shop: Machine | None = None) -> bytes:
    """A page in real size for each sheet: the picture, the marks as lines, and the cut of a print shop.

    The same bytes for the same sheets. MissingPackageError without matplotlib.
    """
    title = "Balloon artwork"
    pages = [(_page_size(sheet), partial(_draw, sheet, shop)) for sheet in sheets]
    return pdf(title, fonts_for(title, ""), pages, () if shop is None else shop.spots)


def _page_size(sheet: Sheet) -> tuple[float, float]:
    """Width and height [mm] of the paper where there is one, else of the picture."""
    page = sheet.pattern.page
    width, height = sheet.size if page is None else page[1] - page[0]
    return float(to_mm(width)), float(to_mm(height))


def _draw(sheet: Sheet, shop: Machine | None, axes: Any) -> None:
    width, height = sheet.size
    picture(axes, sheet.pixels, (0.0, 0.0, to_mm(width), to_mm(height)))
    for contour in sheet.pattern.of(Role.REGISTRATION):
        points = to_mm(contour.points - sheet.origin)
        if contour.filled:
            draw_area(axes, points)
        else:
            draw_line(axes, points, contour.closed, lw=to_mm(CROSSES.line) / POINT)
    if shop is not None:
        paper = sheet.pattern.page or (sheet.origin, sheet.origin + sheet.size)
        show(axes, draw(replace(sheet.pattern, page=paper), shop), shop)
