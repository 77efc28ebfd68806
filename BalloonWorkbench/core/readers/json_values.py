# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of a JSON text as it may come from anywhere: whether they are what they should be."""

from __future__ import annotations

import json
import sys
from typing import Any, NoReturn

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.budget import MOST_ELEMENTS, Budget
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import LENGTH_UNITS

_UNITS = ("mm", "cm", "m", "in")


def unpacked(data: bytes, budget: Budget, example: str) -> Any:
    """What a JSON text says. Raises InputError where it cannot be read or has too much in it.

    example  a sentence that shows what to write
    """
    # before all of it is unpacked: a list for each point, and some for the loops
    budget.allow_points(data.count(b"[") - MOST_ELEMENTS)
    budget.allow_points(data.count(b",") / 2 - MOST_ELEMENTS)
    budget.spend_elements(data.count(b"{"))
    try:
        return json.loads(data, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise InputError(f"The JSON file cannot be read ({error}). {example}") from None


def unit_of(text: dict[str, Any]) -> tuple[float, tuple[str, ...]]:
    """Metres in the unit of a text, and notes for the user. InputError for one that nobody knows."""
    notes = () if "unit" in text else ("The JSON file does not name its unit; millimetres are assumed.",)
    unit = text.get("unit", "mm")
    if unit not in _UNITS:
        raise InputError(f"The JSON file has the unknown unit {unit!r}. Use one of {', '.join(_UNITS)}.")
    return LENGTH_UNITS[unit], notes


def line_of(points: Any, what: str, budget: Budget, example: str, fewest: int = 3) -> Floats:
    """Points (n, 2) of a loop or line, so many at least. InputError that names it as `what`."""
    if not isinstance(points, list) or len(points) < fewest:
        count = "three points" if fewest == 3 else "one point"
        raise InputError(f"The JSON file's {what} needs at least {count}. {example}")
    budget.spend_points(len(points))
    for number, point in enumerate(points, start=1):
        if not (isinstance(point, list) and len(point) == 2 and all(map(is_number, point))):
            raise InputError(f"Point {number} of the JSON file's {what} is not a pair of numbers. {example}")
    return np.array(points, dtype=np.float64)


def is_number(value: Any) -> bool:
    """Whether it is one that an array can hold; a whole number of JSON may have any length."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return abs(value) <= sys.float_info.max


def is_count(value: Any) -> bool:
    """Whether it is a whole number that can count or number something."""
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**31


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a coordinate")
