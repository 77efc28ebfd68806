# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study with a goal: rows are worked out as the search asks for them, and kept as those of any study."""

from __future__ import annotations

import contextlib
import json
import queue
import threading
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import Cancelled, ExportError, InputError
from BalloonWorkbench.core.files.write import write_files
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Finished, Job, Runner
from BalloonWorkbench.core.studies.kinds.goal import Goal, read_goal
from BalloonWorkbench.core.studies.kinds.search import MOST_TRIALS, Trial, best, search
from BalloonWorkbench.core.studies.plan import planned
from BalloonWorkbench.core.studies.results import results_of
from BalloonWorkbench.core.studies.run import Observe
from BalloonWorkbench.core.studies.study import Row, Study, written
from BalloonWorkbench.core.studies.table import write_table
from BalloonWorkbench.core.units import number_text, pressure_text

GOAL = "goal"
FILE = "goal.json"
#: Seconds until searches are seen to have ended, and for which others may ask for more.
_WAIT, _TOGETHER = 0.1, 0.02
_AT_END = 0.01  # of a range


@dataclass(frozen=True)
class GoalStudy:
    """A goal, what all balloons have, and from which folder files are looked for."""

    goal: Goal
    fixed: Row
    folder: Path

    @property
    def columns(self) -> tuple[str, ...]:
        """Of its table."""
        chosen = dict.fromkeys((*self.goal.choices[0], *self.goal.ranges))
        return (*(name for name in self.fixed if name not in chosen), *chosen)

    def study(self, rows: list[Row]) -> Study:
        """The study that these rows make."""
        return Study(self.columns, rows, folder=self.folder)

    @property
    def most(self) -> int:
        """Not more balloons than these are tried."""
        return len(self.goal.choices) * (MOST_TRIALS if self.goal.ranges else 1)


@dataclass(frozen=True)
class Sought:
    """What the search for a goal ended with.

    study    whose rows are all that was tried, each a trial
    best     within the limits, or nearest to them; None where no balloon could be made
    reached  it is within all limits
    made     how many balloons were worked out now; failures: sentences by key; files: what was written
    """

    study: Study
    trials: tuple[Trial, ...]
    best: Trial | None
    reached: bool
    made: int
    failures: dict[str, str]
    files: tuple[Path, ...]


def goal_study(data: Mapping[str, Any], fixed: Row, folder: Path) -> GoalStudy:
    """The study that {"fixed": {...}, "goal": {...}} declares. Raises InputError."""
    study = GoalStudy(read_goal(data[GOAL], folder), fixed, folder)
    study.study([{}])  # whether there is an input shows before the work
    return study


def run_goal(
    study: GoalStudy, out: str | Path, runner: Runner, observe: Observe = lambda _done, _of, _last: None
) -> Sought:
    """Search for the goal; write the table of all that was tried, and goal.json.

    Balloons that are in the folder are not worked out again: the same search asks for the same ones. Raises
    as run_study does.
    """
    folder = StudyFolder(out)
    with folder.in_use():
        desk = _Desk(study, folder)
        searches = [_Search(study.goal, choice, desk) for choice in study.goal.choices]
        with ThreadPoolExecutor(len(searches)) as threads:
            futures = [threads.submit(one.run) for one in searches]
            for future in futures:
                future.add_done_callback(desk.search_ended)
            try:
                while batch := desk.next_jobs(len(futures)):
                    with contextlib.closing(runner.run(batch, folder.place)) as finished:
                        for last in finished:
                            desk.answer(last)
                            observe(desk.made, study.most, last)
            finally:
                desk.close()
        trials = tuple(trial for future in futures for trial in future.result())
        rows = study.study([{**study.fixed, **each.values} for each in trials])
        tables = write_table(rows, folder, desk.failures)
        top = best(study.goal, list(trials))
        reached = top is not None and study.goal.lack(top.results or {}) == 0.0
        text = json.dumps(
            _goal_data(study, trials, top, reached), indent=2, ensure_ascii=False, allow_nan=False
        )
        write_files(folder.place, {FILE: (text + "\n").encode()})
    return Sought(rows, trials, top, reached, desk.made, desk.failures, (*tables, folder.place / FILE))


@dataclass(frozen=True)
class _Search:
    """The search for one choice, in a thread of its own."""

    goal: Goal
    choice: Row
    desk: _Desk

    def run(self) -> list[Trial]:
        return search(self.goal, self.choice, self.desk.evaluate)


