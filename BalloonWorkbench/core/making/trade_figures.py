# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the trade that the maker's numbers need, from resources/making.json."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.units import from_mm

FILE = RESOURCES / "making.json"
_MINUTE = 60.0


@dataclass(frozen=True)
class Making:
    """roll_width [m]; safety: strength over load; valve_film [kg/m2]; seals [N/m] by film; seal_share of the
    film's strength otherwise; prices per m3 of gas, film_prices per m2 of film; weld_speed [m/s] along
    a seam; handling [s] of each seam beside that; sources."""

    roll_width: float
    safety: float
    valve_film: float
    seals: Mapping[str, float]
    seal_share: float
    currency: str
    prices: Mapping[str, float]
    film_prices: Mapping[str, float]
    weld_speed: float
    handling: float
    note: str
    sources: tuple[str, ...]

    def seal_strength(self, film: Film) -> float | None:
        """Load at which a weld of this film opens [N/m]; None where not even the film's is known."""
        strength = self.seals.get(film.name)
        if strength is None and film.max_stress is not None:
            strength = self.seal_share * film.max_stress * film.thickness
        return strength

    def film_cost(self, film: Film, area: float) -> float | None:
        """Price of so much film [m2], without what is left over; None where it is not known."""
        price = self.film_prices.get(film.name)
        return None if price is None else price * area


@cache
def making() -> Making:
    """The figures. Raises InputError when the file is broken."""
    try:
        data = read_data(FILE)
        return Making(
            from_mm(float(data["roll_width_mm"])),
            float(data["safety"]),
            float(data["valve_film_kg_m2"]),
            {str(name): float(value) for name, value in data["seal_strength_N_m"].items()},
            float(data["seal_share_otherwise"]),
            str(data["currency"]),
            {str(name): float(value) for name, value in data["gas_price_per_m3"].items()},
            {str(name): float(value) for name, value in data["film_price_per_m2"].items()},
            float(data["weld_speed_m_per_min"]) / _MINUTE,
            float(data["handling_min_per_seam"]) * _MINUTE,
            str(data["note"]),
            tuple(str(source) for source in data["sources"]),
        )
    except UNUSABLE as error:
        raise InputError(f"The file {FILE.name} is of no use: {error!r}. Install it anew.") from error
