# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles from files: JSON {"unit": "mm", "profile": [[r, z], ...], "lower": "disc"}, or a drawing of one.

"lower" and "upper" are "point", "disc" or "open"; without them the ends tell. In place of points
{"unit": "mm", "natural_shape": 2000} is the weightless envelope whose gores are so long.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from BalloonWorkbench.core.bodies.check_profile import checked_profile, with_ends
from BalloonWorkbench.core.bodies.drawn_profile import profile_of_lines
from BalloonWorkbench.core.bodies.natural_shape import natural_shape
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.body import AUTOMATIC
from BalloonWorkbench.core.outline.budget import MOST_POINTS, Budget
from BalloonWorkbench.core.readers.dxf import read_dxf
from BalloonWorkbench.core.readers.svg import read_svg
from BalloonWorkbench.core.readers.vector import FLATNESS, read_bytes, vector_kind
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import LENGTH_UNITS

_UNITS = ("mm", "cm", "m", "in")
_EXAMPLE = 'Write {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.'


def read_profile(
    path: str | Path, lower: str = AUTOMATIC, upper: str = AUTOMATIC, budget: Budget | None = None
) -> Profile | None:
    """The profile in a JSON file, or in the lines of an SVG or DXF file; None for any other.

    lower, upper  how its ends are closed; AUTOMATIC as the file says
    Raises InputError, MissingPackageError.
    """
    path, budget = Path(path), budget or Budget()
    data = read_bytes(path)
    kind = vector_kind(path, data[:4096])
    if kind == "json":
        profile = profile_of_json(data)
        return None if profile is None else with_ends(profile, lower, upper)
    if kind == "svg":
        lines, _, _ = read_svg(data, FLATNESS, budget)
        return profile_of_lines(lines, lower, upper)
    if kind == "dxf":
        lines, _, notes = read_dxf(data, FLATNESS, budget)
        return profile_of_lines(lines, lower, upper, axis=0.0, notes=tuple(notes))
    return None


def profile_of_json(data: bytes) -> Profile | None:
    """The profile in a JSON text; None where it speaks of something else. InputError."""
    try:
        text = json.loads(data, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise InputError(f"The JSON file cannot be read ({error}). {_EXAMPLE}") from None
    if not isinstance(text, dict) or not {"profile", "natural_shape"} & set(text):
        return None
    notes = () if "unit" in text else ("The JSON file does not name its unit; millimetres are assumed.",)
    unit = text.get("unit", "mm")
    if unit not in _UNITS:
        raise InputError(f"The JSON file has the unknown unit {unit!r}. Use one of {', '.join(_UNITS)}.")
    lower, upper = (str(text.get(end, AUTOMATIC)) for end in ("lower", "upper"))
    if "profile" in text:
        return checked_profile(_points(text["profile"]) * LENGTH_UNITS[unit], lower, upper, notes)
    gore = text["natural_shape"]
    if not _is_number(gore) or not gore > 0.0:
        raise InputError("The 'natural_shape' of the JSON file is no length. Give the length of its gores.")
    return with_ends(natural_shape(float(gore) * LENGTH_UNITS[unit]), lower, upper)


def _points(points: Any) -> Floats:
    if not isinstance(points, list) or len(points) < 2:
        raise InputError(f"The 'profile' of the JSON file needs at least two points. {_EXAMPLE}")
    if len(points) > MOST_POINTS:
        raise InputError(f"The profile has more than {MOST_POINTS} points. Simplify it.")
    for number, point in enumerate(points, start=1):
        if not (isinstance(point, list) and len(point) == 2 and all(map(_is_number, point))):
            raise InputError(
                f"Point {number} of the JSON file's 'profile' is not a pair of numbers. {_EXAMPLE}"
            )
    return np.array(points, dtype=np.float64)


def _is_number(value: Any) -> bool:
    """Whether it is one that an array can hold; a whole number of JSON may have any length."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e12


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a coordinate")