@dataclass
class _Desk:
    """Between the searches, which wait for balloons, and the runner, which makes them."""

    study: GoalStudy
    folder: StudyFolder
    made: int = 0
    failures: dict[str, str] = field(default_factory=dict)
    _asked: queue.SimpleQueue[Job] = field(default_factory=queue.SimpleQueue)
    _waiting: dict[str, Future[None]] = field(default_factory=dict)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _ended: int = 0
    _closed: bool = False

    def evaluate(self, values: Row) -> Mapping[str, Any] | None:
        """The results of a balloon, when it is there; None where it cannot be made. Cancelled at the end."""
        (row,) = planned(self.study.study([{**self.study.fixed, **values}]))
        if row.job is None:
            return None
        if not self.folder.has(row.key):
            with self._lock:
                if self._closed:
                    raise Cancelled("The search was stopped; what was made stays.")
                if row.key not in self._waiting:
                    self._waiting[row.key] = Future()
                    self._asked.put(row.job)
                waiting = self._waiting[row.key]
            waiting.result()
        report = self.folder.report(row.key)
        return None if report is None else results_of(report)

    def next_jobs(self, searches: int) -> list[Job]:
        """What is asked for by now, at least one; none when all searches have ended.

        Not a generator for the runner: its threads would wait in it when the work is stopped.
        """
        batch: list[Job] = []
        while not batch and self._ended < searches:
            with contextlib.suppress(queue.Empty):
                batch.append(self._asked.get(timeout=_WAIT))
                while True:
                    batch.append(self._asked.get(timeout=_TOGETHER))
        return batch

    def search_ended(self, _search: Future[list[Trial]]) -> None:
        """One search asks no more."""
        with self._lock:
            self._ended += 1

    def answer(self, last: Finished) -> None:
        """Let the search that waits for a balloon go on. Raises ExportError where none can."""
        if not self.folder.is_there():
            raise self.folder.vanished()
        if last.ends:
            raise ExportError(last.sentence)
        self.made += 1
        if last.sentence:
            self.failures[last.key] = last.sentence
        self._waiting[last.key].set_result(None)

    def close(self) -> None:
        """Let all searches end."""
        with self._lock:
            self._closed = True
            for waiting in self._waiting.values():
                if not waiting.done():
                    waiting.set_exception(Cancelled("The search was stopped; what was made stays."))


def _goal_data(
    study: GoalStudy, trials: tuple[Trial, ...], top: Trial | None, reached: bool
) -> dict[str, Any]:
    """What goal.json tells."""
    goal = study.goal
    return {
        "sense": goal.sense,
        "result": goal.column,
        "limits": [limit.text for limit in goal.limits],
        "tried": len(trials),
        "failed": sum(trial.results is None for trial in trials),
        "reached": reached,
        "values": None if top is None else {name: written(value) for name, value in top.values.items()},
        "results": None if top is None else dict(top.results or {}),
        "at_an_end": [] if top is None else at_an_end(goal, top),
    }


def at_an_end(goal: Goal, top: Trial) -> list[str]:
    """The columns whose value is at an end of their range: a wider one may hold a better balloon."""
    pairs = zip(goal.ranges, top.shares, strict=True)
    return [name for name, share in pairs if min(share, 1.0 - share) < _AT_END]


def goal_lines(study: GoalStudy, sought: Sought) -> list[str]:
    """What was found, as sentences."""
    goal, top, count = study.goal, sought.best, len(sought.trials)
    if top is None or top.results is None:
        return [f"None of {count} balloons could be made: the table says why."]
    values = ", ".join(f"{name} {written(value)}" for name, value in top.values.items())
    has = f"{goal.column} {number_text(float(top.results[goal.column]), 4)}"
    ends = [
        f"{name} is at an end of its range: a wider one may hold a better balloon."
        for name in at_an_end(goal, top)
    ]
    ends += _overfilled(top.results)
    if sought.reached:
        return [f"Best of {count} balloons: {values}, with {has}.", *ends]
    missed = ", ".join(
        f"{limit.text} but {_value(top.results.get(limit.column))}"
        for limit in goal.limits
        if limit.lack(top.results) > 0.0
    )
    return [
        f"None of {count} balloons is within the limits; the nearest: {values}, asked for {missed}.",
        *ends,
    ]


def _overfilled(results: Mapping[str, Any]) -> list[str]:
    """A sentence where a balloon is filled above its safe pressure."""
    pressure, safe = results.get("pressure_Pa"), results.get("safe_pressure_Pa")
    if pressure is None or safe is None or pressure <= safe:
        return []
    return [
        f"It is filled to {pressure_text(pressure)}, its safe pressure is {pressure_text(safe)}:"
        " fill it less."
    ]


def _value(value: Any) -> str:
    return "nothing known" if value is None else number_text(float(value), 4)


def needs_rows() -> InputError:
    """What to raise where the rows of a goal would have to be known before."""
    return InputError(
        "The search for a goal finds its balloons one after the other: leave out --shard, --script,"
        " --dry-run and --collect; what is there already is not made again."
    )
