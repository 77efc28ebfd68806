# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of a DXF file, curves flattened."""

from __future__ import annotations

import logging
import math
from collections.abc import Iterable, Iterator
from io import BytesIO, TextIOWrapper
from itertools import pairwise
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.files.foreign_reader import foreign_reader
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.welds import LAYER
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import INCH, MILLIMETRE

logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # it would print what it mends

_LINES = {"LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE"}
_BINARY = b"AutoCAD Binary DXF"
# Pairs of a code and a value that go by between two looks at the clock.
_AT_ONCE = 2000
# Of the time for a drawing, this may be gone when its file is read: ezdxf takes as long again to connect it.
_READING = 0.4
# Points through which a curve goes are interpolated all at once.
_MOST_FIT_POINTS = 5000
# Metres in the units that $INSUNITS numbers.
_UNITS = {
    1: INCH,
    2: 12 * INCH,
    4: MILLIMETRE,
    5: 1e-2,
    6: 1.0,
    7: 1e3,
    8: 1e-6 * INCH,
    9: 1e-3 * INCH,
    10: 36 * INCH,
    13: 1e-6,
    14: 1e-1,
}


def read_dxf(data: bytes, tolerance: float, budget: Budget) -> tuple[list[Floats], list[Floats], list[str]]:
    """Lines (n, 2) m of the model space of a DXF file, closed ones with their first point repeated; those on
    the layer of welds, and the points on it; remarks. See `dxf_lines`.
    """
    lines, notes = dxf_lines(data, tolerance, budget)
    by_kind = [[line for layer, line in lines if (layer == LAYER) == weld] for weld in (False, True)]
    return by_kind[0], by_kind[1], notes


def dxf_lines(data: bytes, tolerance: float, budget: Budget) -> tuple[list[tuple[str, Floats]], list[str]]:
    """Lines (n, 2) m of the model space of a DXF file with their layers, in small letters; remarks.

    Blocks are taken apart; layers that are off or frozen are left out.

    tolerance  largest distance between a curve and its polyline [m]
    InputError for a file that is no DXF or too much, MissingPackageError without ezdxf.
    """
    try:
        import ezdxf  # noqa: F401
    except ImportError:
        raise MissingPackageError(
            "DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', "
            "or save the drawing as SVG."
        ) from None
    with foreign_reader(_refusal):
        document, notes = _document(data, budget)
        unit, more = _unit(document)
        lines = [(layer, line * unit) for layer, line in _lines(document, tolerance / unit, budget)]
    return lines, [*notes, *more]


def _refusal(_: str) -> InputError:
    return InputError("The file is damaged or not a DXF file. Save it once more.")


def _document(data: bytes, budget: Budget) -> tuple[Any, list[str]]:
    """What ezdxf makes of a file, mended where it has to be; remarks."""
    import ezdxf
    from ezdxf import recover
    from ezdxf.document import Drawing
    from ezdxf.filemanagement import dxf_stream_info
    from ezdxf.lldxf.tagger import ascii_tags_loader, binary_tags_loader
    from ezdxf.lldxf.validator import is_dxf_stream

    if data.startswith(_BINARY):
        return Drawing.load(_watched(binary_tags_loader(data), budget)), []
    if not is_dxf_stream(_text(data, "utf-8", "ignore")):
        raise ValueError("no section")
    try:
        encoding = dxf_stream_info(_text(data, "utf-8", "ignore")).encoding
        lines = _text(data, encoding, "surrogateescape")
        return Drawing.load(_watched(ascii_tags_loader(lines), budget)), []
    except ezdxf.DXFError:  # type: ignore[attr-defined]
        document, _ = recover.read(_Stream(data, budget))
        return document, ["The DXF file has errors; what could be read was taken from it."]


def _text(data: bytes, encoding: str, errors: str) -> TextIOWrapper:
    return TextIOWrapper(BytesIO(data), encoding, errors)


def _watched(tags: Iterable[Any], budget: Budget) -> Iterator[Any]:
    """The pairs of a code and a value of a file, with a look at the clock now and then."""
    for number, tag in enumerate(tags):
        if number % _AT_ONCE == 0:
            budget.check_time(_READING)
        yield tag


class _Stream(BytesIO):
    """A file read by lines, with a look at the clock now and then."""

    def __init__(self, data: bytes, budget: Budget) -> None:
        super().__init__(data)
        self._budget, self._lines = budget, 0

    def readline(self, size: int | None = -1, /) -> bytes:
        """The next line."""
        self._lines += 1
        if self._lines % _AT_ONCE == 0:
            self._budget.check_time(_READING)
        return super().readline(size)


