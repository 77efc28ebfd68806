# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of a DXF file, curves flattened."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.outline.welds import LAYER
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import INCH, MILLIMETRE

logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # it would print what it mends

_LINES = {"LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE"}
_MOST_POINTS = 500_000
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


def read_dxf(path: Path, tolerance: float) -> tuple[list[Floats], list[Floats], list[str]]:
    """Lines (n, 2) m of the model space of a DXF file, closed ones with their first point repeated; those on
    the layer of welds, and the points on it; remarks.

    Blocks are taken apart; layers that are off or frozen are left out.

    tolerance  largest distance between a curve and its polyline [m]
    InputError for a file that is no DXF, MissingPackageError without ezdxf.
    """
    try:
        import ezdxf
        from ezdxf import recover
    except ImportError:
        raise MissingPackageError(
            "DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', "
            "or save the drawing as SVG."
        ) from None
    try:
        try:
            document = ezdxf.readfile(path)  # type: ignore[attr-defined]
        except ezdxf.DXFError:  # type: ignore[attr-defined]
            document, _ = recover.readfile(path)
        unit, notes = _unit(document)
        found = list(_lines(document, tolerance / unit))
        lines, welds = (
            [line * unit for layer, line in found if (layer == LAYER) == on] for on in (False, True)
        )
    except (
        *(ezdxf.DXFError, OSError, ValueError, TypeError, LookupError),  # type: ignore[attr-defined]
        *(AttributeError, ArithmeticError, RecursionError, StopIteration),
    ):
        raise InputError(f"'{path.name}' is damaged or not a DXF file. Save it once more.") from None
    return lines, welds, notes


def _unit(document: Any) -> tuple[float, list[str]]:
    """Metres in a unit of the drawing."""
    code = int(document.header.get("$INSUNITS", 0))
    if code in _UNITS:
        return _UNITS[code], []
    named = f"names the unit {code}, which is not a usual one" if code else "does not name its unit"
    return MILLIMETRE, [f"The DXF file {named}; millimetres are assumed."]


def _lines(document: Any, tolerance: float) -> Iterator[tuple[str, Floats]]:
    """The layer and the points of each line."""
    from ezdxf import disassemble

    shown = {layer.dxf.name.lower(): layer.is_on() and not layer.is_frozen() for layer in document.layers}
    total = 0
    for entity in disassemble.recursive_decompose(document.modelspace()):
        layer = entity.dxf.layer.lower()
        if not shown.get(layer, True):
            continue
        if layer == LAYER and entity.dxftype() == "POINT":
            yield layer, np.array([tuple(entity.dxf.location)[:2]], dtype=np.float64)
        if entity.dxftype() not in _LINES:
            continue
        for points in _flatten(entity, tolerance):
            line = np.array([(point[0], point[1]) for point in points], dtype=np.float64)
            total += len(line)
            if total > _MOST_POINTS:
                raise InputError(
                    "The DXF file has too many lines. Leave only the outline and its holes in it."
                )
            if len(line) > 1 and np.isfinite(line).all():
                yield layer, line


def _flatten(entity: Any, tolerance: float) -> Iterator[Iterable[Any]]:
    """Points of an entity, or of each straight line and arc that it is made of."""
    kind = entity.dxftype()
    if kind == "LINE":
        yield entity.dxf.start, entity.dxf.end
    elif kind in {"LWPOLYLINE", "POLYLINE"}:
        if kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline):
            return
        for part in entity.virtual_entities():
            yield from _flatten(part, tolerance)
    elif kind in {"ARC", "CIRCLE"}:
        if entity.dxf.radius > 0:
            _refuse_endless(entity, tolerance)
            yield entity.flattening(min(tolerance, entity.dxf.radius))
    else:
        yield entity.flattening(tolerance)


def _refuse_endless(arc: Any, tolerance: float) -> None:
    """ezdxf asks for the room of all points of an arc before it gives the first."""
    turn = 360.0
    if arc.dxftype() == "ARC":
        turn = (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 or 360.0
    if np.radians(turn) * np.sqrt(arc.dxf.radius / (8.0 * tolerance)) > _MOST_POINTS:
        raise InputError("The DXF file has an endless arc. Leave only the outline and its holes in it.")
