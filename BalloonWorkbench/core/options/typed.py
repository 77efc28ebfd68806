# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of options as people type them: what each kind is called, how it is read and written."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from BalloonWorkbench.core.options.option import Kind
from BalloonWorkbench.core.units import (
    length_text,
    number_text,
    parse_length,
    parse_mass,
    parse_pressure,
    parse_temperature,
    parse_volume,
    pressure_text,
    temperature_text,
)

#: What stands for "no" of an option that stands for a yes or no too.
NONE = "none"


def degrees(text: str) -> float:
    """The angle [rad]; ValueError for what is no number."""
    return math.radians(float(text))


#: How a value is called in the help, how it is read, and how a default is written, of each kind.
KINDS: dict[Kind, tuple[str, Callable[..., Any], Callable[[Any], str]]] = {
    Kind.LENGTH: ("LENGTH", parse_length, length_text),
    Kind.HEIGHT: ("LENGTH", parse_length, length_text),
    Kind.ANGLE: ("DEGREES", degrees, number_text),
    Kind.PRESSURE: ("PRESSURE", parse_pressure, pressure_text),
    Kind.VOLUME: ("VOLUME", parse_volume, str),
    Kind.MASS: ("MASS", parse_mass, str),
    Kind.TEMPERATURE: ("T", parse_temperature, temperature_text),
    Kind.NUMBER: ("N", float, number_text),
    Kind.COUNT: ("N", int, str),
    Kind.CHOICE: ("NAME", str, str),
    Kind.TEXT: ("TEXT", str, str),
    Kind.FILE: ("PICTURE", str, str),
}
