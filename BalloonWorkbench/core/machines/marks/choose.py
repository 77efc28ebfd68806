# SPDX-License-Identifier: LGPL-2.1-or-later
"""For which machine a print has its marks: it can have those of one only."""

from __future__ import annotations

from collections.abc import Sequence

from BalloonWorkbench.core.machines.machine import Machine, machine
from BalloonWorkbench.core.machines.marks.style import CROSSES, Marks


def marks_for(name: str | None, asked: Sequence[Machine] = ()) -> Marks:
    """Those of the machine of a name; without one those of the first asked for that looks for marks itself.

    None where the programs of all that are asked for have their own. InputError where there is no such
    machine.
    """
    if name:
        return machine(name).marks
    looked_for = [each.marks for each in asked]
    others = CROSSES if not looked_for or any(marks.are_seen for marks in looked_for) else looked_for[0]
    return next((marks for marks in looked_for if marks.are_found), others)


def other_marks(marks: Marks, asked: Sequence[Machine]) -> tuple[str, ...]:
    """A sentence for each machine that looks for other marks than a print has."""
    has = "crosses for the eye" if marks.are_seen else f"the marks of {marks.owner[0]}"
    return tuple(
        f"The print has {has}, and {each.title} looks for others: print once more with its marks"
        f" ({each.name})."
        for each in asked
        if each.marks.are_found and each.marks != marks
    )
