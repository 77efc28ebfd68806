# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines written out as JSON: {"unit": "mm", "outer": [[x, y], ...], "holes": [[[x, y], ...], ...]}.

Several shapes: {"unit": "mm", "parts": [{"outer": ..., "holes": ...}, ...]}. Beside "outer" there may be
"welds": lines [[x, y], ...], closed ones with their first point repeated, and spots [[x, y]].
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from typing import Any, NoReturn

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.budget import MOST_ELEMENTS, Budget
from BalloonWorkbench.core.outline.drawing import Drawing, sealed
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import LENGTH_UNITS

_UNITS = ("mm", "cm", "m", "in")
_EXAMPLE = 'Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.'


def read_points(data: bytes, budget: Budget) -> Drawing:
    """The shapes in a JSON text, as they are written: neither cleaned nor checked. InputError."""
    # before all of it is unpacked: a list for each point, and some for the loops
    budget.allow_points(data.count(b"[") - MOST_ELEMENTS)
    budget.allow_points(data.count(b",") / 2 - MOST_ELEMENTS)
    budget.spend_elements(data.count(b"{"))
    try:
        text = json.loads(data, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise InputError(f"The JSON file cannot be read ({error}). {_EXAMPLE}") from None
    if not isinstance(text, dict):
        raise InputError(f"The JSON file has no 'outer' loop. {_EXAMPLE}")
    parts = text.get("parts", [text])
    if not isinstance(parts, list) or not parts:
        raise InputError(f"The 'parts' of the JSON file are not a list of shapes. {_EXAMPLE}")
    notes = () if "unit" in text else ("The JSON file does not name its unit; millimetres are assumed.",)
    unit = text.get("unit", "mm")
    if unit not in _UNITS:
        raise InputError(f"The JSON file has the unknown unit {unit!r}. Use one of {', '.join(_UNITS)}.")
    outlines = [_outline(part, LENGTH_UNITS[unit], budget) for part in parts]
    outlines.sort(key=lambda outline: -abs(signed_area(outline.outer)))
    return Drawing((replace(outlines[0], notes=notes), *outlines[1:]))


def _outline(part: Any, factor: float, budget: Budget) -> Outline:
    if not isinstance(part, dict) or "outer" not in part:
        raise InputError(f"The JSON file has no 'outer' loop. {_EXAMPLE}")
    holes, welds = part.get("holes", []), part.get("welds", [])
    for name, kind, lines in (("holes", "loops", holes), ("welds", "lines", welds)):
        if not isinstance(lines, list):
            raise InputError(f"The '{name}' of the JSON file are not a list of {kind}. {_EXAMPLE}")
    budget.spend_elements(1 + len(holes) + len(welds))
    plain = Outline(
        _loop(part["outer"], "'outer'", budget) * factor,
        tuple(_loop(hole, f"hole {number}", budget) * factor for number, hole in enumerate(holes, start=1)),
    )
    lines = [_loop(weld, f"weld {number}", budget, 1) * factor for number, weld in enumerate(welds, start=1)]
    return sealed(plain, lines)


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a coordinate")


def _loop(points: Any, what: str, budget: Budget, fewest: int = 3) -> Floats:
    if not isinstance(points, list) or len(points) < fewest:
        count = "three points" if fewest == 3 else "one point"
        raise InputError(f"The JSON file's {what} needs at least {count}. {_EXAMPLE}")
    budget.spend_points(len(points))
    for number, point in enumerate(points, start=1):
        if not (isinstance(point, list) and len(point) == 2 and all(map(_is_number, point))):
            raise InputError(f"Point {number} of the JSON file's {what} is not a pair of numbers. {_EXAMPLE}")
    return np.array(points, dtype=np.float64)


def _is_number(value: Any) -> bool:
    """Whether it is one that an array can hold; a whole number of JSON may have any length."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return abs(value) <= sys.float_info.max
