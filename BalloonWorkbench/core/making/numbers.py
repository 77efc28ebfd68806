# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers that a maker needs before cutting: how much of what, what it weighs, whether it floats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from BalloonWorkbench.core.design.size_goal import Buoyancy, Scaling
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import ZERO_CELSIUS, Filling, air_pressure, gases
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.safety import Safety, safety
from BalloonWorkbench.core.making.trade_figures import Making, making
from BalloonWorkbench.core.making.weight import valve_weight
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.nesting.layout import Piece, Stock, check, layout_of
from BalloonWorkbench.core.nesting.rows import in_rows
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.units import length_text, mass_text, to_grams, to_mm

#: Gas is sold by the cubic metre at 15 degrees Celsius and 1 bar (ISO 2533 uses the same temperature).
_SOLD_AT = (ZERO_CELSIUS + 15.0, 1e5)  # K, Pa


def _length(metres: float) -> str:
    return length_text(metres, 3)


@dataclass(frozen=True)
class Floating:
    """A balloon with one gas.

    carries     what the gas carries [kg]
    left        that less the balloon's own weight: what it lifts besides itself [kg]
    from_width  width of the drawing from which it floats [m], None where no size does
    gas_needed  as it is sold [m3]
    cost        in the currency of the data, None where there is no price
    """

    gas: str
    carries: float
    left: float
    from_width: float | None
    gas_needed: float
    cost: float | None


@dataclass(frozen=True)
class Numbers:
    """What one balloon takes.

    film_area     of all panels with welds, allowance and neck [m2]
    film_cost     of that, without what is left over; None where there is no price
    roll          width and length [m] of film for all panels, laid side by side; None where it is too narrow
    seam_length   of the welds of one balloon [m]
    inner, border weight of the film inside the seams, and of weld, allowance and neck [kg]
    valve         weight of the intake's own pieces [kg]
    volume        [m3]
    floating      with the chosen gas first, then the others
    """

    film_area: float
    roll: tuple[float, float] | None
    seam_length: float
    inner: float
    border: float
    valve: float
    volume: float
    width: float
    floating: tuple[Floating, ...]
    safety: Safety
    currency: str
    film_cost: float | None

    @property
    def weight(self) -> float:
        """Of film, weld and valve [kg]."""
        return self.inner + self.border + self.valve

    def sentence(self, number: int = 0, length: Callable[[float], str] = _length) -> str:
        """Will it float? In one sentence, for the gas of that number; length: m as a text for the reader."""
        one, weight = self.floating[number], mass_text(self.weight)
        gas, carries = one.gas.capitalize(), mass_text(one.carries)
        weighs = f"film and valve weigh {weight}" if self.valve else f"the film weighs {weight}"
        if one.left > 0.0:
            return f"{gas} lifts {carries}, {weighs}: yes, and it carries {mass_text(one.left)}."
        if one.from_width is None:
            return f"{gas} lifts {carries}, {weighs}: no, at no size."
        wide = length(one.from_width)
        return f"{gas} lifts {carries}, {weighs}: no. From {wide} width on it would."


@memoized(most=8)
def maker_numbers(
    inflation: Inflation,
    film: Film,
    seam: Outline,
    pattern: Pattern,
    width: float,
    filling: Filling,
    *,
    pieces: Pattern | None = None,
    exact: bool = True,
) -> Numbers:
    """The numbers of one balloon.

    seam        of the flat panel; pattern: its panel, cut twice
    width       of the drawing [m]
    filling     the gas, and the air around it; other gases are looked at in the same air
    pieces      all that is cut for one balloon, with the pieces of its valve; None for the panels alone
    exact       as in `safety`
    """
    data = making()
    grown = pattern.film_area - seam.area
    valve = valve_weight(pattern, pieces)
    chosen = [filling, *(replace(filling, gas=gas, gas_temperature=None) for gas in gases().values())]
    seen: dict[str, Floating] = {}
    for each in chosen:
        if each.gas.name not in seen:
            seen[each.gas.name] = floating_in(each, inflation, film, seam.area, grown, valve, width, data)
    return Numbers(
        2.0 * pattern.film_area,
        film_on_roll(pattern, film, data.roll_width),
        pattern.seam_length,
        2.0 * film.areal_density * seam.area,
        2.0 * film.areal_density * grown,
        valve,
        inflation.volume,
        width,
        tuple(seen.values()),
        safety(inflation, film, exact=exact),
        data.currency,
        data.film_cost(film, 2.0 * pattern.film_area),
    )


