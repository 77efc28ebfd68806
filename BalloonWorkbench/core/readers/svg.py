# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of an SVG file, curves flattened."""

from __future__ import annotations

import math
from collections.abc import Iterator
from io import BytesIO
from typing import Any
from xml.etree import ElementTree

import numpy as np

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.files.foreign_reader import foreign_reader
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.welds import LAYER
from BalloonWorkbench.core.readers.svg_source import harmless
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import INCH

_PIXEL = INCH / 96  # a CSS pixel, which is the unit of plain numbers
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"


def read_svg(
    data: bytes, tolerance: float, budget: Budget
) -> tuple[list[Floats], list[Floats], list[Floats]]:
    """Lines (n, 2) m of an SVG document, y up; those of them that are filled though open; welds.

    What is named LAYER, or lies in a group or layer of that name, is a weld and not one of the lines.

    Closed lines come with their first point repeated at the end. Hidden elements and texts are left out.

    tolerance  largest distance between a curve and its polyline [m]
    InputError for a file that is no SVG, defines entities, repeats itself without end or is too much.
    """
    try:
        import svgelements  # type: ignore[import-untyped]
    except ImportError:
        raise MissingPackageError(
            "SVG files need the Python package svgelements. Install it with 'pip install svgelements', "
            "or save the drawing as DXF."
        ) from None
    root = harmless(data, budget)
    lines: list[Floats] = []
    filled: list[Floats] = []
    welds: list[Floats] = []
    with foreign_reader(_refusal):
        width, height = _viewport(root, svgelements)
        source = BytesIO(ElementTree.tostring(root))
        document = svgelements.SVG.parse(source, reify=False, ppi=96, width=width, height=height)
        for element, weld in _elements(document, False):
            budget.check_time()
            if not isinstance(element, svgelements.Shape) or element.values.get("visibility") == "hidden":
                continue
            fills = element.fill is not None and element.fill.value is not None
            for line in _lines(svgelements.Path(element), height, tolerance, budget, svgelements):
                closed = np.array_equal(line[0], line[-1])
                (welds if weld else lines).append(line)
                if not weld and fills and not closed and len(line) > 2:
                    filled.append(line)
    return lines, filled, welds


def _refusal(reason: str) -> InputError:
    return InputError(f"The SVG file cannot be read ({reason}). Save it as plain SVG once more.")


def _lines(path: Any, height: float, tolerance: float, budget: Budget, svgelements: Any) -> Iterator[Floats]:
    """Lines (n, 2) m, y up, of the parts of a path."""
    # Arcs do not stay arcs under every transform, so that points are transformed, not segments.
    a, b, c, d, e, f = (float(getattr(path.transform, name)) for name in "abcdef")
    matrix = np.array([[a, b], [c, d]])
    if not np.isfinite([a, b, c, d, e, f]).all():
        raise ValueError("a transform is not a number")
    scale = float(np.linalg.norm(matrix, 2))
    if scale == 0:
        return
    for part in _parts(path, svgelements):
        points = _flatten(part, tolerance / (_PIXEL * scale), budget, svgelements)
        if len(points) < 2:
            continue
        with np.errstate(over="ignore", invalid="ignore"):  # what is endless is refused as an outline
            x, y = (np.array(points) @ matrix + (e, f)).T
        yield np.column_stack([x, height - y]) * _PIXEL


def _parts(path: Any, svgelements: Any) -> Iterator[list[Any]]:
    """The segments of each part of a path that is drawn without lifting the pen."""
    part: list[Any] = []
    for segment in path:
        if isinstance(segment, svgelements.Move) and part:
            yield part
            part = []
        part.append(segment)
        if isinstance(segment, svgelements.Close):
            yield part
            part = []
    if part:
        yield part


def _elements(group: Any, weld: bool) -> Iterator[tuple[Any, bool]]:
    """All elements in a group of svgelements, and whether they are welds."""
    for element in group:
        names = (element.id, element.values.get(_LABEL)) if hasattr(element, "values") else ()
        inside = weld or any(name is not None and name.lower() == LAYER for name in names)
        yield element, inside
        if isinstance(element, list):
            yield from _elements(element, inside)


def _viewport(root: ElementTree.Element, svgelements: Any) -> tuple[float, float]:
    """Width and height of the drawing in pixels; without own ones those of its view box."""
    box = [float(value) for value in (root.get("viewBox") or "").replace(",", " ").split()]
    ratio = box[3] / box[2] if len(box) == 4 and box[2] > 0 else None
    sizes = {}
    for name in ("width", "height"):
        text = root.get(name)
        if text is not None and "%" not in text and text.strip() != "auto":
            sizes[name] = float(svgelements.Length(text).value(ppi=96))
    if not sizes:
        return (box[2], box[3]) if ratio else (1000.0, 1000.0)
    ratio = ratio or 1.0
    width = sizes["width"] if "width" in sizes else sizes["height"] / ratio
    return width, sizes.get("height", width * ratio)


def _flatten(
    part: list[Any], tolerance: float, budget: Budget, svgelements: Any
) -> list[tuple[float, float]]:
    """Points of a part of a path within `tolerance` px; the first again at the end where it is closed."""
    points: list[tuple[float, float]] = []
    counts = [_steps(segment, tolerance, svgelements) for segment in part]
    budget.spend_points(sum(counts))
    for segment, count in zip(part, counts):
        budget.check_time()
        if not points and not isinstance(segment, svgelements.Move):
            points = [_xy(segment.start)]  # goes on where the part before it was closed
        if isinstance(segment, svgelements.Move):
            points = [_xy(segment.end)]
        elif isinstance(segment, svgelements.Close):
            if points[-1] != points[0]:
                points.append(points[0])
        else:
            steps = math.ceil(count)
            points += [_xy(segment.point(k / steps)) for k in range(1, steps)]
            points.append(_xy(segment.end))
    if len(points) > 3 and math.dist(points[0], points[-1]) < 1e-9 * max(1.0, *map(abs, points[0])):
        points[-1] = points[0]
    if not all(map(math.isfinite, _numbers(points))):
        raise ValueError("a coordinate is not a number")
    return points


def _numbers(points: list[tuple[float, float]]) -> Iterator[float]:
    for point in points:
        yield from point


def _xy(point: Any) -> tuple[float, float]:
    return float(point.x), float(point.y)


def _steps(segment: Any, tolerance: float, svgelements: Any) -> float:
    """Straight pieces that a segment needs; from the bound |second derivative| / 8 of a chord's error."""
    if isinstance(segment, svgelements.CubicBezier):
        a, b, c, d = (
            complex(*_xy(p)) for p in (segment.start, segment.control1, segment.control2, segment.end)
        )
        bend = 6 * max(abs(a - 2 * b + c), abs(b - 2 * c + d))
    elif isinstance(segment, svgelements.QuadraticBezier):
        a, b, c = (complex(*_xy(p)) for p in (segment.start, segment.control, segment.end))
        bend = 2 * abs(a - 2 * b + c)
    elif isinstance(segment, svgelements.Arc):
        bend = max(segment.rx, segment.ry) * float(segment.sweep) ** 2
    else:
        bend = 0.0
    if math.isnan(bend):
        raise ValueError("a coordinate is not a number")
    return max(1.0, math.sqrt(bend / (8 * tolerance)))
