# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which balloon each row of a study is: its job, or why there is none. Nothing is worked out here."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.columns import COMMAND, DESIGN, INPUT, Value, column_named
from BalloonWorkbench.core.studies.job import Job
from BalloonWorkbench.core.studies.key import key_of
from BalloonWorkbench.core.studies.study import Row, Study, written


@dataclass(frozen=True)
class Planned:
    """A row of a study.

    number    from 1 on, in the order of the study
    values    as they were written, by column
    job       None where the row makes no sense
    sentence  why not
    """

    number: int
    values: Row
    job: Job | None
    sentence: str = ""

    @property
    def key(self) -> str:
        """The key of its balloon; empty without one."""
        return "" if self.job is None else self.job.key


def planned(study: Study) -> Iterator[Planned]:
    """The rows of a study, one after the other; several may have the same job."""
    reader = _Reader(study)
    for number, row in enumerate(study.rows, 1):
        try:
            yield Planned(number, row, reader.job(row))
        except InputError as error:
            yield Planned(number, row, None, str(error))


def distinct(
    study: Study, share: tuple[int, int] = (1, 1), senseless: dict[int, str] | None = None
) -> Iterator[Job]:
    """Each job once, in the order of the rows; share (i, n): only the i-th of n equal parts of them.

    senseless  takes sentences by number about rows that have none
    """
    seen: set[bytes] = set()
    for row in planned(study):
        if row.job is None:
            if senseless is not None:
                senseless[row.number] = row.sentence
            continue
        if (digest := bytes.fromhex(row.key)) in seen:
            continue
        if len(seen) % share[1] == share[0] - 1:
            yield row.job
        seen.add(digest)


class _Reader:
    """What the values of a study mean, each read once."""

    def __init__(self, study: Study) -> None:
        self._study = study
        self._known: dict[tuple[str, str], Value | InputError] = {}

    def job(self, row: Row) -> Job:
        """What is to be worked out for a row. Raises InputError."""
        if None in row:
            raise InputError("The row has more cells than there are columns: leave out what is too much.")
        study = self._study
        values = {name: self._value(name, row.get(name)) for name in study.columns if name not in study.own}
        place = values.pop(INPUT)
        if not place.arguments:
            raise InputError("The row has no input: give it the name of a drawing.")
        command = values.pop(COMMAND, Value()).arguments or (DESIGN,)
        meaning = {name: value.meaning for name, value in values.items()}
        named = place.meaning[0] if study.hashed else place.meaning
        own: dict[str, Any] = {INPUT: named, COMMAND: command[0], "keep": study.keep}
        arguments = [argument for value in values.values() for argument in value.arguments]
        request: dict[str, Any] = {
            "arguments": [command[0], place.arguments[0], *arguments],
            "keep": study.keep,
        }
        if study.own:
            of_task = {name: row[name] for name in study.own if row.get(name) is not None}
            request["task"] = own["task"] = {**study.shared, **of_task}
        return Job(key_of(meaning | own), request, study.task)

    def _value(self, name: str, cell: Any) -> Value:
        if cell is None or cell == "":
            return Value()
        asked = name, written(cell)
        if asked not in self._known:
            try:
                self._known[asked] = column_named(name).read(cell, self._study.folder)
            except InputError as error:
                self._known[asked] = error
        known = self._known[asked]
        if isinstance(known, InputError):
            raise known
        return known
