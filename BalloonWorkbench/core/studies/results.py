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
    paths     where the report of a part has it, the first that is there
    together  what a drawing of several shapes has, from the values of its parts, the largest first
    kind      float or bool
    """

    name: str
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


def _at(data: Any, path: str) -> Any:
    for name in path.split("."):
        if isinstance(data, list):
            data = data[int(name)] if int(name) < len(data) else None
        else:
            data = data.get(name) if isinstance(data, Mapping) else None
    return data


#: The results of a table, in its order. Lengths that describe a shape are those of the largest one.
RESULTS: tuple[Result, ...] = (
    Result("volume_m3", ("inflated.volume_m3",), sum),
    Result("width_mm", ("inflated.width_mm",)),
    Result("height_mm", ("inflated.height_mm",)),
    Result("thickness_mm", ("inflated.thickness_mm",)),
    Result("pressure_Pa", ("pressure_Pa",)),
    Result("safe_pressure_Pa", ("maker.strength.safe_pressure_Pa",), min),
    Result("max_tension_N_per_m", ("inflated.max_tension_N_per_m",), max),
    Result("error_mean_mm", ("design.silhouette_error_mm.mean", "design.error_mm.mean"), max),
    Result("error_max_mm", ("design.silhouette_error_mm.max", "design.error_mm.max"), max),
    Result("weight_g", ("maker.weight_g.all",), sum),
    Result("lift_g", ("maker.floating.0.lift_g",), sum),
    Result("gas_m3", ("maker.floating.0.gas_m3",), sum),
    Result("gas_cost", ("maker.floating.0.cost",), sum),
    Result("film_area_m2", ("maker.film_area_m2",), sum),
    Result("film_cost", ("maker.film_cost",), sum),
    Result("roll_length_mm", ("maker.roll_length_mm",), sum),
    Result("seam_length_mm", ("maker.seam_length_mm",), sum),
    Result("welding_hours", ("maker.welding.hours",), sum),
    Result("reached", ("design.reached",), all, bool),
    Result("converged", ("solve.converged",), all, bool),
)
WARNINGS = "warnings"


def results_of(report: Mapping[str, Any]) -> dict[str, Any]:
    """The results of a report by name, None for what it does not tell; its warnings as one text."""
    numbers = {result.name: result.of(report) for result in RESULTS}
    return numbers | {WARNINGS: " ".join(map(str, report.get("warnings", ())))}
