# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a study: a row for each of its rows, from what is in its folder; always the same bytes."""

from __future__ import annotations

import contextlib
import csv
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.plan import planned
from BalloonWorkbench.core.studies.results import RESULTS, results_of
from BalloonWorkbench.core.studies.study import Study, written

CSV, PARQUET = "table.csv", "table.parquet"
ROW, KEY, FAILURE = "row", "key", "failure"
UNTRIED = "This balloon has not been worked out yet: start the study again."
_BLOCK = 10_000  # rows that are written to Parquet together
_DIGITS = 12  # that count

TableRow = dict[str, Any]


def table_rows(
    study: Study, folder: StudyFolder, failures: Mapping[str, str] | None = None
) -> Iterator[TableRow]:
    """The rows of the table, in the order of the study: row, key, its values, results, warnings, failure.

    failures: sentences by key about balloons that failed and whose folder does not tell. Results are None and
    the failure is not empty where there is no balloon.
    """
    for row in planned(study):
        values = {name: written(row.values.get(name)) for name in study.columns}
        report, failure = None, row.sentence
        if row.job is not None:
            report = folder.report(row.key)
            failure = "" if report else folder.failure(row.key) or (failures or {}).get(row.key, UNTRIED)
            if failure == UNTRIED and folder.has(row.key):
                failure = f"{folder.of(row.key)} is damaged: remove it and start the study again."
        yield {
            ROW: row.number,
            KEY: row.key,
            **values,
            **results_of(report or {}),
            FAILURE: failure,
        }


def headings(study: Study) -> list[str]:
    """The names of the table's columns."""
    return [ROW, KEY, *study.columns, *results_of({}), FAILURE]


def write_table(study: Study, folder: StudyFolder, failures: Mapping[str, str] | None = None) -> list[Path]:
    """Write table.csv, and table.parquet where pyarrow is there; returns their paths. Raises ExportError.

    The former ones stay until the new ones are whole.
    """
    made = []
    try:
        path = folder.place / CSV
        with _replacing(path) as part:
            _write_csv(part, headings(study), table_rows(study, folder, failures))
        made.append(path)
        with contextlib.suppress(ImportError):
            import pyarrow.parquet  # noqa: F401

            path = folder.place / PARQUET
            with _replacing(path) as part:
                _write_parquet(part, study, table_rows(study, folder, failures))
            made.append(path)
    except OSError as error:
        raise ExportError(
            f"Cannot write {folder.place / CSV}: {error.strerror or error}. Make room there and start the"
            " study again; no balloon is lost."
        ) from None
    return made


@contextlib.contextmanager
def _replacing(path: Path) -> Iterator[Path]:
    """A file beside this one that takes its place when it is whole. Raises OSError."""
    part = path.with_name(f".film-balloon-{path.name}")
    try:
        yield part
        with part.open("rb+") as file:
            os.fsync(file.fileno())
        os.replace(part, path)
    finally:
        with contextlib.suppress(OSError):
            part.unlink(missing_ok=True)


def _write_csv(path: Path, names: list[str], rows: Iterable[TableRow]) -> None:
    with path.open("w", encoding="utf-8", errors="backslashreplace", newline="") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(names)
        writer.writerows([_cell(value) for value in row.values()] for row in rows)


def _cell(value: Any) -> Any:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.{_DIGITS}g}" if isinstance(value, float) else value


def _write_parquet(path: Path, study: Study, rows: Iterator[TableRow]) -> None:
    import pyarrow
    from pyarrow import parquet

    kinds = {bool: pyarrow.bool_(), float: pyarrow.float64()}
    results = {result.name: kinds[result.kind] for result in RESULTS}
    types = {ROW: pyarrow.int64(), **results}
    schema = pyarrow.schema([(name, types.get(name, pyarrow.string())) for name in headings(study)])
    with parquet.ParquetWriter(path, schema) as writer:
        block: list[TableRow] = []
        for row in rows:
            block.append(row)
            if len(block) == _BLOCK:
                writer.write_table(pyarrow.Table.from_pylist(block, schema))
                block = []
        if block:
            writer.write_table(pyarrow.Table.from_pylist(block, schema))
