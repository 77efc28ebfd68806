# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left of a roll or sheet: shapes that are kept in a file, and are film for the next layout."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import UNUSABLE, read_data, reason_of
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import LENGTH_UNITS, from_mm, length_text, to_mm

#: Name of the file, and of what is in it.
FILE = "remnant.json"
_SHAPES = "remnants"
#: Narrower film is waste, and so is what is smaller [m, m2].
_NARROWEST, _SMALLEST = from_mm(30.0), from_mm(50.0) ** 2
#: Shapes are that much smaller than what is left, so that few points describe them [m].
_SLACK = from_mm(0.2)
_MOST_SHAPES, _MOST_POINTS, _MOST_FILM = 50, 20_000, 20.0  # m
_DIGITS = 3  # of mm


@dataclass(frozen=True)
class Remnant:
    """Film of any shape, its lower left corner at the origin.

    area   polygon of shapely [m], with holes
    stock  which film it is, "" the balloon's, else a name such as "valve"
    """

    area: Any
    stock: str = ""

    @property
    def size(self) -> tuple[float, float]:
        """Length and width of its box [m]."""
        _, _, length, width = self.area.bounds
        return float(length), float(width)


def usable(area: Any, stock: str = "") -> list[Remnant]:
    """The parts of an area of shapely [m] that are wide and large enough to be used, the largest first."""
    opened = area.buffer(-0.5 * _NARROWEST, join_style="mitre").buffer(0.5 * _NARROWEST, join_style="mitre")
    inside = area.intersection(opened).buffer(-_SLACK, join_style="mitre").simplify(_SLACK)
    return [_at_origin(part, stock) for part in parts(inside) if part.area >= _SMALLEST]


def remnant_bytes(remnants: Sequence[Remnant]) -> bytes:
    """The file of remnants of one film, in millimetres."""
    shapes = [
        {"outer": _points(each.area.exterior), "holes": [_points(hole) for hole in each.area.interiors]}
        for each in remnants
    ]
    described = {"unit": "mm", "stock": remnants[0].stock if remnants else "", _SHAPES: shapes}
    return (json.dumps(described) + "\n").encode()


def read_remnants(path: Path) -> list[Remnant]:
    """The remnants in a file, or the one shape of an outline that somebody has drawn.

    Raises InputError that names the file and says what is wrong.
    """
    try:
        return _remnants(read_data(path))
    except KeyError as error:
        raise InputError(f"The remnant {path.name} lacks {error}: add it.") from error
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"The remnant {path.name} is of no use: {reason_of(error)}") from error


def _remnants(data: Mapping[str, Any]) -> list[Remnant]:
    unit = str(data["unit"])
    if unit not in LENGTH_UNITS:
        raise InputError(f'there is no unit "{unit}": write "mm".')
    shapes = data.get(_SHAPES, [data] if "outer" in data else [])
    if not 1 <= len(shapes) <= _MOST_SHAPES:
        raise InputError(f"it has {len(shapes)} shapes: give 1 to {_MOST_SHAPES}.")
    return [_at_origin(_area(shape, LENGTH_UNITS[unit]), str(data.get("stock", ""))) for shape in shapes]


def _area(shape: Mapping[str, Any], unit: float) -> Any:
    loops = [unit * np.array(loop, dtype=np.float64) for loop in (shape["outer"], *shape.get("holes", ()))]
    for loop in loops:
        if loop.ndim != 2 or loop.shape[1] != 2 or not 3 <= len(loop) <= _MOST_POINTS:
            raise InputError("a loop is no list of at least three points [x, y].")
    size = extent(loops[0])
    if not size <= _MOST_FILM:
        raise InputError(f"film {length_text(size)} large is too much: are these numbers in the right unit?")
    area = shapely().Polygon(loops[0], loops[1:])
    if not area.is_valid or area.area <= 0.0:
        raise InputError("its lines cross or touch: give the edge of one piece of film, and its holes.")
    return area


def _at_origin(area: Any, stock: str) -> Remnant:
    left, below, _, _ = area.bounds
    return Remnant(shapely().transform(area, lambda points: points - [left, below]), stock)


def _points(ring: Any) -> list[list[float]]:
    points: Floats = to_mm(np.asarray(ring.coords)[:-1])
    return [[round(x, _DIGITS) + 0.0, round(y, _DIGITS) + 0.0] for x, y in points.tolist()]
