# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the window plugs in: the document objects run without it, and it replaces these when it is there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD as App

from BalloonWorkbench.core.errors import BalloonError, ProgramFault


def attach_view(obj) -> None:
    """Give a document object its view provider; without a window there is none."""


def say(text: str) -> str:
    """A text of the engine in the user's language; without a window it stays English."""
    return text


def language() -> str:
    """The language of `say`, as in "de"."""
    return "en"


def report(error: BalloonError, about: str = "") -> None:
    """A line in the report view. Red or orange ones open it, so only a fault of the program is red."""
    write = App.Console.PrintError if isinstance(error, ProgramFault) else App.Console.PrintMessage
    write(f"{about}: {error}\n" if about else f"{error}\n")


def show_error(error: BalloonError) -> None:
    """Say what went wrong where nobody waits for an answer; the window says it where the user looks."""
    report(error)


def run_blocking(title: str, job: Callable[..., Any]) -> Any:
    """What job(progress) returns: work inside a recompute that takes a while and touches no document.

    With a window it runs in a thread, and can be stopped: Cancelled.
    """
    from BalloonWorkbench.core.types import no_progress

    return job(no_progress)


def ask(title: str, function, *values) -> Any:
    """What a memoized function of the engine says: at once where it is known, else as `run_blocking`."""
    if function.knows(*values):
        return function(*values)
    return run_blocking(title, lambda progress: function(*values))