def _unit(document: Any) -> tuple[float, list[str]]:
    """Metres in a unit of the drawing."""
    code = int(document.header.get("$INSUNITS", 0))
    if code in _UNITS:
        return _UNITS[code], []
    named = f"names the unit {code}, which is not a usual one" if code else "does not name its unit"
    return MILLIMETRE, [f"The DXF file {named}; millimetres are assumed."]


def _lines(document: Any, tolerance: float, budget: Budget) -> Iterator[tuple[str, Floats]]:
    """The layer and the points of each line."""
    from ezdxf import disassemble

    visible = {layer.dxf.name.lower(): layer.is_on() and not layer.is_frozen() for layer in document.layers}
    budget.spend_elements(_Weights(document, budget).of(document.modelspace(), 0))
    for entity in disassemble.recursive_decompose(document.modelspace()):
        budget.check_time()
        layer = entity.dxf.layer.lower()
        if not visible.get(layer, True):
            continue
        if layer == LAYER and entity.dxftype() == "POINT":
            yield layer, np.array([tuple(entity.dxf.location)[:2]], dtype=np.float64)
        if entity.dxftype() not in _LINES:
            continue
        for points in _flatten(entity, tolerance, budget):
            line = np.array([(point[0], point[1]) for point in _counted(points, budget)], dtype=np.float64)
            if len(line) > 1 and np.isfinite(line).all():
                yield layer, line


class _Weights:
    """How many elements entities are once their blocks are taken apart."""

    def __init__(self, document: Any, budget: Budget) -> None:
        self._document, self._budget = document, budget
        self._known: dict[str, float] = {}
        self._open: set[str] = set()

    def of(self, entities: Iterable[Any], level: int) -> float:
        """Of entities that lie so many blocks deep; infinite for a block that shows itself."""
        self._budget.check_level(level)
        total = 0.0
        for entity in entities:
            self._budget.check_time()
            copies = max(1, entity.mcount) if entity.dxftype() == "INSERT" else 1
            blocks: Iterable[str] = getattr(entity, "__referenced_blocks__", tuple)()
            total += copies * (_weight(entity) + sum(self._of_block(handle, level) for handle in blocks))
        return total

    def _of_block(self, handle: str, level: int) -> float:
        if handle in self._open:
            return math.inf
        if handle not in self._known:
            record = self._document.entitydb.get(handle)
            block = self._document.blocks.get(record.dxf.name) if record is not None else None
            self._open.add(handle)
            self._known[handle] = self.of(block or (), level + 1)
            self._open.discard(handle)
        return self._known[handle]


def _weight(entity: Any) -> float:
    """Of one entity: one, and more for many points, each of which is copied with it."""
    kind = entity.dxftype()
    if kind in {"LWPOLYLINE", "POLYLINE", "MLINE"}:
        return 1.0 + 0.5 * len(entity.vertices if kind != "LWPOLYLINE" else entity)
    if kind == "SPLINE":
        return 1.0 + 0.01 * (len(entity.control_points) + len(entity.fit_points) + len(entity.knots))
    return 1.0


def _flatten(entity: Any, tolerance: float, budget: Budget) -> Iterator[Iterable[Any]]:
    """Points of an entity, or of each straight line and arc that it is made of."""
    kind = entity.dxftype()
    if kind == "LINE":
        yield entity.dxf.start, entity.dxf.end
    elif kind in {"LWPOLYLINE", "POLYLINE"}:
        if kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline):
            return
        if kind == "LWPOLYLINE" and not entity.has_arc:
            points = list(entity.vertices_in_wcs())
            yield from pairwise(points)
            if entity.closed and points:
                yield points[-1], points[0]
            return
        for part in entity.virtual_entities():
            yield from _flatten(part, tolerance, budget)
    elif kind in {"ARC", "CIRCLE"}:
        if entity.dxf.radius > 0:
            # ezdxf asks for the room of all points of an arc before it gives the first
            budget.allow_points(_arc_points(entity, tolerance))
            yield entity.flattening(min(tolerance, entity.dxf.radius))
    elif kind == "SPLINE" and not len(entity.control_points) and len(entity.fit_points) > _MOST_FIT_POINTS:
        raise InputError(
            f"The drawing has a curve through more than {_MOST_FIT_POINTS} points. Save it as a polyline."
        )
    else:
        yield entity.flattening(tolerance)


def _counted(points: Iterable[Any], budget: Budget) -> Iterator[Any]:
    """The points, each spent before the next is made."""
    for point in points:
        budget.spend_points(1)
        yield point


def _arc_points(arc: Any, tolerance: float) -> float:
    """Points that an arc needs."""
    turn = 360.0
    if arc.dxftype() == "ARC":
        turn = (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 or 360.0
    return float(np.radians(turn) * np.sqrt(arc.dxf.radius / (8.0 * tolerance)))
