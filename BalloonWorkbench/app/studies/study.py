# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Study object: variants of a balloon by the rows of a spreadsheet."""

from __future__ import annotations

import hashlib
import itertools
import json
import sys
from collections.abc import Mapping
from pathlib import Path

import FreeCAD as App

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_balloon, is_study, leader
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.properties.property_table import Property, result, results
from BalloonWorkbench.app.studies import study_table
from BalloonWorkbench.app.studies.document_copy import copy_of
from BalloonWorkbench.app.studies.variant import BALLOON, VALUES
from BalloonWorkbench.app.studies.varied import SHEET, own_variables, write_all
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.columns import INPUT
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Job
from BalloonWorkbench.core.studies.plan import planned
from BalloonWorkbench.core.studies.results import results_of
from BalloonWorkbench.core.studies.run import run_study
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.studies.table import FAILURE

TASK = "BalloonWorkbench.app.studies.variant"

PROPERTIES = (
    Property("Link", "Balloon", "Study", "The balloon that is varied"),
    Property("Link", "Table", "Study", "The spreadsheet: headings in its first row, a balloon in each below"),
    Property("Path", "Folder", "Study", "Folder that keeps finished balloons; empty: FreeCAD's cache folder"),
    Property(
        "Integer",
        "Jobs",
        "Study",
        "How many balloons are worked out at a time; 0: one for each processor",
        0,
    ),
    result("Link", "Shown", "The balloon of a row that was shown last", hidden=True),
    result("Integer", "Rows", "Number of balloons in the table"),
    result("Integer", "Finished", "Number of balloons that are worked out"),
    result("Integer", "Failed", "Number of balloons that cannot be made"),
    result("String", "Status", "Up to date, or what is wrong"),
)


class StudyProxy(DocumentProxy):
    """Behaviour of the Study object (App::FeaturePython). Nothing is worked out in a recompute."""

    properties = PROPERTIES

    def compute(self, obj):
        obj.Rows = len(read(obj).rows)
        status.set_status(obj, status.READY)


def make(doc, parts, variables=None, table=None, variants=None):
    """A study of a balloon and its spreadsheet: a column for each variable of a VarSet, or size and pressure.

    table     one that is there already is taken as it is
    variants  of a new one: values by what is varied, each with each of all others; or a list of balloons,
              each by its values. Raises InputError
    """
    from BalloonWorkbench.app.border import hooks

    obj = doc.addObject("App::FeaturePython", "Study")
    obj.Label = "Study"
    StudyProxy(obj)
    obj.Balloon, obj.Table = parts.balloon, table or _new_table(doc, parts, variables, variants or {})
    group = parts.balloon.getParentGroup()
    for each in (obj, obj.Table):
        if group is not None and each.getParentGroup() is None:
            group.addObject(each)
    hooks.attach_view(obj)  # last: it is shown with its group
    return obj


def read(obj) -> study_table.Table:
    """What the study's spreadsheet asks for. Raises InputError."""
    return study_table.read_table(_table(obj), _parts(obj))


def core_study(obj, table: study_table.Table) -> Study:
    """The rows that make sense, as the core's study of a copy of the document. Raises BalloonError."""
    varied = [each.key for each in table.inputs.values()]
    copy = copy_of(obj.Document, folder(obj) / "documents", _of_studies(obj.Document), varied)
    rows = [
        {INPUT: str(copy), VALUES: json.dumps(values, sort_keys=True)}
        for values in table.rows.values()
        if isinstance(values, dict)
    ]
    if not rows:
        raise InputError(f"No row of {obj.Table.Label} makes sense: {next(iter(table.rows.values()))}")
    shared = {BALLOON: obj.Balloon.Name}
    return Study(
        (INPUT, VALUES), rows, task=TASK, own=(VALUES,), shared=shared, folder=folder(obj), hashed=True
    )


def folder(obj) -> Path:
    """Where the study keeps its balloons."""
    if obj.Folder:
        return Path(obj.Folder)
    # a document has an identity of its own, which its copies keep
    name = hashlib.sha256(f"{obj.Document.Uid} {obj.Name}".encode()).hexdigest()[:16]
    return Path(App.getUserCachePath()) / "BalloonWorkbench" / "studies" / name


def jobs_of(table: study_table.Table, study: Study) -> dict[int, Job]:
    """The job of each row that makes sense, by the row's number in the spreadsheet. Raises InputError."""
    numbers = [number for number, values in table.rows.items() if isinstance(values, dict)]
    jobs = {}
    for number, row in zip(numbers, planned(study)):
        if row.job is None:
            raise InputError(row.sentence)
        jobs[number] = row.job
    return jobs


