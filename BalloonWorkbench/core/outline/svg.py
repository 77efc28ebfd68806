# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of an SVG file, curves flattened."""

from __future__ import annotations

import math
from collections.abc import Iterator
from io import BytesIO
from typing import Any
from xml.etree import ElementTree
from xml.parsers import expat

import numpy as np

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.outline.welds import LAYER
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import INCH

_PIXEL = INCH / 96  # a CSS pixel, which is the unit of plain numbers
_MOST_ELEMENTS = 100_000
_XLINK = "{http://www.w3.org/1999/xlink}href"
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"


def read_svg(data: bytes, tolerance: float) -> tuple[list[Floats], list[Floats], list[Floats]]:
    """Lines (n, 2) m of an SVG document, y up; those of them that are filled though open; welds.

    What is named LAYER, or lies in a group or layer of that name, is a weld and not one of the lines.

    Closed lines come with their first point repeated at the end. Hidden elements and texts are left out.

    tolerance  largest distance between a curve and its polyline [m]
    InputError for a file that is no SVG, defines entities or repeats itself without end.
    """
    try:
        import svgelements  # type: ignore[import-untyped]
    except ImportError:
        raise MissingPackageError(
            "SVG files need the Python package svgelements. Install it with 'pip install svgelements', "
            "or save the drawing as DXF."
        ) from None
    root = _harmless(data)
    try:
        width, height = _viewport(root, svgelements)
        document = svgelements.SVG.parse(BytesIO(data), reify=False, ppi=96, width=width, height=height)
        lines: list[Floats] = []
        filled: list[Floats] = []
        welds: list[Floats] = []
        for element, weld in _elements(document, False):
            if not isinstance(element, svgelements.Shape) or element.values.get("visibility") == "hidden":
                continue
            path = svgelements.Path(element)
            # Arcs do not stay arcs under every transform, so that points are transformed, not segments.
            a, b, c, d, e, f = (float(getattr(path.transform, name)) for name in "abcdef")
            matrix = np.array([[a, b], [c, d]])
            if not np.isfinite([a, b, c, d, e, f]).all():
                raise ValueError("a transform is not a number")
            scale = float(np.linalg.norm(matrix, 2))
            if scale == 0:
                continue
            for part in path.as_subpaths():
                points = _flatten(svgelements.Path(part), tolerance / (_PIXEL * scale), svgelements)
                if len(points) < 2:
                    continue
                with np.errstate(over="ignore", invalid="ignore"):  # what is endless is refused as an outline
                    x, y = (np.array(points) @ matrix + (e, f)).T
                line = np.column_stack([x, height - y]) * _PIXEL
                fills = element.fill is not None and element.fill.value is not None
                closed = np.array_equal(line[0], line[-1])
                (welds if weld else lines).append(line)
                if not weld and fills and not closed and len(line) > 2:
                    filled.append(line)
    except (ValueError, TypeError, ArithmeticError, AttributeError, LookupError) as error:
        raise InputError(f"The SVG file cannot be read ({error}). Save it as plain SVG once more.") from error
    return lines, filled, welds


def _elements(group: Any, weld: bool) -> Iterator[tuple[Any, bool]]:
    """All elements in a group of svgelements, and whether they are welds."""
    for element in group:
        names = (element.id, element.values.get(_LABEL)) if hasattr(element, "values") else ()
        inside = weld or any(name is not None and name.lower() == LAYER for name in names)
        yield element, inside
        if isinstance(element, list):
            yield from _elements(element, inside)


def _harmless(data: bytes) -> ElementTree.Element:
    """The document's root, once it is sure that reading it needs neither other files nor endless memory."""

    def refuse(*_: object) -> None:
        raise InputError("The SVG file defines entities, which are not read. Save it as plain SVG.")

    parser = expat.ParserCreate()
    parser.EntityDeclHandler = refuse
    try:
        parser.Parse(data, True)
        root = ElementTree.fromstring(data)
    except (expat.ExpatError, ElementTree.ParseError, ValueError, LookupError) as error:
        raise InputError(f"The SVG file is damaged ({error}). Save it once more.") from None
    if root.tag.rpartition("}")[2] != "svg":
        raise InputError("The file is XML but no SVG drawing. Choose a drawing.")
    named = {element.get("id"): element for element in root.iter() if element.get("id")}
    try:
        elements = _count(root, named, {}, set())
    except RecursionError:
        elements = math.inf
    if elements > _MOST_ELEMENTS:
        raise InputError("The SVG file has too many elements, or some that use themselves. Simplify it.")
    return root


def _count(
    element: ElementTree.Element,
    named: dict[str | None, ElementTree.Element],
    known: dict[int, float],
    open_ones: set[int],
) -> float:
    """Number of elements once every <use> is replaced by what it shows; infinite where one shows itself."""
    key = id(element)
    if key in open_ones:
        return math.inf
    if key not in known:
        open_ones.add(key)
        total = 1 + sum(_count(child, named, known, open_ones) for child in element)
        link = element.get("href") or element.get(_XLINK) or ""
        if element.tag.rpartition("}")[2] == "use" and link.startswith("#") and link[1:] in named:
            total += _count(named[link[1:]], named, known, open_ones)
        open_ones.discard(key)
        known[key] = total
    return known[key]


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


def _flatten(path: Any, tolerance: float, svgelements: Any) -> list[tuple[float, float]]:
    """Points of one subpath within `tolerance` px; the first again at the end where it is closed."""
    points: list[tuple[float, float]] = []
    for segment in path:
        if isinstance(segment, svgelements.Move):
            points = [_xy(segment.end)]
        elif isinstance(segment, svgelements.Close):
            if points[-1] != points[0]:
                points.append(points[0])
        else:
            steps = _steps(segment, tolerance, svgelements)
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


def _steps(segment: Any, tolerance: float, svgelements: Any) -> int:
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
    return min(10_000, max(1, math.ceil(math.sqrt(bend / (8 * tolerance)))))
