# SPDX-License-Identifier: LGPL-2.1-or-later
"""A row of a study of a document: its balloon with other values, in a process beside FreeCAD."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from BalloonWorkbench.core.errors import InputError, MissingPackageError

BALLOON, VALUES = "balloon", "values"
#: The file of the inflated balloon.
MESH = "balloon.stl"


def make(request: Mapping[str, Any]) -> dict[str, bytes]:
    """The report of a variant, and its mesh. Raises BalloonError.

    request  arguments: the document's file as the last; task: the name of the balloon, and values by
             `Varied.key`
    """
    try:
        import FreeCAD as App
    except ImportError as error:
        raise MissingPackageError(
            f"FreeCAD does not start beside this one ({error}): install it for the Python that runs there."
        ) from None
    task = request["task"]
    doc = App.openDocument(request["arguments"][-1], True)
    try:
        return _files(doc, doc.getObject(task[BALLOON]), json.loads(task[VALUES]))
    finally:
        App.closeDocument(doc.Name)


def _files(doc, balloon, values: Mapping[str, Any]) -> dict[str, bytes]:
    from BalloonWorkbench.app.border import status
    from BalloonWorkbench.app.document.parts import parts_of
    from BalloonWorkbench.app.engine import film_result, maker
    from BalloonWorkbench.app.studies.varied import write_all
    from BalloonWorkbench.core.job import report_bytes
    from BalloonWorkbench.core.making.numbers import numbers_report
    from BalloonWorkbench.core.results.stl import stl_bytes
    from BalloonWorkbench.core.studies.folder import REPORT
    from BalloonWorkbench.core.studies.results import without_times

    balloon.Live = True
    write_all(doc, dict(values))
    doc.recompute()
    parts = parts_of(balloon)
    for obj in parts:
        if not status.is_ready(obj):
            raise InputError(status.problem(obj))
    report = json.loads(balloon.Report)
    report["maker"] = {**numbers_report(maker.numbers(parts)), **report.get("maker", {})}
    inflation, _ = film_result.stored(balloon)
    return {REPORT: report_bytes(without_times(report)), MESH: stl_bytes([inflation])}
