# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command study: many balloons from a table or a grid."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli import console
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import read_data
from BalloonWorkbench.core.language.speech import chosen_language
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import SAMPLE_OF_TOLERANCES, WHOLE, Finished, Runner
from BalloonWorkbench.core.studies.kinds.goal_study import GoalStudy, goal_lines, needs_rows, run_goal
from BalloonWorkbench.core.studies.kinds.tolerance_study import tolerance_summary, write_summary
from BalloonWorkbench.core.studies.page import write_page
from BalloonWorkbench.core.studies.read_study import read_goal_study, read_study
from BalloonWorkbench.core.studies.run import plan_study, run_study
from BalloonWorkbench.core.studies.runners.dask_runner import DaskRunner
from BalloonWorkbench.core.studies.runners.job_scripts import SCRIPTS
from BalloonWorkbench.core.studies.runners.subprocesses import Subprocesses
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.studies.table import write_table
from BalloonWorkbench.core.types import Say

_SHOWN = 5  # failures that are told by the command itself; the table has all


def run(options: argparse.Namespace, say: Say) -> int:
    """Do what the options say; the exit code. Raises BalloonError."""
    if options.jobs < 0 or not options.timeout > 0.0:
        raise InputError("--jobs and --timeout are numbers above 0.")
    goal = read_goal_study(options.study)
    if goal is not None:
        return _seek(goal, options, say)
    study = read_study(options.study, options.most)
    if options.keep is not None:
        study = replace(study, keep=options.keep)
    settings = _settings(options.cluster)
    if options.script is not None:
        return _show([_script(options, settings).rstrip()])
    if options.dry_run:
        return _show(_planned(study, options.out, say))
    if options.collect:
        folder = StudyFolder(options.out)
        with folder.in_use():
            return _show(_ends(study, options, write_table(study, folder), say))
    line = console.StatusLine(sys.stderr)

    def observe(done: int, of: int, _last: Finished | None) -> None:
        line.show(done / max(of, 1), say(f"balloon {done} of {of}"))

    try:
        outcome = run_study(study, options.out, _runner(options, settings), options.shard, observe)
    finally:
        line.clear()
    made, failed = outcome.made, len(outcome.failures)
    lines = _senseless(len(study.rows), outcome.senseless, say) if outcome.senseless else []
    lines += [say(f"Balloons: {outcome.balloons}, worked out now: {made}, of these failed: {failed}")]
    lines += [f"- {say(sentence)}" for sentence in [*dict.fromkeys(outcome.failures.values())][:_SHOWN]]
    if options.shard != WHOLE:
        lines.append(say("When all shards are done, --collect writes the table."))
        return _show(lines)
    return _show([*lines, *_ends(study, options, outcome.tables, say, outcome.failures)])


def _ends(
    study: Study,
    options: argparse.Namespace,
    tables: Sequence[Path],
    say: Say,
    failures: Mapping[str, str] | None = None,
) -> list[str]:
    """Lines about the whole of a study, whose tables are written; its page and summary are written too."""
    lines: list[str] = []
    folder, data = StudyFolder(options.out), None
    if study.task == SAMPLE_OF_TOLERANCES:
        data = tolerance_summary(study, folder)
    paths = [*tables, _page(study, options, say, failures, data)]
    if data is not None:
        path, lines = write_summary(folder, data)
        paths.append(path)
    return [*map(say, lines), *(say(f"Wrote {path}") for path in paths)]


def _seek(goal: GoalStudy, options: argparse.Namespace, say: Say) -> int:
    """Search for a goal, and tell what was found; the exit code."""
    if options.shard != WHOLE or options.dry_run or options.collect or options.script is not None:
        raise needs_rows()
    if options.scheduler or options.dask:
        raise InputError(
            "The search for a goal asks for a few balloons at a time, of this machine: leave out --scheduler"
            " and --dask."
        )
    line = console.StatusLine(sys.stderr)

    def observe(done: int, of: int, _last: Finished | None) -> None:
        line.show(done / of, say(f"balloon {done} of {of} at most"))

    try:
        sought = run_goal(goal, options.out, Subprocesses(options.jobs, options.timeout), observe)
    finally:
        line.clear()
    page = _page(sought.study, options, say, sought.failures)
    lines = [f"- {sentence}" for sentence in [*dict.fromkeys(sought.failures.values())][:_SHOWN]]
    return _show(
        [
            *map(say, [*goal_lines(goal, sought), *lines]),
            *(say(f"Wrote {path}") for path in (*sought.files, page)),
        ]
    )


def _page(
    study: Study,
    options: argparse.Namespace,
    say: Say,
    failures: Mapping[str, str] | None = None,
    tolerances: Mapping[str, Any] | None = None,
) -> Path:
    """Write the web page of a study."""
    title = console.readable(Path(options.study).stem).capitalize()
    language = chosen_language(options.language, os.environ)
    return write_page(study, StudyFolder(options.out), title, failures, language, say, tolerances)


def _runner(options: argparse.Namespace, settings: dict[str, Any]) -> Runner:
    if options.scheduler and options.dask:
        raise InputError("Give either --scheduler or --dask.")
    if options.scheduler or options.dask:
        return DaskRunner(options.scheduler, options.dask, options.jobs, settings, options.timeout)
    return Subprocesses(options.jobs, options.timeout)


def _script(options: argparse.Namespace, settings: dict[str, Any]) -> str:
    """The script that was asked for. Raises InputError."""
    if options.shards < 1:
        raise InputError("A script needs to know how many shards it has: give --shards a number.")
    command = ["study", os.path.abspath(options.study), "--out", os.path.abspath(options.out)]
    command += ["--timeout", f"{options.timeout:g}", "--most", str(options.most)]
    command += [] if options.keep is None else ["--keep", options.keep]
    return SCRIPTS[options.script](command, options.shards, settings)


def _settings(name: str | None) -> dict[str, Any]:
    """What the file of a cluster says. Raises InputError."""
    if name is None:
        return {}
    try:
        data = read_data(Path(name))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"'{name}' cannot be read ({reason}): name a JSON file of settings.") from None
    if not isinstance(data, dict):
        raise InputError(f"'{name}' is no JSON object: write {{\"queue\": ...}}.")
    return data


def _planned(study: Study, out: str, say: Say) -> list[str]:
    plan = plan_study(study, out)
    lines = _senseless(plan.rows, plan.senseless, say)
    return [*lines, say(f"Balloons: {plan.balloons}, of these are there: {plan.there}")]


def _senseless(rows: int, senseless: Mapping[int, str], say: Say) -> list[str]:
    lines = [say(f"Rows: {rows}, of these make no sense: {len(senseless)}")]
    return [*lines, *(say(f"Row {number}: {text}") for number, text in list(senseless.items())[:_SHOWN])]


def _show(lines: list[str]) -> int:
    return 0 if console.show("\n".join(lines) + "\n") is None else console.UNSHOWN
