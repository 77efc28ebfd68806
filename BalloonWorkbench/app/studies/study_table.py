# SPDX-License-Identifier: LGPL-2.1-or-later
"""The spreadsheet of a study: headings, a row a variant below them, results written beside these."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import product
from typing import Any, NamedTuple

from BalloonWorkbench.app.studies.varied import UNITS, Varied, varied
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.results import RESULTS, WARNINGS
from BalloonWorkbench.core.studies.table import FAILURE

MOST_ROWS = 10_000  # a spreadsheet of FreeCAD has 16 384
#: The columns of a new study.
USUAL = ("volume_m3", "thickness_mm", "safe_pressure_Pa", "weight_g", "lift_g", "error_mean_mm", FAILURE)
_RESULTS = (*(result.name for result in RESULTS), WARNINGS, FAILURE)


class Table(NamedTuple):
    """What a spreadsheet asks for.

    inputs   what is varied, by the letters of its column
    results  names of results, by the letters of theirs
    rows     the number of each row in the spreadsheet, and its values by `Varied.key`; a text is why not
    """

    inputs: dict[str, Varied]
    results: dict[str, str]
    rows: dict[int, dict[str, Any] | str]


def read_table(sheet, parts) -> Table:
    """Read a spreadsheet; an empty cell is the value that the document has. Raises InputError."""
    columns, last = _extent(sheet)
    headings = {letters: str(content).strip() for letters in columns if (content := _cell(sheet, letters, 1))}
    results = {letters: text for letters, text in headings.items() if text in _RESULTS}
    inputs = {
        letters: varied(text, parts, sheet) for letters, text in headings.items() if letters not in results
    }
    if not inputs:
        raise InputError(
            f"Nothing varies in {sheet.Label}: write into its first row what does, such as Width."
        )
    keys = [each.key for each in inputs.values()]
    twice = next((each for each in inputs.values() if keys.count(each.key) > 1), None)
    if twice is not None:
        raise InputError(f"{sheet.Label} has two columns for {twice.heading}: leave one out.")
    rows: dict[int, dict[str, Any] | str] = {}
    for number in range(2, last + 1):
        cells = {letters: _cell(sheet, letters, number) for letters in inputs}
        if any(cell is not None for cell in cells.values()):
            rows[number] = _values(inputs, cells)
    if not rows:
        raise InputError(f"{sheet.Label} has no rows: write the values of each balloon below the headings.")
    _check_count(len(rows))
    return Table(inputs, results, rows)


def write_results(sheet, table: Table, results: dict[int, dict[str, Any]]) -> None:
    """Write what is known into the columns of results: by the number of the row, then by name."""
    for number, values in results.items():
        for letters, name in table.results.items():
            text, address = _written(values.get(name)), f"{letters}{number}"
            if text != sheet.getContents(address):
                sheet.set(address, text)


def fill(sheet, inputs: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
    """Give a new spreadsheet headings, usual results among them, and rows of values. Raises InputError."""
    _check_count(len(rows))
    for number, values in enumerate([[*inputs, *USUAL], *rows], 1):
        for column, value in enumerate(values):
            sheet.set(f"{_letters(column)}{number}", str(value))


def spread(each: Varied, first: str, last: str, count: int) -> list[str]:
    """Evenly spaced values of a property as the cells of a table, both ends among them. Raises InputError."""
    low, high = each.read(first), each.read(last)
    if isinstance(low, (str, bool)):
        raise InputError(f"{each.heading} is no number: write its values into the table.")
    unit = UNITS.get(each.kind, "")
    values = [low + (high - low) * number / max(count - 1, 1) for number in range(count)]
    if each.kind == "Integer":
        values = [*dict.fromkeys(round(value) for value in values)]
    return [f"={value:.9g} {unit}".rstrip() for value in values]


def cross(sheet, table: Table, letters: str, values: Sequence[str]) -> None:
    """Each row with each of these values in one column, in place of the rows. Raises InputError."""
    others = [name for name in table.inputs if name != letters]
    rows = dict.fromkeys(
        tuple(sheet.getContents(f"{name}{number}") for name in others) for number in table.rows
    )
    _check_count(len(rows) * len(values))
    for number in table.rows:
        for name in (*table.inputs, *table.results):
            sheet.set(f"{name}{number}", "")
    for number, (row, value) in enumerate(product(rows, values), 2):
        for name, content in zip((*others, letters), (*row, value)):
            sheet.set(f"{name}{number}", content)


def _check_count(rows: int) -> None:
    if rows > MOST_ROWS:
        raise InputError(f"The study has {rows} rows, more than {MOST_ROWS}: take fewer values.")


def _values(inputs: dict[str, Varied], cells: dict[str, Any]) -> dict[str, Any] | str:
    """The values of a row, or the sentence on what is wrong with it."""
    try:
        return {
            each.key: each.present() if cells[letters] is None else each.read(cells[letters])
            for letters, each in inputs.items()
        }
    except InputError as error:
        return str(error)


def _extent(sheet) -> tuple[list[str], int]:
    """The letters of the columns that have something in them, from the left, and the last row."""
    used = re.findall(r'address="([A-Z]+)(\d+)"', sheet.cells.Content)
    columns = sorted({letters for letters, _ in used}, key=lambda letters: (len(letters), letters))
    return columns, max((int(row) for _, row in used), default=0)


def _cell(sheet, letters: str, row: int):
    """What a cell has; None for nothing."""
    try:
        value = sheet.get(f"{letters}{row}")
    except (ValueError, AttributeError):
        return None
    return None if isinstance(value, str) and not value.strip() else value


def _letters(number: int) -> str:
    """The name of a column, from 0 on."""
    first, last = divmod(number, 26)
    return (_letters(first - 1) if first else "") + chr(ord("A") + last)


def _written(value) -> str:
    if value is None or value == "":
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.6g}" if isinstance(value, (int, float)) else f"'{value}"