def floating_in(
    filling: Filling,
    inflation: Inflation,
    film: Film,
    inner: float,
    border: float,
    valve: float,
    width: float,
    data: Making,
) -> Floating:
    """A balloon with one filling; inner, border: half its film inside and outside the seams [m2]."""
    pressure = inflation.report.pressure
    buoyancy = Buoyancy(filling.lightness(pressure), film.areal_density, lambda seam: inner + border, valve)
    scaling = Scaling(width, inflation.volume, inner, border)
    scale = scaling.floating(buoyancy) if buoyancy.lightness > 0.0 else None
    temperature, sold = _SOLD_AT
    inside = air_pressure(filling.altitude) + pressure
    needed = inflation.volume * inside / sold * temperature / filling.temperature
    price = data.prices.get(filling.gas.name)
    return Floating(
        filling.gas.title.lower(),
        buoyancy.lightness * inflation.volume,
        scaling.lift_at(1.0, buoyancy),
        None if scale is None else scale * width,
        needed,
        None if price is None else price * needed,
    )


def film_on_roll(pattern: Pattern, film: Film, width: float) -> tuple[float, float] | None:
    """Width and length of film for both panels on a roll, by the boxes around them: nesting may need less.

    None where the roll is too narrow.
    """
    return pieces_on_roll([Piece(pattern, 1, 1, film.lies)], width)


def pieces_on_roll(pieces: Sequence[Piece], width: float) -> tuple[float, float] | None:
    """The same for any pieces."""
    stock = Stock(width)
    try:
        check(pieces, stock)
    except InputError:
        return None
    units = [
        (k, back) for k, each in enumerate(pieces) for back in [False] * each.count + [True] * each.backs
    ]
    (places,) = in_rows(pieces, stock, units)
    return width, layout_of(stock, pieces, places).length


def numbers_report(numbers: Numbers) -> dict[str, Any]:
    """The numbers as plain data; keys carry their units."""
    safe = numbers.safety
    return {
        "film_area_m2": numbers.film_area,
        "film_cost": numbers.film_cost,
        "roll_width_mm": None if numbers.roll is None else to_mm(numbers.roll[0]),
        "roll_length_mm": None if numbers.roll is None else to_mm(numbers.roll[1]),
        "seam_length_mm": to_mm(numbers.seam_length),
        "weight_g": {
            "film": to_grams(numbers.inner),
            "weld_and_neck": to_grams(numbers.border),
            "valve": to_grams(numbers.valve),
            "all": to_grams(numbers.weight),
        },
        "volume_m3": numbers.volume,
        "will_it_float": numbers.sentence(),
        "floating": [
            {
                "gas": one.gas,
                "carries_g": to_grams(one.carries),
                "lift_g": to_grams(one.left),
                "floats": one.left > 0.0,
                "floats_from_width_mm": None if one.from_width is None else to_mm(one.from_width),
                "gas_m3": one.gas_needed,
                "cost": one.cost,
            }
            for one in numbers.floating
        ],
        "currency": numbers.currency,
        "strength": {
            "film_tension_N_per_m": safe.film_load.value,
            "film_limit_N_per_m": safe.film_limit,
            "weld_tension_N_per_m": safe.weld_load.value,
            "weld_limit_N_per_m": safe.weld_limit,
            "margin": safe.margin,
            "pressure_Pa": safe.pressure,
            "safe_pressure_Pa": safe.safe_pressure,
            "weakest": safe.weakest,
            "weakest_at_mm": None if safe.place is None else to_mm(safe.place).tolist(),
            "at_rest": safe.at_rest,
        },
    }
