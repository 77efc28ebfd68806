# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon is filled with, and how much lighter that is than the air around it.

Ideal gases; the air's pressure follows from the altitude as in the International Standard Atmosphere
(ISO 2533:1975), its temperature is given.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data
from BalloonWorkbench.core.options.drawing import FillingOptions
from BalloonWorkbench.core.units import number_text

FILE = RESOURCES / "gases.json"
DEFAULT_GAS = FillingOptions.gas

GAS_CONSTANT = 8.31446261815324  # J/(mol K)
GRAVITY = 9.80665  # m/s2, standard
AIR = 0.0289644  # molar mass of dry air [kg/mol]
ZERO_CELSIUS = 273.15  # K
ROOM = FillingOptions.air_temperature  # K

#: ISO 2533: pressure [Pa] and temperature [K] at sea level, gradient [K/m], gas constant of air [J/(kg K)].
_PRESSURE, _TEMPERATURE, _GRADIENT, _SPECIFIC = 101325.0, 288.15, 0.0065, 287.05287
_LOWEST, _TROPOPAUSE = -1000.0, 11000.0  # m
_COLDEST, _HOTTEST = 150.0, 700.0  # K


@dataclass(frozen=True)
class Gas:
    """A gas: name, what people read, molar mass [kg/mol], temperature [K] or None for that of the air."""

    name: str
    title: str
    molar_mass: float
    temperature: float | None
    note: str = ""
    sources: tuple[str, ...] = ()


@dataclass(frozen=True)
class Filling:
    """A gas and the air around it.

    gas_temperature  [K]; None for the gas's own: warm air is warm, others are as the air
    air_temperature  [K]
    altitude         above the sea [m]
    """

    gas: Gas = field(default_factory=lambda: gas(DEFAULT_GAS))
    gas_temperature: float | None = None
    air_temperature: float = ROOM
    altitude: float = FillingOptions.altitude

    @property
    def temperature(self) -> float:
        """Of the gas [K]."""
        return self.gas_temperature or self.gas.temperature or self.air_temperature

    def lightness(self, overpressure: float = 0.0) -> float:
        """Density of the air less that of the gas, which is under an overpressure [Pa] [kg/m3].

        Raises InputError for temperatures and altitudes out of all range.
        """
        for what, kelvin in (("air", self.air_temperature), ("gas", self.temperature)):
            if not _COLDEST <= kelvin <= _HOTTEST:
                raise InputError(
                    f"The temperature of the {what}, {number_text(kelvin - ZERO_CELSIUS)} degrees Celsius,"
                    " is out of"
                    " range: give one such as 20C."
                )
        outside = air_pressure(self.altitude)
        air = outside * AIR / (GAS_CONSTANT * self.air_temperature)
        inside = (outside + overpressure) * self.gas.molar_mass / (GAS_CONSTANT * self.temperature)
        return air - inside


def air_pressure(altitude: float) -> float:
    """Pressure [Pa] at an altitude [m]: ISO 2533, p0 (1 - a h/T0)^(g/(a R)). InputError above 11 km."""
    if not _LOWEST <= altitude <= _TROPOPAUSE:
        raise InputError(f"The altitude {number_text(altitude)} m is out of range: give one up to 11000 m.")
    exponent = GRAVITY / (_GRADIENT * _SPECIFIC)
    return float(_PRESSURE * (1.0 - _GRADIENT * altitude / _TEMPERATURE) ** exponent)


def gases() -> dict[str, Gas]:
    """All gases by name. Raises InputError when the data file is broken."""
    return dict(_library())


def gas(name: str) -> Gas:
    """The gas of this name; InputError with the known names when there is none."""
    known = _library()
    named = known.get("-".join(name.lower().split()))
    if named is None:
        raise InputError(f'There is no gas "{name}": choose one of {", ".join(known)}.')
    return named


@cache
def _library() -> dict[str, Gas]:
    try:
        data = read_data(FILE)
        return {name: _gas_of(name, entry) for name, entry in data.items()}
    except UNUSABLE as error:
        raise InputError(
            f"The file of gases {FILE.name} is of no use: {error!r}. Install it anew."
        ) from error


def _gas_of(name: str, entry: dict[str, Any]) -> Gas:
    warm = entry["temperature_K"]
    return Gas(
        name,
        str(entry["title"]),
        float(entry["molar_mass_kg_mol"]),
        None if warm is None else float(warm),
        str(entry["note"]),
        tuple(str(source) for source in entry["sources"]),
    )
