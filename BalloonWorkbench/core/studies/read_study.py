# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies from files: a table (CSV), or a grid, samples or rows (JSON)."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import parse_data
from BalloonWorkbench.core.files.user_file import read_whole
from BalloonWorkbench.core.studies.axes import Axis, Between, axis_of
from BalloonWorkbench.core.studies.columns import column_named
from BalloonWorkbench.core.studies.job import MOST_ROWS, REPORT
from BalloonWorkbench.core.studies.kinds.goal_study import GOAL, GoalStudy, goal_study
from BalloonWorkbench.core.studies.kinds.tolerance_study import COUNT, SEEDED, TOLERANCES, tolerance_study
from BalloonWorkbench.core.studies.study import Grid, Row, SampledRows, Study, check_count, points_of

_LARGEST = 1 << 30  # bytes
FIXED, VARY, SAMPLE, ROWS, KEEP = "fixed", "vary", "sample", "rows", "keep"


def read_study(path: str | Path, most: int = MOST_ROWS) -> Study:
    """A study from a file: .csv is a table with a row a balloon, anything else JSON as `study_of` takes it.

    Files are looked for from its folder. Raises InputError: for a column that is not known, for more rows
    than most, for what cannot be read. A row that makes no sense is found when it is planned.
    """
    path = Path(path)
    content = read_whole(path, _LARGEST)
    folder = path.resolve().parent
    if path.suffix.lower() == ".csv":
        return _table(path.name, content, folder, most)
    return study_of(_data(path.name, content), folder, most)


def read_goal_study(path: str | Path) -> GoalStudy | None:
    """The study of a file that declares a goal, see `goal_study`; None for any other. Raises InputError."""
    path = Path(path)
    data = None if path.suffix.lower() == ".csv" else _data(path.name, read_whole(path, _LARGEST))
    if not isinstance(data, Mapping) or GOAL not in data:
        return None
    _check_names(data, (FIXED, GOAL))
    return goal_study(data, _named(data.get(FIXED, {}), FIXED), path.resolve().parent)


def study_of(data: Mapping[str, Any], folder: Path, most: int = MOST_ROWS) -> Study:
    """A study from what its JSON says:

    {"fixed": {"material": "mylar"}, "vary": {"input": {"glob": "*.png"}, "width": ["200mm", "300mm"]},
     "sample": {"kind": "latin-hypercube", "rows": 100, "seed": 1}, "keep": "report"}

    Without "sample" each value is taken with each other; "rows" in the place of "vary" lists rows.
    Raises InputError, MissingPackageError.
    """
    if not isinstance(data, Mapping):
        raise InputError('The study is no JSON object: begin it with {"vary": ...}.')
    if TOLERANCES in data:
        _check_names(data, (FIXED, TOLERANCES, COUNT, SEEDED))
        return tolerance_study(data, _named(data.get(FIXED, {}), FIXED), folder)
    _check_names(data, (FIXED, VARY, SAMPLE, ROWS, KEEP))
    if (VARY in data) == (ROWS in data):
        raise InputError(f'Give a study either "{VARY}" or "{ROWS}".')
    fixed = _named(data.get(FIXED, {}), FIXED)
    keep = data.get(KEEP, REPORT)
    if ROWS in data:
        return _listed(data[ROWS], fixed, keep, folder, most)
    axes = {
        name: axis_of(column_named(name), value, folder) for name, value in _named(data[VARY], VARY).items()
    }
    fixed = {name: value for name, value in fixed.items() if name not in axes}
    if SAMPLE in data:
        rows: Grid | SampledRows = _samples(data[SAMPLE], fixed, axes, most)
    else:
        rows = _grid(fixed, axes, most)
    return Study((*fixed, *axes), rows, keep, folder)


def _check_names(data: Mapping[str, Any], known: Sequence[str]) -> None:
    strange = [str(name) for name in data if name not in known]
    if strange:
        raise InputError(f"A study has no '{strange[0]}': it has {', '.join(known[:-1])} and {known[-1]}.")


