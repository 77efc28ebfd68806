# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon is to be best at, within which limits, and what may be chosen for that."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.axes import BETWEEN, Between, axis_of
from BalloonWorkbench.core.studies.columns import column_named
from BalloonWorkbench.core.studies.results import RESULTS
from BalloonWorkbench.core.studies.study import Row
from BalloonWorkbench.core.units import (
    number_text,
    parse_length,
    parse_mass,
    parse_pressure,
    parse_volume,
    to_grams,
    to_mm,
)

MINIMIZE, MAXIMIZE, REACH, OVER, LIMITS = "minimize", "maximize", "reach", "over", "limits"
#: How the best is searched for: downhill from the middle of the ranges, or by samples of all of them.
SEARCH, COBYLA, OPTUNA = "search", "cobyla", "optuna"
MOST_CHOICES = 200
_SENSES = (MINIMIZE, MAXIMIZE, REACH)
_LIKE = '{"minimize": "film_cost", "over": {"width": ["100mm", "400mm"]}, "limits": {"lift": ">= 20 g"}}'
_READ: dict[str, Callable[[str], float]] = {
    "m3": parse_volume,
    "mm": lambda text: to_mm(parse_length(text)),
    "Pa": parse_pressure,
    "g": lambda text: to_grams(parse_mass(text)),
}


@dataclass(frozen=True)
class GoalLimit:
    """A result that has to be at least, or else at most, a value in the unit of its column."""

    column: str
    at_least: bool
    value: float

    def lack(self, results: Mapping[str, Any]) -> float:
        """How far a balloon is outside, as a share of the limit; below 0 within, infinite without a value."""
        value = results.get(self.column)
        if value is None:
            return math.inf
        beyond = self.value - value if self.at_least else value - self.value
        return float(beyond / (abs(self.value) or 1.0))

    @property
    def text(self) -> str:
        """As a part of a sentence."""
        return f"{self.column} {'at least' if self.at_least else 'at most'} {number_text(self.value)}"


@dataclass(frozen=True)
class Goal:
    """What is best.

    sense    MINIMIZE, MAXIMIZE or REACH a result: `column`; `aim` is what is to be reached
    choices  all combinations of what is listed, each tried by itself
    ranges   what may have any value between two ends, by column
    search   COBYLA or OPTUNA
    """

    sense: str
    column: str
    aim: float
    choices: tuple[Row, ...]
    ranges: Mapping[str, Between]
    limits: tuple[GoalLimit, ...]
    search: str = COBYLA

    def cost(self, results: Mapping[str, Any]) -> float:
        """Smaller is better; infinite where there is no value."""
        value = results.get(self.column)
        if value is None:
            return math.inf
        if self.sense == REACH:
            return abs(float(value) - self.aim)
        return float(value) if self.sense == MINIMIZE else -float(value)

    def lack(self, results: Mapping[str, Any]) -> float:
        """How far a balloon is outside its limits at worst, as a share of one; 0 within all."""
        worst = max((limit.lack(results) for limit in self.limits), default=0.0)
        return max(worst, 0.0)


def read_goal(data: Any, folder: Path) -> Goal:
    """The goal that JSON declares; folder: from which files are looked for. Raises InputError."""
    if not isinstance(data, Mapping):
        raise InputError(f"The goal is no JSON object: write {_LIKE}.")
    if strange := [str(name) for name in data if name not in (*_SENSES, OVER, LIMITS, SEARCH)]:
        raise InputError(
            f"A goal has no '{strange[0]}': it has one of {', '.join(_SENSES)}, and {OVER}, {LIMITS} and"
            f" {SEARCH}."
        )
    senses = [sense for sense in _SENSES if sense in data]
    if len(senses) != 1:
        raise InputError(f"A goal has one of {', '.join(_SENSES)}: write {_LIKE}.")
    sense, asked, aim = senses[0], data[senses[0]], 0.0
    if sense == REACH:
        if not isinstance(asked, Mapping) or len(asked) != 1:
            raise InputError(f'"{REACH}" has one result and its value: write {{"lift": "20 g"}}.')
        ((asked, value),) = asked.items()
        aim = _number(result_named(asked), value)
    column = result_named(asked)
    choices, ranges = _choices(data.get(OVER), folder)
    way = data.get(SEARCH, COBYLA)
    if way not in (COBYLA, OPTUNA):
        raise InputError(f"'{way}' is no way to search: write {COBYLA} or {OPTUNA}.")
    return Goal(sense, column, aim, choices, ranges, _limits(data.get(LIMITS, {})), way)


