# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawing: all of its shapes, each one balloon, in their places."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.geometry.crossings import box_pairs, contains, first_crossing
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.outline.welds import spot
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import place_text

#: A separate shape below this share of the largest one's area is a speck: it is dropped.
SPECK = 0.01


@dataclass(frozen=True)
class Drawing:
    """Outlines in one plane, the largest first, each the outline of a balloon of its own.

    Remarks on the drawing as a whole are with the notes of the first one.

    canvas  lower left and upper right corner (2, 2) m of the picture it was traced in; None: there is none
    """

    parts: tuple[Outline, ...]
    canvas: Floats | None = field(default=None, compare=False)

    @property
    def largest(self) -> Outline:
        """The outline that encloses most."""
        return self.parts[0]

    @property
    def notes(self) -> tuple[str, ...]:
        """The remarks of all parts."""
        return tuple(note for part in self.parts for note in part.notes)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the bounding box [m]."""
        width, height = np.ptp(np.concatenate([part.outer for part in self.parts]), axis=0)
        return float(width), float(height)

    def map(self, transform: Callable[[Floats], Floats]) -> Drawing:
        """The drawing with an orientation-keeping map of (n, 2) points applied to each loop."""
        canvas = None if self.canvas is None else transform(self.canvas)
        return Drawing(tuple(part.map(transform) for part in self.parts), canvas)


def checked(drawing: Drawing, budget: Budget | None = None) -> Drawing:
    """The drawing with each outline checked, see `check`; OutlineError also where two of them meet."""
    budget = budget or Budget()
    parts = tuple(check(part, budget) for part in drawing.parts)
    every = [loop for part in parts for loop in part.loops]
    place = first_crossing(every, (), budget.check_time) if len(parts) > 1 else None
    if place is not None:
        raise OutlineError(f"Two shapes meet at {place_text(place)}; part them, or join them into one.")
    return Drawing(parts, drawing.canvas)


def arranged(loops: Sequence[Floats], notes: Sequence[str] = (), budget: Budget | None = None) -> Drawing:
    """The drawing that closed loops (n, 2) of any sense make: what lies in a shape is a hole of it, what lies
    in a hole is a shape again. Specks are dropped; the remarks then say so.
    """
    budget = budget or Budget()
    loops = sorted(loops, key=lambda loop: -abs(signed_area(loop)))
    smaller = _overlapped(loops, budget)
    around: list[list[int]] = [[] for _ in loops]
    holes: dict[int, list[Floats]] = {}
    for number, loop in enumerate(loops):
        budget.check_time()
        shapes = [other for other in around[number] if other in holes]
        if len(around[number]) % 2 and shapes:
            holes[shapes[-1]].append(loop)
        else:
            holes[number] = []
        for inner in _within(loop, loops, smaller[number], number in holes):
            around[inner].append(number)
    least = SPECK * abs(signed_area(loops[0]))
    sizeable = [number for number in holes if not _is_speck(loops[number], least, budget)]
    remarks = (*notes, *speck_note(len(holes) - len(sizeable)))
    return Drawing(
        tuple(Outline(loops[number], tuple(holes[number]), () if number else remarks) for number in sizeable)
    )


def _is_speck(loop: Floats, least: float, budget: Budget) -> bool:
    """Whether a loop is smaller than an area [m2]; the lobes of one that crosses itself take from each other,
    and what is drawn is never dropped for that."""
    if abs(signed_area(loop)) >= least:
        return False
    return bool(
        np.prod(np.ptp(loop, axis=0)) < least or first_crossing([loop], (), budget.check_time) is None
    )


def with_welds(drawing: Drawing, welds: Sequence[Floats], budget: Budget | None = None) -> Drawing:
    """The drawing with welds in the shapes in which they lie; a remark tells of those that lie in none.

    welds: lines (n, 2) m; one whose first point is repeated at the end is a spot, and so is a single point
    """
    inside: list[list[Floats]] = [[] for _ in drawing.parts]
    astray = 0
    budget = budget or Budget()
    for weld in welds:
        budget.check_time()
        owners = [
            number
            for number, part in enumerate(drawing.parts)
            if contains(part.outer, weld).any() and not any(contains(hole, weld).all() for hole in part.holes)
        ]
        if owners:
            inside[owners[-1]].append(weld)
        else:
            astray += 1
    parts = [sealed(part, mine) for part, mine in zip(drawing.parts, inside, strict=True)]
    if astray:
        note = f"{astray} weld{'s' * (astray > 1)} outside the shapes left out."
        parts[0] = replace(parts[0], notes=(*parts[0].notes, note))
    return Drawing(tuple(parts))


def sealed(outline: Outline, welds: Sequence[Floats]) -> Outline:
    """The outline with welds added, told apart as in `with_welds`."""
    lines, spots = list(outline.welds), list(outline.spots)
    for weld in welds:
        if len(weld) == 1:
            spots.append(spot(weld[0]))
        elif len(weld) > 3 and np.array_equal(weld[0], weld[-1]):
            spots.append(weld[:-1])
        else:
            lines.append(weld)
    return replace(outline, welds=tuple(lines), spots=tuple(spots))


def speck_note(count: int) -> list[str]:
    """The remark that so many specks were dropped."""
    return [f"{count} small speck{'s were' if count > 1 else ' was'} dropped."] if count else []


def _overlapped(loops: Sequence[Floats], budget: Budget) -> list[list[int]]:
    """For each loop the later ones whose bounding boxes overlap its own, in order."""
    low = np.array([loop.min(axis=0) for loop in loops])
    high = np.array([loop.max(axis=0) for loop in loops])
    later: list[list[int]] = [[] for _ in loops]
    for one, two in box_pairs(low, high, budget.check_time):
        for first, second in zip(np.minimum(one, two).tolist(), np.maximum(one, two).tolist()):
            later[first].append(second)
    return [sorted(numbers) for numbers in later]


def _within(outer: Floats, loops: Sequence[Floats], numbers: list[int], shape: bool) -> list[int]:
    """Those of the loops with these numbers that lie in another one, which is a shape or a hole.

    One that crosses a shape counts as its hole, one that crosses a hole does not lie in it: the check for
    crossings then tells the user where.
    """
    if not numbers:
        return []
    starts = np.cumsum([0, *(len(loops[number]) for number in numbers[:-1])])
    inside = contains(outer, np.concatenate([loops[number] for number in numbers]))
    lying = (np.logical_or if shape else np.logical_and).reduceat(inside, starts)
    return [number for number, lies in zip(numbers, lying) if lies]