def _data(name: str, content: bytes) -> Any:
    try:
        return parse_data(content.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise InputError(f"'{name}' is no text in UTF-8: save it as one.") from None
    except ValueError as error:
        place = f", line {error.lineno}" if isinstance(error, json.JSONDecodeError) else ""
        raise InputError(f"'{name}' is no JSON ({getattr(error, 'msg', error)}{place}).") from None


def _named(data: Any, part: str) -> dict[str, Any]:
    """Values by the names of their columns."""
    if not isinstance(data, Mapping):
        raise InputError(f'"{part}" of the study is no JSON object: write {{"width": ...}}.')
    named: dict[str, Any] = {}
    for name, value in data.items():
        column = column_named(name).name
        if column in named:
            raise InputError(f"The study has the column {column} twice.")
        named[column] = value
    return named


def _grid(fixed: Row, axes: Mapping[str, Axis], most: int) -> Grid:
    open_ones = [name for name, axis in axes.items() if isinstance(axis, Between)]
    if open_ones:
        raise InputError(f'{open_ones[0]} runs between two ends: say how to take samples in "{SAMPLE}".')
    grid = Grid(fixed, {name: axis for name, axis in axes.items() if not isinstance(axis, Between)})
    count = 1
    for axis in grid.axes.values():
        count *= len(axis)
    check_count(count, most)
    return grid


def _samples(data: Any, fixed: Row, axes: Mapping[str, Axis], most: int) -> SampledRows:
    if not isinstance(data, Mapping) or set(data) - {"kind", "rows", "seed"}:
        raise InputError(
            f'"{SAMPLE}" cannot be read: write {{"kind": "latin-hypercube", "rows": 100, "seed": 1}}.'
        )
    rows, seed = data.get("rows"), data.get("seed", 0)
    for name, value in (("rows", rows), ("seed", seed)):
        if not isinstance(value, int) or isinstance(value, bool) or value < (name == "rows"):
            raise InputError(f'"{name}" of "{SAMPLE}" is no whole number: write one.')
    assert isinstance(rows, int)
    check_count(rows, most)
    if not axes:
        raise InputError(f'Nothing varies: give "{VARY}" a column.')
    return SampledRows(fixed, axes, points_of(str(data.get("kind", "")), rows, len(axes), seed))


def _listed(data: Any, fixed: Row, keep: str, folder: Path, most: int) -> Study:
    if not isinstance(data, list) or not all(isinstance(each, Mapping) for each in data):
        raise InputError(f'"{ROWS}" of the study is no list of JSON objects: write [{{"input": ...}}, ...].')
    check_count(len(data), most)
    rows = [{**fixed, **_named(each, ROWS)} for each in data]
    names = dict.fromkeys(name for each in rows for name in each)
    return Study(tuple(names), rows, keep, folder)


def _table(name: str, content: bytes, folder: Path, most: int) -> Study:
    """A table as spreadsheets write it, with commas, semicolons or tabs."""
    check_count(content.count(b"\n") - 1, most)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"'{name}' is no text in UTF-8: save the table as CSV in UTF-8.") from None
    heading = text.partition("\n")[0]
    delimiter = max(",;\t", key=heading.count)
    try:
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))
    except csv.Error as error:
        raise InputError(f"'{name}' is no table ({error}): save it as CSV.") from None
    names = [*_named(dict.fromkeys(lines[0]), name)] if lines else []
    if lines and len(names) < len(lines[0]):
        raise InputError(f"'{name}' has a column twice.")
    rows = [_cells(names, line) for line in lines[1:] if any(cell.strip() for cell in line)]
    return Study(tuple(names), rows, REPORT, folder)


def _cells(names: list[str], line: list[str]) -> Row:
    row: dict[Any, Any] = {each: cell.strip() for each, cell in zip(names, line, strict=False)}
    if any(cell.strip() for cell in line[len(names) :]):
        row[None] = line[len(names) :]
    return row
