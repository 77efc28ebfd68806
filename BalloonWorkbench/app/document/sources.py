# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon follows and cannot use: an object with an error of its own, and the balloon itself.

FreeCAD leaves out all that follows an object with an error: so that is told after the recompute.
"""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.kinds import is_source
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.core.errors import InputError


class _SourceWatch(Guarded):
    """Told by FreeCAD of each recompute."""

    def slotRecomputedDocument(self, document) -> None:
        for source in filter(is_source, document.Objects):
            _warn_of_errors(source)


_watching: list[_SourceWatch] = []


def watch() -> None:
    """Tell of errors in what balloons follow after each recompute from now on."""
    if not _watching:
        _watching.append(_SourceWatch())
        App.addDocumentObserver(_watching[0])


def _warn_of_errors(source) -> None:
    broken = next((obj for obj in source.OutList if "Invalid" in obj.State), None)
    if broken is None:
        return
    status.set_problem(source, status.has_result(source), f"{broken.Label} has an error: repair it.")
    parts = parts_of(source)
    for obj, before in zip(parts[1:], parts, strict=False) if parts else ():
        status.waits_for(obj, before, status.has_result(obj), "")


def insist_on_document(doc, source) -> None:
    """Raise InputError for an object of another document, which nothing here can follow."""
    if source.Document != doc:
        raise InputError(
            f"{source.Label} is in the document {source.Document.Label}: copy it into {doc.Label} first."
        )


def follows_itself(obj) -> bool:
    """Whether an object is among those that it is made of."""
    seen, waiting = set(), list(obj.OutList)
    while waiting:
        other = waiting.pop()
        if other == obj:
            return True
        if other not in seen:
            seen.add(other)
            waiting += other.OutList
    return False
