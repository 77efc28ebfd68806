# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings from SVG, DXF and JSON files, at their own size."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.user_file import read_whole
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing, checked
from BalloonWorkbench.core.outline.validity import scale_to
from BalloonWorkbench.core.readers.chains import drawing_from
from BalloonWorkbench.core.readers.json_points import read_points
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, number_text

#: Largest distance between a curve of the file and the outline [m].
FLATNESS = from_mm(0.02)
_MOST_BYTES = 64 << 20
_FARTHEST = 1e6  # m


def read_vector(
    path: str | Path, width: float | None = None, height: float | None = None, budget: Budget | None = None
) -> Drawing:
    """The closed lines of a drawing, those inside others as their holes; checked.

    At its own size, or scaled to `width` or `height` [m]; inside both where both are given.
    Errors: InputError (file, size), OutlineError (open, crossing, empty), MissingPackageError.
    """
    path = Path(path)
    budget = budget or Budget()
    data = read_bytes(path)
    kind = vector_kind(path, data[:4096])
    if kind == "json":
        drawing = read_points(data, budget)
        _check_places([line for part in drawing.parts for line in (*part.loops, *part.welds)])
    elif kind == "svg":
        from BalloonWorkbench.core.readers.svg import read_svg

        lines, filled, welds = read_svg(data, FLATNESS, budget)
        _check_places([*lines, *welds])
        drawing = drawing_from(lines, (), filled, welds, budget=budget)
    elif kind == "dxf":
        from BalloonWorkbench.core.readers.dxf import read_dxf

        lines, welds, notes = read_dxf(data, FLATNESS, budget)
        _check_places([*lines, *welds])
        drawing = drawing_from(lines, notes, (), welds, budget=budget)
    else:
        raise InputError(f"'{path.name}' is neither SVG, DXF nor JSON. Save the drawing as one of these.")
    drawing = checked(drawing, budget)
    scaled = scale_to(drawing, width, height)
    return drawing if scaled is drawing else checked(scaled, budget)


def _check_places(lines: Sequence[Floats]) -> None:
    """InputError for points so far away that nothing can be told about millimetres there."""
    for line in lines:
        if not (np.abs(line) <= _FARTHEST).all():
            raise InputError(
                f"The drawing has points more than {number_text(1e-3 * _FARTHEST)} km from its origin. "
                "Move it there, and give it a size between 1 mm and 100 m."
            )


def vector_kind(path: Path, head: bytes) -> str | None:
    """'svg', 'dxf' or 'json' by how the file starts, else by its name; None for any other."""
    text = head.lstrip(b"\xef\xbb\xbf").lstrip()
    if text.startswith(b"{"):
        return "json"
    if text.startswith(b"<"):
        return "svg"
    if head.startswith(b"AutoCAD Binary DXF") or (text[:1] == b"0" and b"SECTION" in text[:64]):
        return "dxf"
    suffix = path.suffix.lower().lstrip(".")
    return suffix if suffix in {"svg", "dxf", "json"} else None


def read_bytes(path: Path) -> bytes:
    """The content of a drawing; InputError where it cannot be read, is empty or too large."""
    return read_whole(path, _MOST_BYTES)
