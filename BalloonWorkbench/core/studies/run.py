# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole study: what is not there yet is worked out, then its table is written."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import WHOLE, Finished, Job, Runner
from BalloonWorkbench.core.studies.plan import distinct, planned
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.studies.table import write_table


@dataclass(frozen=True)
class Planning:
    """What a study will do.

    rows       how many it has
    senseless  sentences by the number of the row, of those that make no sense
    balloons   how many differ
    there      how many of these are in the folder already
    """

    rows: int
    senseless: dict[int, str]
    balloons: int
    there: int


@dataclass(frozen=True)
class Outcome:
    """What a study did.

    balloons  how many belong to it, or to its share
    made      how many of them were worked out now, failures too
    senseless sentences by number about the rows of the study that make no sense
    failures  sentences by key about those that failed now
    tables    the paths of its table; none for a share
    """

    balloons: int
    made: int
    senseless: dict[int, str]
    failures: dict[str, str] = field(default_factory=dict)
    tables: tuple[Path, ...] = ()


#: Told after each balloon: how many are done, of how many, and the last one, None at the beginning.
Observe = Callable[[int, int, Finished | None], None]


def plan_study(study: Study, out: str | Path) -> Planning:
    """Look at a study without working anything out."""
    folder, senseless, keys, rows = StudyFolder(out), {}, set(), 0
    for row in planned(study):
        rows += 1
        if row.job is None:
            senseless[row.number] = row.sentence
        else:
            keys.add(bytes.fromhex(row.key))
    there = sum(folder.has(key.hex()) for key in keys)
    return Planning(rows, senseless, len(keys), there)


def run_study(
    study: Study,
    out: str | Path,
    runner: Runner,
    share: tuple[int, int] = WHOLE,
    observe: Observe = lambda _done, _of, _last: None,
) -> Outcome:
    """Work out what a study's folder lacks, and write its table; a share (i, n) of it writes none.

    A balloon that fails is a row with its sentence. Raises InputError where another study runs in the folder,
    ExportError where it cannot be written to or vanished, and what the runner raises; what was made stays,
    and the same call goes on from there.
    """
    if not 1 <= share[0] <= share[1]:
        raise InputError(f"There is no share {share[0]} of {share[1]}: write one from 1/{share[1]} on.")
    folder = StudyFolder(out)
    with folder.in_use(share):
        senseless: dict[int, str] = {}
        balloons = sum(1 for _ in distinct(study, share, senseless))
        there = 0

        def missing() -> Iterator[Job]:
            nonlocal there
            for job in distinct(study, share):
                if folder.has(job.key):
                    there += 1
                else:
                    yield job

        made, failures = 0, {}
        observe(0, balloons, None)
        with contextlib.closing(runner.run(missing(), folder.place)) as finished:
            for last in finished:
                made += 1
                _check(last, folder)
                if last.sentence:
                    failures[last.key] = last.sentence
                observe(there + made, balloons, last)
        tables = tuple(write_table(study, folder, failures)) if share == WHOLE else ()
    return Outcome(balloons, made, senseless, failures, tables)


def _check(last: Finished, folder: StudyFolder) -> None:
    """Raise ExportError where the study cannot go on."""
    if not folder.is_there():
        raise folder.vanished()
    if last.ends:
        raise ExportError(last.sentence)