def result_named(text: Any) -> str:
    """The column of results that is meant, with or without its unit. Raises InputError."""
    known = [result.name for result in RESULTS if result.kind is float]
    name = str(text).strip().replace("-", "_").replace(" ", "_")
    fitting = [each for each in known if each == name or each.rpartition("_")[0] == name]
    if fitting:
        return fitting[0]
    near = get_close_matches(name, known, 3, 0.4) or known
    raise InputError(f"There is no result '{text}': take {', '.join(near)}.")


def _number(column: str, written: Any) -> float:
    """A value in the unit of a column of results; a bare number is in that unit already."""
    text = str(written).strip()
    try:
        if isinstance(written, bool):
            raise ValueError
        value = float(text) if re.fullmatch(r"[-+\d.e]+", text) else _READ[column.rpartition("_")[2]](text)
    except (ValueError, KeyError):
        raise InputError(f"'{written}' is no value for {column}: write a number in its unit.") from None
    if not math.isfinite(value):
        raise InputError(f"'{written}' is no value for {column}: write a number in its unit.")
    return float(value)


def _choices(data: Any, folder: Path) -> tuple[tuple[Row, ...], dict[str, Between]]:
    """All combinations of what is listed, and the ranges: two numbers are the ends of one."""
    if not isinstance(data, Mapping) or not data:
        raise InputError(f'"{OVER}" says what may be chosen: write {{"width": ["100mm", "400mm"]}}.')
    lists: dict[str, Sequence[Any]] = {}
    ranges: dict[str, Between] = {}
    for name, value in data.items():
        column = column_named(name)
        ends = isinstance(value, list) and len(value) == 2 and column.is_number
        axis = axis_of(column, {BETWEEN: value} if ends else value, folder)
        if not isinstance(axis, Between):
            lists[column.name] = axis
        elif axis.whole:
            lists[column.name] = range(int(axis.start), int(axis.end) + 1)
        elif not axis.start < axis.end:
            raise InputError(f"{column.name} has no room between its ends: write the smaller one first.")
        else:
            ranges[column.name] = axis
    count = math.prod(len(values) for values in lists.values())
    if not 1 <= count <= MOST_CHOICES:
        raise InputError(
            f"The goal has {count} combinations to choose from, of which each is tried: list 1 to"
            f" {MOST_CHOICES}."
        )
    return tuple(dict(zip(lists, one, strict=True)) for one in itertools.product(*lists.values())), ranges


def _limits(data: Any) -> tuple[GoalLimit, ...]:
    if not isinstance(data, Mapping):
        raise InputError(f'"{LIMITS}" cannot be read: write {{"lift": ">= 20 g"}}.')
    limits = []
    for name, written in data.items():
        column = result_named(name)
        for one in written if isinstance(written, list) else [written]:
            match = re.fullmatch(r"\s*([<>])=?\s*(.+)", str(one))
            if match is None:
                raise InputError(f"'{one}' is no limit for {column}: write one such as \">= 20\".")
            limits.append(GoalLimit(column, match[1] == ">", _number(column, match[2])))
    for low, high in itertools.product(limits, limits):
        if low.column == high.column and low.at_least and not high.at_least and low.value > high.value:
            raise InputError(f"No balloon has {low.text} and {high.text}: these limits exclude each other.")
    return tuple(limits)
