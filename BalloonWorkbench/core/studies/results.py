# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a table tells of a balloon: numbers of its report, by one list."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any


def _first(values: Sequence[Any]) -> Any:
    return values[0]


@dataclass(frozen=True)
class Result:
    """A column of results.

    name      with its unit, as in the report
    text      what it is, a line for people
    paths     where the report of a part has it, the first that is there
    together  what a drawing of several shapes has, from the values of its parts, the largest first
    kind      float or bool
    """

    name: str
    text: str
    paths: tuple[str, ...]
    together: Callable[[Sequence[Any]], Any] = _first
    kind: type[float] | type[bool] = float

    def of(self, report: Mapping[str, Any]) -> Any:
        """The value in a report; None where it has none."""
        parts = report.get("parts") or [report]
        values = [
            next((value for path in self.paths if (value := _at(part, path)) is not None), None)
            for part in parts
        ]
        return None if not values or None in values else self.together(values)


def _error(which: str) -> tuple[str, str]:
    """Where a report has an error: of two panels, of many."""
    return f"design.silhouette_error_mm.{which}", f"design.error_mm.{which}"


def _at(data: Any, path: str) -> Any:
    for name in path.split("."):
        if isinstance(data, list):
            data = data[int(name)] if int(name) < len(data) else None
        else:
            data = data.get(name) if isinstance(data, Mapping) else None
    return data


#: The results of a table, in its order. Lengths that describe a shape are those of the largest one.
RESULTS: tuple[Result, ...] = (
    Result("volume_m3", "Volume", ("inflated.volume_m3",), sum),
    Result("width_mm", "Width, inflated", ("inflated.width_mm",)),
    Result("height_mm", "Height, inflated", ("inflated.height_mm",)),
    Result("thickness_mm", "Thickness, inflated", ("inflated.thickness_mm",)),
    Result("pressure_Pa", "Pressure inside, above that outside", ("pressure_Pa",)),
    Result("safe_pressure_Pa", "Pressure with the margin left", ("maker.strength.safe_pressure_Pa",), min),
    Result("max_tension_N_per_m", "Largest tension of the film", ("inflated.max_tension_N_per_m",), max),
    Result("error_mean_mm", "Off the drawing, profile or body on average", _error("mean"), max),
    Result("error_max_mm", "Off it at most", _error("max"), max),
    Result("weight_g", "Weight of film, welds and valve", ("maker.weight_g.all",), sum),
    Result("lift_g", "What the chosen gas carries besides", ("maker.floating.0.lift_g",), sum),
    Result("gas_m3", "Gas that it takes, at the pressure outside", ("maker.floating.0.gas_m3",), sum),
    Result("gas_cost", "What this gas costs", ("maker.floating.0.cost",), sum),
    Result("film_area_m2", "Film that it takes", ("maker.film_area_m2",), sum),
    Result("film_cost", "What this film costs, without what is left over", ("maker.film_cost",), sum),
    Result("roll_length_mm", "Length of the usual roll that it takes", ("maker.roll_length_mm",), sum),
    Result("seam_length_mm", "Length of the seams", ("maker.seam_length_mm",), sum),
    Result("welding_hours", "Hours of welding, where they are known", ("maker.welding.hours",), sum),
    Result("reached", "It meets what it was designed for", ("design.reached",), all, bool),
    Result("converged", "The film came to rest", ("solve.converged",), all, bool),
)
WARNINGS = "warnings"


def results_of(report: Mapping[str, Any]) -> dict[str, Any]:
    """The results of a report by name, None for what it does not tell; its warnings as one text."""
    numbers = {result.name: result.of(report) for result in RESULTS}
    return numbers | {WARNINGS: " ".join(map(str, report.get("warnings", ())))}


def without_times(data: Any) -> Any:
    """A report without how long it took: the same balloon has the same bytes."""
    if isinstance(data, dict):
        return {name: without_times(value) for name, value in data.items() if name != "seconds"}
    return [without_times(each) for each in data] if isinstance(data, list) else data
