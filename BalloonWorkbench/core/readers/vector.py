# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings from SVG, DXF and JSON files, at their own size."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.user_file import read_whole
from BalloonWorkbench.core.geometry.crossings import contains
from BalloonWorkbench.core.geometry.polyline import oriented, signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing, checked
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check, scale_to
from BalloonWorkbench.core.readers.chains import SAME_END, drawing_from, join
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
    else:
        lines, filled, welds, notes = _lines(path, kind, data, budget)
        drawing = drawing_from(lines, notes, filled, welds, budget=budget)
    drawing = checked(drawing, budget)
    scaled = scale_to(drawing, width, height)
    return drawing if scaled is drawing else checked(scaled, budget)


def read_outermost(path: str | Path) -> list[Outline]:
    """The closed lines of a drawing that lie in no other one, the largest first, at its own size: of a
    pattern that is to be cut, the outer cuts.

    Errors: InputError (file, no closed line), OutlineError (crossing), MissingPackageError.
    """
    path, budget = Path(path), Budget()
    data = read_bytes(path)
    kind = vector_kind(path, data[:4096])
    if kind == "json":
        return [Outline(part.outer) for part in read_vector(path).parts]
    loops = [
        loop for lines in _by_layer(path, kind, data, budget) for loop in join(lines, SAME_END, budget)[0]
    ]
    loops.sort(key=lambda loop: -abs(signed_area(loop)))
    outer: list[Floats] = []
    for loop in loops:
        budget.check_time()
        if not any(contains(other, loop[:1]).all() for other in outer):
            outer.append(loop)
    if not outer:
        raise InputError(f"'{path.name}' has no closed line: give the pattern as it was cut.")
    return [check(Outline(oriented(loop)), budget) for loop in outer]


def _by_layer(path: Path, kind: str | None, data: bytes, budget: Budget) -> list[list[Floats]]:
    """The lines of an SVG or DXF file that may meet: a notch ends on a cut, but on another layer of a DXF
    file, and in an SVG a cut is one line that is closed.
    """
    if kind != "dxf":
        lines, *_ = _lines(path, kind, data, budget)
        closed = [line for line in lines if np.array_equal(line[0], line[-1])]
        return [closed, [line for line in lines if not np.array_equal(line[0], line[-1])]]
    from BalloonWorkbench.core.readers.dxf import dxf_lines

    layers: dict[str, list[Floats]] = {}
    for layer, line in dxf_lines(data, FLATNESS, budget)[0]:
        layers.setdefault(layer, []).append(line)
    _check_places([line for lines in layers.values() for line in lines])
    return list(layers.values())


def _lines(
    path: Path, kind: str | None, data: bytes, budget: Budget
) -> tuple[list[Floats], list[Floats], list[Floats], list[str]]:
    """The lines (n, 2) m of an SVG or DXF file, those that are filled though open, welds, and remarks."""
    filled: list[Floats] = []
    notes: list[str] = []
    if kind == "svg":
        from BalloonWorkbench.core.readers.svg import read_svg

        lines, filled, welds = read_svg(data, FLATNESS, budget)
    elif kind == "dxf":
        from BalloonWorkbench.core.readers.dxf import read_dxf

        lines, welds, notes = read_dxf(data, FLATNESS, budget)
    else:
        raise InputError(f"'{path.name}' is neither SVG, DXF nor JSON. Save the drawing as one of these.")
    _check_places([*lines, *welds])
    return lines, filled, welds, notes


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
