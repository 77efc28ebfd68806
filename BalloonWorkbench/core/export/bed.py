# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern and the bed of a machine: whether it fits, and how much smaller it has to be drawn."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.export.drawing import BAR, BAR_ROOM
from BalloonWorkbench.core.export.machine import Machine, bed_text
from BalloonWorkbench.core.pattern.motion import split
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: What becomes of a pattern that is larger than the bed: no file, the file all the same, a smaller balloon.
REFUSE, WRITE, SCALE = "refuse", "write", "scale"
OVERSIZE = (REFUSE, WRITE, SCALE)

#: A pattern is solved again so often until it fits, each time a little below what the last one lets expect.
_ROUNDS = 8
_BELOW = 0.9995
#: A balloon that has to become smaller than that is none any more.
_LEAST = 0.02


def size_on(pattern: Pattern, machine: Machine) -> Floats:
    """Width and height (2,) that a pattern takes on a machine's bed, with its bar [m]."""
    width, height = pattern.size
    if machine.control_bar and Role.REGISTRATION in machine.layers:
        width, height = max(width, from_mm(BAR)), height + from_mm(BAR_ROOM)
    return np.array([width, height])


def fits(pattern: Pattern, machine: Machine) -> bool:
    """Whether a pattern lies on a machine's bed, upright or turned by 90 degrees."""
    return fits_upright(pattern, machine) or fits_turned(pattern, machine)


def fits_upright(pattern: Pattern, machine: Machine) -> bool:
    """Whether it does as it is."""
    return machine.bed is None or bool((size_on(pattern, machine) <= machine.bed).all())


def fits_turned(pattern: Pattern, machine: Machine) -> bool:
    """Whether it does when it is turned by 90 degrees there."""
    return machine.bed is None or bool((size_on(pattern, machine)[::-1] <= machine.bed).all())


def pieces_fit(pattern: Pattern, machine: Machine) -> bool:
    """Whether each of several pieces of film lies on the bed by itself."""
    pieces = split(pattern)
    return len(pieces) > 1 and all(fits(piece, machine) for piece in pieces)


def scale_to_fit(sheet: Pattern, machines: Sequence[Machine], make: Callable[[float], Pattern]) -> float:
    """The scale of the drawing at which all that is cut fits the beds of machines; 1 where it fits already.

    make  gives the pattern of the drawing at a scale, solved anew: the weld and what is outside it stay as
          wide as they are, so that a scale can only be found by trying
    Raises ExportError where no scale does, and what `make` raises.
    """
    scale = 1.0
    for _ in range(_ROUNDS):
        step = min(
            (_step(sheet.of_stock(stock), machine) for stock in sheet.stocks for machine in machines),
            default=1.0,
        )
        if step == 1.0:
            return scale
        scale *= step
        if scale < _LEAST:
            break
        sheet = make(scale)
    beds = ", ".join(dict.fromkeys(bed_text(machine.bed) for machine in machines))
    raise ExportError(
        f"No size of the balloon fits a bed of {beds}: weld, allowance, intake and bar keep theirs. Choose"
        " another machine."
    )


def _step(part: Pattern, machine: Machine) -> float:
    """By how much a drawing must shrink: of the pattern, what the weld goes round shrinks with it."""
    if machine.bed is None or fits(part, machine):
        return 1.0
    size = size_on(part, machine)
    welds = [contour.points for contour in part.of(Role.SEAL)]
    if not welds:
        return 0.0
    points = np.concatenate(welds)
    seam = points.max(axis=0) - points.min(axis=0)
    steps = [_shrunk(np.array(bed), size, seam) for bed in (machine.bed, machine.bed[::-1])]
    return _BELOW * max(steps)


def _shrunk(bed: Floats, size: Floats, seam: Floats) -> float:
    over: Any = size > bed
    return float(np.min(np.where(over, np.maximum(bed - (size - seam), 0.0) / seam, 1.0)))
