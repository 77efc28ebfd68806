# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between FreeCAD's units and those of the engine.

FreeCAD counts in mm, kg and s: lengths in mm, pressures in kg/(mm s2) = kPa. The engine counts in SI, and
what comes from a document is on its grid: see the core's rounded.py.
"""

from __future__ import annotations

import math

from BalloonWorkbench.core import units
from BalloonWorkbench.core.rounded import rounded

_KILO = 1000.0  # Pa per kPa


def number(value) -> float:
    """A property's value or a plain number, in FreeCAD's own units."""
    return float(getattr(value, "Value", value))


def metres(value) -> float:
    """A length property, quantity or number of mm, in m."""
    return rounded(units.from_mm(number(value)))


def pascals(value) -> float:
    """A pressure property, quantity or number of kPa, in Pa."""
    return rounded(number(value) * _KILO)


def cubic_metres(value) -> float:
    """A volume property, quantity or number of mm3, in m3."""
    return rounded(number(value) * units.MILLIMETRE**3)


def kilopascals(pressure: float) -> float:
    """Pa to the kPa that FreeCAD's pressure properties take."""
    return float(pressure) / _KILO


def length(value) -> float:
    """mm from a number of mm, a quantity, or text such as "12 in"; InputError for other text."""
    return units.to_mm(units.parse_length(value)) if isinstance(value, str) else number(value)


def pressure(value) -> float:
    """kPa from a number of kPa, a quantity, or text such as "20 mbar"; InputError for other text."""
    return kilopascals(units.parse_pressure(value)) if isinstance(value, str) else number(value)


def volume(value) -> float:
    """mm3 from a number of mm3, a quantity, or text such as "5 l"; InputError for other text."""
    return cubic_millimetres(units.parse_volume(value)) if isinstance(value, str) else number(value)


def radians(value) -> float:
    """An angle property or number of degrees, in rad."""
    return rounded(math.radians(number(value)))


def square_millimetres(area: float) -> float:
    """m2 to the mm2 that FreeCAD's area properties take."""
    return area / units.MILLIMETRE**2


def cubic_millimetres(volume: float) -> float:
    """m3 to the mm3 that FreeCAD's volume properties take."""
    return volume / units.MILLIMETRE**3
