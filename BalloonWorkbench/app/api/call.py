# SPDX-License-Identifier: LGPL-2.1-or-later
"""The border of the Python API, and calls that the window writes into a macro and has made itself."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from typing import TypeVar

from BalloonWorkbench.app.document.parts import Parts, parts_of
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError, InputError

_Result = TypeVar("_Result")
#: What the window has made already and a call being recorded shall return.
done: list = []


def bordered(function: Callable[..., _Result]) -> Callable[..., _Result]:
    """The function with a border: what nobody foresaw is raised as ProgramFault, from what it was.

    One that works on Parts takes any object of a balloon for them.
    """
    taken = signature(function)
    made = next((each.name for each in taken.parameters.values() if each.annotation == Parts.__name__), None)

    @wraps(function)
    def call(*positional, **named):
        bound = taken.bind(*positional, **named)  # a call that does not fit is the caller's TypeError
        try:
            if made is not None and not isinstance(bound.arguments[made], Parts):
                bound.arguments[made] = parts_with(bound.arguments[made])
            return function(*bound.args, **bound.kwargs)
        except BalloonError:
            raise
        except faults.UNFORESEEN as error:
            raise faults.report_fault(error, f"{function.__name__}: Python API") from error

    return call


def parts_with(obj) -> Parts:
    """The balloon that an object or its group belongs to; InputError for other objects."""
    balloon_parts = parts_of(obj) if hasattr(obj, "TypeId") else None
    if balloon_parts is None:
        label = getattr(obj, "Label", obj)
        raise InputError(f"{label} belongs to no balloon: choose an outline, a balloon or a pattern.")
    return balloon_parts


@contextmanager
def already_done(result):
    """Calls return this instead of working: the window has worked, and writes the call into the macro."""
    done.append(result)
    try:
        yield
    finally:
        done.pop()
