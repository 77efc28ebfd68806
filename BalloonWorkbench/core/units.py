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

#: What makes a kilogram heavy [m/s2], and water at 20 degrees [kg/m3].
_GRAVITY, _WATER = 9.80665, 998.2
PRESSURE_UNITS = {
    "pa": 1.0,
    "hpa": 100.0,
    "kpa": 1e3,
    "mbar": 100.0,
    "bar": 1e5,
    "psi": 0.45359237 * _GRAVITY / INCH**2,
    "mmh2o": _GRAVITY,
    "cmh2o": 10.0 * _GRAVITY,
    "inh2o": 1e3 * _GRAVITY * INCH,
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

#: A lift may be given as a force.
MASS_UNITS = {"g": 1e-3, "gram": 1e-3, "grams": 1e-3, "kg": 1.0, "oz": 28.349523125e-3, "n": 1.0 / _GRAVITY}

#: Units for people: from which size on [SI], how large [SI], name; the second is the usual one.
_Units = tuple[tuple[float, float, str], ...]
_LENGTHS: _Units = ((0.0, 1e-6, "µm"), (1e-5, 1e-3, "mm"), (10.0, 1.0, "m"))
_AREAS: _Units = ((0.0, 1e-6, "mm²"), (1e-4, 1e-4, "cm²"), (1.0, 1.0, "m²"))
_VOLUMES: _Units = ((0.0, 1e-9, "mm³"), (1e-6, 1e-6, "ml"), (1e-3, 1e-3, "l"), (1.0, 1.0, "m³"))
_MASSES: _Units = ((0.0, 1e-6, "mg"), (1e-3, 1e-3, "g"), (1.0, 1.0, "kg"))
_PRESSURES: _Units = ((0.0, 1.0, "Pa"), (100.0, 1e3, "kPa"), (1e7, 1e6, "MPa"))
#: Smaller than this many decimals, a number is none.
_DECIMALS = 9

_QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*)", re.IGNORECASE | re.DOTALL)

Number = TypeVar("Number", float, NDArray[np.float64])


def to_mm(metres: Number) -> Number:
    """Metres to millimetres; a number or an array."""
    return metres / MILLIMETRE


def from_mm(millimetres: Number) -> Number:
    """Millimetres to metres; a number or an array."""
    return millimetres * MILLIMETRE


def from_mm_per_minute(feed: float) -> float:
    """A feed as machines are told it to metres a second."""
    return feed * MILLIMETRE / 60.0


def to_mm_per_minute(speed: float) -> float:
    """Metres a second to a feed as machines are told it."""
    return speed * 60.0 / MILLIMETRE


def number_text(value: float, digits: int = 3) -> str:
    """A number for people: so many digits that count, all of those before the point, never an exponent."""
    if not math.isfinite(value):
        return "?"
    first = math.floor(math.log10(abs(value))) if value else 0
    text = f"{value:.{min(max(digits - 1 - first, 0), _DECIMALS)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def length_text(metres: float, digits: int = 4) -> str:
    """A length for people: millimetres, from 10 m on metres."""
    return _measure(metres, digits, _LENGTHS)


def size_text(*metres: float, digits: int = 3) -> str:
    """Lengths of one thing, such as width, height and thickness, in one unit."""
    scale, unit = _unit(max(map(abs, metres)), _LENGTHS)
    return f"{' x '.join(number_text(length / scale, digits) for length in metres)} {unit}"


def area_text(square_metres: float) -> str:
    """An area for people."""
    return _measure(square_metres, 3, _AREAS)


def volume_text(cubic_metres: float) -> str:
    """A volume for people."""
    return _measure(cubic_metres, 3, _VOLUMES)


def mass_text(kilograms: float) -> str:
    """A mass for people."""
    return _measure(kilograms, 3, _MASSES)


def pressure_text(pascals: float) -> str:
    """A pressure for people."""
    return _measure(pascals, 3, _PRESSURES)


