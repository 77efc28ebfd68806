# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern and the bed of a machine: whether it fits, and how much smaller it has to be drawn."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.machines.machine import Machine, bed_text
from BalloonWorkbench.core.machines.toolpaths import BAR, BAR_ROOM, has_bar, reach
from BalloonWorkbench.core.options.making import REFUSE, SCALE, SPLIT, WRITE
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.placement import split
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

OVERSIZE = (REFUSE, WRITE, SCALE, SPLIT)

#: A pattern is solved again so often until it fits, each time a little below what the last one lets expect.
_ROUNDS = 8
_BELOW = 0.9995
#: A balloon that has to become smaller than that is none any more.
_LEAST = 0.02


def size_on(pattern: Pattern, machine: Machine) -> Floats:
    """Width and height (2,) that a pattern takes on a machine's bed, with bar and room for the tool [m]."""
    low, high = reach(pattern, machine)
    width, height = high - low
    if pattern.page is not None:
        width, height = np.maximum((width, height), pattern.page[1] - pattern.page[0])
    if has_bar(pattern, machine):
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
    scale, before = 1.0, None
    for _ in range(_ROUNDS):
        steps = [
            _step(sheet.of_stock(stock), machine, before and (scale / before[0], before[1].of_stock(stock)))
            for stock in sheet.stocks
            for machine in machines
        ]
        step = min(steps, default=1.0)
        if step == 1.0:
            return scale
        before = scale, sheet
        scale *= step
        if scale < _LEAST:
            break
        sheet = make(scale)
    beds = ", ".join(dict.fromkeys(bed_text(machine.bed) for machine in machines))
    raise ExportError(
        f"No size of the balloon fits a bed of {beds}: weld, allowance, intake and control bar keep their"
        " sizes. Choose another machine."
    )


def _step(part: Pattern, machine: Machine, before: tuple[float, Pattern] | None) -> float:
    """By how much a drawing must shrink: of the pattern, what the weld goes round shrinks with it.

    before  by how much it has shrunk the last time, and the pattern then: pieces beside each other have welds
            and gaps between them that do not shrink
    """
    if machine.bed is None or fits(part, machine):
        return 1.0
    size = size_on(part, machine)
    welds = [contour.points for contour in part.of(Role.SEAL)]
    if not welds:
        return 0.0
    points = np.concatenate(welds)
    shrinks = points.max(axis=0) - points.min(axis=0)
    if before is not None:
        by, larger = before
        measured = (size_on(larger, machine) - size) * by / (1.0 - by)
        shrinks = np.where((measured > 0.0) & (measured < shrinks), measured, shrinks)
    steps = [_shrunk(np.array(bed), size, shrinks) for bed in (machine.bed, machine.bed[::-1])]
    return _BELOW * max(steps)


def _shrunk(bed: Floats, size: Floats, shrinks: Floats) -> float:
    over: Any = size > bed
    return float(np.min(np.where(over, np.maximum(bed - (size - shrinks), 0.0) / shrinks, 1.0)))
