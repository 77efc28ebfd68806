# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, pressures and volumes as people write them, and the way between millimetres and metres.

The core works in SI units; this is the one place where other units are turned into them and back.
"""

from __future__ import annotations

import math
import re
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError

MILLIMETRE = 1e-3
INCH = 25.4e-3

LENGTH_UNITS = {
    "um": 1e-6,
    "µm": 1e-6,
    "mm": MILLIMETRE,
    "cm": 1e-2,
    "dm": 1e-1,
    "m": 1.0,
    "in": INCH,
    "inch": INCH,
    "inches": INCH,
    '"': INCH,
    "ft": 12 * INCH,
}

PRESSURE_UNITS = {
    "pa": 1.0,
    "hpa": 100.0,
    "kpa": 1e3,
    "mbar": 100.0,
    "bar": 1e5,
    "psi": 0.45359237 * 9.80665 / INCH**2,
}

VOLUME_UNITS = {
    "l": 1e-3,
    "litre": 1e-3,
    "litres": 1e-3,
    "ml": 1e-6,
    "cm3": 1e-6,
    "dm3": 1e-3,
    "m3": 1.0,
    "ft3": (12 * INCH) ** 3,
}

#: A lift may be given as a force; a kilogram weighs 9.80665 N.
MASS_UNITS = {"g": 1e-3, "gram": 1e-3, "grams": 1e-3, "kg": 1.0, "oz": 28.349523125e-3, "n": 1.0 / 9.80665}

_QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*)", re.IGNORECASE | re.DOTALL)

Number = TypeVar("Number", float, NDArray[np.float64])


def to_mm(metres: Number) -> Number:
    """Metres to millimetres; a number or an array."""
    return metres / MILLIMETRE


def from_mm(millimetres: Number) -> Number:
    """Millimetres to metres; a number or an array."""
    return millimetres * MILLIMETRE


def mm_text(metres: float) -> str:
    """A length for messages: three to four figures, in millimetres."""
    value = to_mm(metres)
    return f"{value:.0f} mm" if abs(value) >= 1000 else f"{value:.4g} mm"


def place_text(point: NDArray[np.float64]) -> str:
    """A point (2,) m for messages, in millimetres."""
    return f"({to_mm(float(point[0])):.4g}, {to_mm(float(point[1])):.4g}) mm"


def parse_length(text: str | float) -> float:
    """'300mm', '30 cm', '12in', or a plain number in metres -> m. InputError where it makes no sense."""
    return _parse(text, LENGTH_UNITS, "length", "300mm, 30cm, 0.3m or 12in")


def parse_size(text: str, plain: str = "m") -> tuple[float, float | None]:
    """'500mmx700mm', '50 x 70 cm' -> width and height in m; height None where only a width is given.

    A number without a unit has that of the other one, or the plain unit. InputError where it makes no sense.
    """
    words = re.split(r"\s*[x×]\s*", text.strip())
    if not 1 <= len(words) <= 2:
        raise InputError(f"'{text}' is no size: write 500mm for a width, 500mmx700mm for width and height.")
    unit = re.sub(r"[\d.\s]", "", words[-1]) or plain
    sizes = [parse_length(word if re.search(r"[^\d.]", word) else word + unit) for word in words]
    return sizes[0], sizes[1] if len(sizes) > 1 else None


def parse_pressure(text: str | float) -> float:
    """'2kPa', '20 mbar', '5 psi', or a plain number in pascals -> Pa. InputError where it makes no sense."""
    return _parse(text, PRESSURE_UNITS, "pressure", "2kPa, 20mbar or 0.3psi")


def parse_volume(text: str | float, plain: str = "m3") -> float:
    """'5l', '250 ml', or a number in the plain unit -> m3. InputError where it makes no sense."""
    return _parse(text, VOLUME_UNITS, "volume", "5l, 250ml or 0.005m3", plain)


def parse_mass(text: str | float, plain: str = "kg") -> float:
    """'5g', '0.1 oz', '0.05N' or a number in the plain unit -> kg. InputError where it makes no sense."""
    return _parse(text, MASS_UNITS, "mass", "5g, 0.2oz or 0.05N", plain)


def parse_temperature(text: str | float) -> float:
    """'20C', '68F', '293K', or a plain number in kelvins -> K. InputError where it makes no sense."""
    match = _QUANTITY.fullmatch(str(text).strip())
    unit = match[2].strip().lstrip("°").lower() if match else "?"
    if match is None or unit not in ("", "k", "c", "f"):
        raise InputError(f"'{text}' is not a temperature; write it as 20C, 68F or 293K.")
    value = float(match[1])
    kelvin = {"": value, "k": value, "c": value + 273.15, "f": (value + 459.67) / 1.8}[unit]
    if not kelvin > 0.0:
        raise InputError(f"'{text}' is colder than anything; write a temperature as 20C, 68F or 293K.")
    return kelvin


def from_grams(grams: float) -> float:
    """Grams to kilograms."""
    return 1e-3 * grams


def to_grams(kilograms: float) -> float:
    """Kilograms to grams."""
    return 1e3 * kilograms


def _parse(
    text: str | float, units: dict[str, float], what: str, examples: str, plain: str | None = None
) -> float:
    match = _QUANTITY.fullmatch(str(text).strip())
    # "MPa" and "mPa" differ by nine powers of ten, so neither is guessed from the other: both are refused.
    unit = (match[2].strip().lower() if match else "") or plain or ""
    factor = units.get(unit) if unit else 1.0
    value = float(match[1]) * factor if match and factor is not None else math.nan
    if not math.isfinite(value):
        raise InputError(f"'{text}' is not a {what}; write it as {examples}.")
    return value
