# SPDX-License-Identifier: LGPL-2.1-or-later
"""Valid outlines: loops cleaned, oriented and checked, and brought to a size."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar

import numpy as np

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.cleaning import clean
from BalloonWorkbench.core.geometry.crossings import box_pairs, contains, first_crossing
from BalloonWorkbench.core.geometry.polyline import extent, oriented, perimeter, signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.welds import valid_welds
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, place_text

SMALLEST = 1e-3
"""Smallest width or height of an outline [m]."""
LARGEST = 100.0
"""Largest width or height of an outline [m]."""

# Points nearer than this, relative to the size of the outline, are one point: 0.3 um on a balloon of 300 mm.
_SAME_POINT = 1e-6
# Area of a loop, relative to the square of its length, below which it encloses nothing (0.08 for a circle).
_NO_AREA = 1e-9


Sized = TypeVar("Sized", bound="HasSize")


class HasSize(Protocol):
    """An outline, or a drawing of several."""

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the bounding box [m]."""

    def map(self: Sized, transform: Callable[[Floats], Floats], /) -> Sized:
        """It with a map of (n, 2) points applied to each loop."""


def check(outline: Outline, budget: Budget | None = None) -> Outline:
    """The outline with repeated points and spikes removed, outer loop counter-clockwise, holes clockwise.

    OutlineError where a loop is empty, not finite, without area, crosses or touches itself or another one,
    where a hole is not inside the outer loop, or a weld not in the film; the text gives the place in
    millimetres.
    """
    if not all(np.isfinite(line).all() for line in (*outline.loops, *outline.welds)):
        raise OutlineError("The outline has a coordinate that is not a number; correct it in the drawing.")
    budget = budget or Budget()
    tolerance = _SAME_POINT * extent(outline.outer) if len(outline.outer) else 0.0
    cleaned = []
    for loop in outline.loops:
        budget.check_time()
        cleaned.append(clean(loop, tolerance))
    kinds = ["outline", *["hole"] * len(outline.holes), *["closed weld"] * len(outline.spots)]
    _check_crossings(cleaned, kinds, budget)
    signs = [1, *[-1] * (len(cleaned) - 1)]
    outer, *holes = (_turned(*each) for each in zip(cleaned, signs, kinds))
    cut, spots = tuple(holes[: len(outline.holes)]), tuple(holes[len(outline.holes) :])
    if holes:
        _check_places(outer, holes, budget)
    welds = valid_welds(outline.welds, (outer, *holes), tolerance, budget)
    return Outline(outer, cut, outline.notes, welds, spots)


def _check_places(outer: Floats, holes: Sequence[Floats], budget: Budget) -> None:
    """OutlineError for a hole outside the outer loop or in another hole; none of them cross."""
    places = np.array([hole[0] for hole in holes])
    outside = ~contains(outer, places)
    low = np.array([hole.min(axis=0) for hole in holes])
    high = np.array([hole.max(axis=0) for hole in holes])
    inner = np.zeros(len(holes), dtype=np.bool_)
    for one, two in box_pairs(low, high, budget.check_time):
        for small, large in ((one, two), (two, one)):
            boxed = ((low[large] <= low[small]) & (high[small] <= high[large])).all(axis=1)
            for hole, other in zip(small[boxed].tolist(), large[boxed].tolist()):
                budget.check_time()
                inner[hole] |= contains(holes[other], holes[hole][:1])[0]
    wrong = np.flatnonzero(outside | inner)
    if len(wrong):
        place = place_text(places[wrong[0]])
        if outside[wrong[0]]:
            raise OutlineError(f"The hole at {place} lies outside the outline; move it inside.")
        raise OutlineError(f"The hole at {place} lies in another hole; remove one of them.")


def _check_crossings(loops: Sequence[Floats], kinds: Sequence[str], budget: Budget) -> None:
    """OutlineError where one of the loops of these kinds crosses itself, or two of them meet."""
    whole = [(loop, kind) for loop, kind in zip(loops, kinds) if len(loop) > 2]
    meeting = first_crossing([loop for loop, _ in whole], (), budget.check_time) if whole else None
    if meeting is None:
        return
    for loop, kind in whole:
        crossing = first_crossing([loop], (), budget.check_time)
        if crossing is not None:
            raise OutlineError(
                f"The {kind} crosses or touches itself at {place_text(crossing)}; part the lines there."
            )
    raise OutlineError(
        f"A hole meets the outline or another hole at {place_text(meeting)}; keep some film between them."
    )


def _turned(loop: Floats, sign: int, kind: str) -> Floats:
    """The loop with an area of the given sign; OutlineError where it has none."""
    area = signed_area(loop) if len(loop) > 2 else 0.0
    if abs(area) <= _NO_AREA * perimeter(loop) ** 2:
        raise OutlineError(f"The {kind} encloses no area; draw a closed shape with at least three corners.")
    return oriented(loop, sign > 0)


def scale_to(outline: Sized, width: float | None, height: float | None) -> Sized:
    """The outline scaled about the origin to a width or height [m]; inside both where both are given.

    InputError for sizes that are not numbers or outside SMALLEST to LARGEST, also those the outline has
    brought along.
    """
    for name, target in (("width", width), ("height", height)):
        if target is not None and not _is_makable(target):
            raise InputError(
                f"A {name} of {length_text(target)} cannot be made; choose one between 1 mm and 100 m."
            )
    own = outline.size
    if min(own) <= 0:
        raise OutlineError("The outline encloses no area; draw a closed shape with at least three corners.")
    factors = [target / have for target, have in zip((width, height), own) if target is not None]
    factor = min(factors, default=1.0)
    for name, have in zip(("width", "height"), own):
        if not _is_makable(have * factor):
            raise InputError(
                f"The outline's {name} of {length_text(have * factor)} cannot be made; bring it to a size"
                " between"
                " 1 mm and 100 m."
            )
    return outline if factor == 1.0 else outline.map(lambda loop: loop * factor)


def _is_makable(size: float) -> bool:
    return SMALLEST * (1 - 1e-9) <= size <= LARGEST * (1 + 1e-9)