def water_column_text(pascals: float) -> str:
    """How high a pressure lifts the water in a hose manometer; rounded down, for it must not be more."""
    column = pascals / (_WATER * _GRAVITY)
    return f"{math.floor(to_mm(column))} mm ({math.floor(10.0 * column / INCH) / 10.0:g} in)"


def temperature_text(kelvin: float) -> str:
    """A temperature for people, as it may be typed."""
    return f"{number_text(kelvin - 273.15)}C"


def speed_text(speed: float) -> str:
    """A speed along a line for people, as machines are told it."""
    return f"{number_text(to_mm_per_minute(speed))} mm/min"


def seconds_text(seconds: float) -> str:
    """A short time for people."""
    return f"{number_text(seconds)} s"


def money_text(amount: float, currency: str) -> str:
    """A price for people: two decimals, but for very small and large ones."""
    common = amount == 0.0 or 0.005 <= amount < 100.0
    return f"{f'{amount:.2f}' if common else number_text(amount, 1)} {currency}"


def percent_text(share: float) -> str:
    """A share of 1 for people."""
    return f"{number_text(100.0 * share, 2)} %"


def _measure(value: float, digits: int, units: _Units) -> str:
    scale, unit = _unit(abs(value), units)
    return f"{number_text(value / scale, digits)} {unit}"


def _unit(size: float, units: _Units) -> tuple[float, str]:
    """The largest unit that begins at or below a size; the usual one for nothing."""
    if size == 0.0:
        return units[1][1:]
    return next((unit[1:] for unit in reversed(units) if size >= unit[0]), units[0][1:])


def place_text(point: NDArray[np.float64]) -> str:
    """A point (2,) or (3,) m for people."""
    scale, unit = _unit(max(float(np.abs(point).max()), MILLIMETRE), _LENGTHS)
    digits = 1 if scale == MILLIMETRE else 2
    values = ", ".join(number_text(round(float(value) / scale, digits), 4) for value in point)
    return f"({values}) {unit}"


def parse_length(text: str | float) -> float:
    """'300mm', '30 cm', '12in', or a plain number in metres -> m. InputError where it makes no sense."""
    return _parse(text, LENGTH_UNITS, "length", "300mm, 30cm, 0.3m, 12in")


def parse_size(text: str, plain: str = "m") -> tuple[float, float | None]:
    """'500mmx700mm', '50 x 70 cm' -> width and height in m; height None where only a width is given.

    A number without a unit has that of the other one, or the plain unit. InputError where it makes no sense.
    """
    words = re.split(r"\s*[x×]\s*", text.strip())
    if not (1 <= len(words) <= 2 and all(words)):
        raise InputError(f"'{text}' is no size: write 500mm for a width, 500mmx700mm for width and height.")
    unit = re.sub(r"[\d.\s]", "", words[-1]) or plain
    sizes = [parse_length(word if re.search(r"[^\d.]", word) else word + unit) for word in words]
    return sizes[0], sizes[1] if len(sizes) > 1 else None


def parse_pressure(text: str | float) -> float:
    """'2kPa', '20 mbar', '5 psi', or a plain number in pascals -> Pa. InputError where it makes no sense."""
    return _parse(text, PRESSURE_UNITS, "pressure", "2kPa, 20mbar, 0.3psi")


def parse_volume(text: str | float, plain: str = "m3") -> float:
    """'5l', '250 ml', or a number in the plain unit -> m3. InputError where it makes no sense."""
    return _parse(text, VOLUME_UNITS, "volume", "5l, 250ml, 0.005m3", plain)


def parse_mass(text: str | float, plain: str = "kg") -> float:
    """'5g', '0.1 oz', '0.05N' or a number in the plain unit -> kg. InputError where it makes no sense."""
    return _parse(text, MASS_UNITS, "mass", "5g, 0.2oz, 0.05N", plain)


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
        raise InputError(f"'{text}' is not a {what}; write it like {examples}.")
    return value