def known(table: study_table.Table, jobs: dict[int, Job], place: Path) -> dict[int, dict]:
    """What is known of each row: results by name, empty while there are none, or the failure."""
    kept, row_results = StudyFolder(place), {}
    for number, values in table.rows.items():
        if isinstance(values, str):
            row_results[number] = {FAILURE: values}
            continue
        report = kept.report(jobs[number].key)
        failure = "" if report else kept.failure(jobs[number].key)
        row_results[number] = results_of(report) if report else {FAILURE: failure} if failure else {}
    return row_results


def work_out(study: Study, obj, observe=lambda _done, _of, _last: None) -> None:
    """Work out what is not there yet. Raises BalloonError."""
    run_study(study, folder(obj), runner(obj), observe=observe)


def runner(obj, is_stopped=lambda: False):
    """The processes of this machine that a study uses, with the packages of this FreeCAD."""
    from BalloonWorkbench.core.studies.runners.subprocesses import Subprocesses

    if obj.Jobs < 0:
        raise InputError("Jobs of a study is 0 or more: 0 takes one for each processor.")
    return Subprocesses(obj.Jobs, packages=tuple(filter(None, sys.path)), is_stopped=is_stopped)


def keep_results(obj, table: study_table.Table, row_results: dict[int, dict]) -> None:
    """Write what is known into the spreadsheet, and the counts into the object."""
    study_table.write_results(obj.Table, table, row_results)
    with results(obj) as output:
        output.Rows = len(table.rows)
        output.Finished = sum(bool(values) for values in row_results.values())
        output.Failed = sum(bool(values.get(FAILURE)) for values in row_results.values())


def take_row(obj, table: study_table.Table, number: int) -> None:
    """Give the document the values of a row. Raises InputError where it makes no sense."""
    values = table.rows[number]
    if isinstance(values, str):
        raise InputError(values)
    write_all(obj.Document, values)


def _rows_of(variants) -> tuple[list, list]:
    """The headings and the rows of variants."""
    if isinstance(variants, Mapping):
        return list(variants), [*itertools.product(*variants.values())]
    headings = [*dict.fromkeys(name for values in variants for name in values)]
    return headings, [[values.get(name, "") for name in headings] for values in variants]


def variants_of(obj, table: study_table.Table) -> list[dict[str, str]]:
    """The rows as `make` takes them."""
    columns = {letters: each.heading for letters, each in table.inputs.items()}
    return [
        {
            heading: content
            for letters, heading in columns.items()
            if (content := str(obj.Table.getContents(f"{letters}{number}")))
        }
        for number in table.rows
    ]


def _of_studies(doc) -> list:
    """Objects that decide nothing about a balloon: studies, their tables, the balloons of rows."""
    own = [(obj, obj.Table, obj.Shown) for obj in filter(is_study, doc.Objects)]
    return [obj for each in own for obj in each if obj is not None]


def _table(obj):
    if obj.Table is None or obj.Table.TypeId != SHEET:
        raise InputError(f"{obj.Label} has no table: choose a spreadsheet of the document.")
    return obj.Table


def _parts(obj):
    parts = parts_of(obj.Balloon) if obj.Balloon is not None and is_balloon(obj.Balloon) else None
    if parts is None:
        raise InputError(f"{obj.Label} has no balloon: choose the one that is to be varied.")
    return parts


def _new_table(doc, parts, variables, variants):
    from BalloonWorkbench.app.studies.varied import Varied, varied

    sheet = doc.addObject(SHEET, "StudyTable")
    sheet.Label = "Study table"
    if variants:
        study_table.fill(sheet, *_rows_of(variants))
        sheet.recompute()
        return sheet
    if variables is not None:
        asked = [Varied(f"{variables.Label}.{name}", variables, name) for name in own_variables(variables)]
    else:
        asked = []
        for owner, name in ((leader(parts.outline), "Width"), (parts.balloon, "Pressure")):
            free = hasattr(owner, name) and name not in dict(owner.ExpressionEngine)
            if free and "Hidden" not in owner.getEditorMode(name):  # a sketch has its own width
                asked.append(varied(name, parts, sheet))
    study_table.fill(sheet, [each.heading for each in asked], [[each.shown() for each in asked]])
    sheet.recompute()
    return sheet
