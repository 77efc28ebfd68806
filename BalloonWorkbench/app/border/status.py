# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an object tells about itself: up to date, or why not.

Exceptions that leave `execute()` make FreeCAD print a traceback; a user's mistake deserves a
sentence instead. So the sentence goes into the property Status and the object keeps what it had.
"""

from __future__ import annotations

from contextlib import contextmanager

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults

READY = "up to date"
STALE = "stale: "  # what is shown belongs to earlier values
EMPTY = "empty: "  # there is nothing to show yet
UNSURE = "not converged: "  # shown, but not an equilibrium
_WAITING = " is not ready: "


def is_ready(obj) -> bool:
    """The object's result belongs to its present values and can be built upon."""
    return obj.Status == READY or obj.Status.startswith(UNSURE)


def problem(obj) -> str:
    """Why the object is not ready, without the leading word; empty when it is."""
    if is_ready(obj):
        return ""
    for word in (STALE, EMPTY):
        if obj.Status.startswith(word):
            return obj.Status[len(word) :]
    return obj.Status


def has_result(obj) -> bool:
    """Something is shown, as the object's own words tell."""
    return bool(obj.Status) and not obj.Status.startswith(EMPTY)


def set_status(obj, text: str) -> None:
    """Write Status only when it changes, so that nothing is touched for nothing."""
    if obj.Status != text:
        obj.Status = text


def set_problem(obj, has_result: bool, text: str) -> None:
    """Mark the object: its values cannot be used; what it shows is kept."""
    set_status(obj, (STALE if has_result else EMPTY) + text)


def waits_for(obj, source, has_result: bool, missing: str) -> bool:
    """Mark `obj` when the object that it is made from is absent or not ready."""
    if source is None:
        set_problem(obj, has_result, missing)
    elif not is_ready(source):
        # what the source waits for itself is said once
        cause = problem(source)
        set_problem(obj, has_result, cause if _WAITING in cause else source.Label + _WAITING + cause)
    else:
        return False
    return True


@contextmanager
def reported(obj, has_result: bool):
    """Turn an error into a status and one line of the report view; a fault has its details in a file."""
    try:
        yield
    except faults.UNFORESEEN as error:
        known = faults.as_balloon_error(error, f"{obj.Name}: recompute")
        set_problem(obj, has_result, str(known))
        hooks.report(known, obj.Label)
