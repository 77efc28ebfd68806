# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one column of a grid runs through: a list, equal steps, files, or all between two ends."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from glob import glob
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.columns import Column, text_of

LINSPACE, RANGE, GLOB, BETWEEN = "linspace", "range", "glob", "between"
_FORMS = (
    '["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} with how many, {"range": [6, 12, 2]} with the'
    ' step, {"between": ["1kPa", "3kPa"]} for samples, or {"glob": "drawings/*.png"}'
)
_DIGITS = 12  # that count, of numbers that are worked out
_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*)", re.IGNORECASE | re.DOTALL)
MOST = 1_000_000  # of the values of one column


@dataclass(frozen=True)
class Between:
    """All numbers from one end to the other, in a unit."""

    start: float
    end: float
    unit: str = ""
    whole: bool = False

    def at(self, share: float) -> str | float:
        """The value at a share in [0, 1) of the way."""
        if self.whole:
            return _written(self.start + math.floor(share * (self.end - self.start + 1.0)), self.unit)
        return _written(self.start + share * (self.end - self.start), self.unit)


#: Values as they are written, or all between two ends.
Axis = Sequence[Any] | Between


def axis_of(column: Column, data: Any, folder: Path) -> Axis:
    """What a column runs through, from its JSON; files are looked for from a folder. Raises InputError."""
    if isinstance(data, list):
        if not data:
            raise InputError(f"{column.name} has no values: write {_FORMS}.")
        return tuple(data)
    if not isinstance(data, dict):
        return (data,)
    form, terms = next(iter(data.items())) if len(data) == 1 else ("", None)
    if form == GLOB and isinstance(terms, str):
        return _files(terms, folder)
    ends = terms if isinstance(terms, list) else []
    read = _READERS.get((form, len(ends)))
    if read is None:
        raise InputError(f"{column.name} cannot be read ({str(data)[:80]}): write {_FORMS}.")
    if not column.is_number:
        raise InputError(f"{column.name} is no number: list its values.")
    return read(column, ends)


def _files(pattern: str, folder: Path) -> Axis:
    """The files of a pattern in the order of their names, as seen from the folder."""
    try:
        names = sorted(Path(name).as_posix() for name in glob(pattern, root_dir=folder, recursive=True))
        names = [name for name in names if (folder / name).is_file()]
    except ValueError:  # letters that no name has
        names = []
    if not names:
        raise InputError(f"No file is like '{pattern}' in '{folder}'. Check the pattern and the folder.")
    return names


def _equal_parts(column: Column, terms: list[Any]) -> Axis:
    count = terms[2]
    if not isinstance(count, int) or isinstance(count, bool) or not 1 <= count <= MOST:
        raise InputError(f"{column.name} takes from 1 to {MOST} equal parts, not '{count}'.")
    start, end, unit = _ends(column, terms[:2])
    part = (end - start) / (count - 1) if count > 1 else 0.0
    values = [start + number * part for number in range(count - 1)] + [end if count > 1 else start]
    return [_written(round(value) if column.is_whole else value, unit) for value in values]


def _equal_steps(column: Column, terms: list[Any]) -> Axis:
    """From the first to the last, this one with them where a step meets it."""
    start, end, unit = _ends(column, terms[:2])
    step = _quantity(column, terms[2])
    if step[1] not in ("", unit):
        raise InputError(f"The step of {column.name} has another unit than its ends: write the same one.")
    steps = (end - start) / step[0] if step[0] else math.inf
    if not 0.0 <= steps < MOST:
        raise InputError(f"{column.name} never gets from '{terms[0]}' to '{terms[1]}' by '{terms[2]}'.")
    return [_written(start + number * step[0], unit) for number in range(math.floor(steps + 1e-9) + 1)]


def _between(column: Column, terms: list[Any]) -> Axis:
    return Between(*_ends(column, terms), column.is_whole)


#: By the form and the length of its list.
_READERS: dict[tuple[str, int], Callable[[Column, list[Any]], Axis]] = {
    (LINSPACE, 3): _equal_parts,
    (RANGE, 3): _equal_steps,
    (BETWEEN, 2): _between,
}


def _ends(column: Column, terms: list[Any]) -> tuple[float, float, str]:
    (start, first), (end, last) = (_quantity(column, each) for each in terms)
    if first != last and "" not in (first, last):
        raise InputError(f"{column.name} begins in {first} and ends in {last}: write both in one unit.")
    unit = first or last
    for value in (start, end):
        column.read(_written(value, unit), Path())
    return start, end, unit


def _quantity(column: Column, written: Any) -> tuple[float, str]:
    """A number and its unit."""
    match = None if isinstance(written, bool) else _NUMBER.fullmatch(text_of(written))
    if match is None or not math.isfinite(float(match[1])):
        raise InputError(f"'{written}' is no value for {column.name}.")
    return float(match[1]), match[2].strip()


def _written(value: float, unit: str) -> str | float:
    """A number as people write it; text where it has a unit."""
    number = float(f"{value:.{_DIGITS}g}")
    return f"{text_of(number)}{unit}" if unit else int(number) if number.is_integer() else number
