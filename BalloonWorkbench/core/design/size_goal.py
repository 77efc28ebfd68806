# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large a drawing must be for a balloon of a wanted volume or lift.

A balloon s times as large holds about s^3 times as much (exactly so for film that does not stretch), its film
weighs s^2 times as much, and the border outside the seam s times. One design tells the factors; the next one
is made at the size that they foretell, and differs only by how the film stretches.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol, TypeVar

from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.drawing import GoalOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.units import length_text, mass_text, percent_text, volume_text

START_WIDTH = 0.3  # m, of a drawing whose size is to be found
TOLERANCE = 5e-3  # of the goal
SURE = 1e-3  # of what the gas carries: a lift is a difference and cannot be met better
MOST_DESIGNS = 4
SMALLEST, LARGEST = 0.01, 20.0  # larger dimension of a drawing [m]
Sized = TypeVar("Sized")
_GRID = 1.02  # sizes at which a lift is looked at before its root is narrowed down


class SizeGoal(GoalOptions):
    """What the size has to give: a volume [m3] or a lift [kg], one of them."""


@dataclass(frozen=True)
class Buoyancy:
    """What lifts and what weighs.

    lightness   density of the air less that of the gas [kg/m3]
    density     of the film [kg/m2]
    film_area   of one panel with its welds and intake [m2], for its seam
    fixed       what weighs the same at any size, such as a valve [kg]
    """

    lightness: float
    density: float
    film_area: Callable[[Outline], float]
    fixed: float = 0.0


@dataclass(frozen=True)
class Scaling:
    """A balloon and what it becomes when it is made s times as large.

    size      larger dimension of its drawing [m]
    volume    [m3], grows with s to the power of `exponent`
    inner     film inside the seams, one panel [m2]
    border    film outside the seams, one panel [m2]
    """

    size: float
    volume: float
    inner: float
    border: float
    exponent: float = 3.0

    def volume_at(self, scale: float) -> float:
        """Volume [m3]."""
        return self.volume * scale**self.exponent

    def weight_at(self, scale: float, buoyancy: Buoyancy) -> float:
        """Mass of both panels and of what does not grow [kg]."""
        film = 2.0 * buoyancy.density * (self.inner * scale**2 + self.border * scale)
        return film + buoyancy.fixed

    def lift_at(self, scale: float, buoyancy: Buoyancy) -> float:
        """What the balloon carries besides itself [kg]; below 0 it sinks."""
        return buoyancy.lightness * self.volume_at(scale) - self.weight_at(scale, buoyancy)

    def floating(self, buoyancy: Buoyancy, lift: float = 0.0) -> float | None:
        """The scale from which on the balloon carries a load [kg]; None where it would be too large."""
        scale = LARGEST / self.size
        if not self.lift_at(scale, buoyancy) > lift:
            return None
        while self.lift_at(scale / _GRID, buoyancy) > lift and scale * self.size > 1e-3 * SMALLEST:
            scale /= _GRID
        low, high = scale / _GRID, scale
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self.lift_at(middle, buoyancy) > lift else (middle, high)
        return high


class DesignAtSize(Protocol):
    """A way of designing an outline; `start` is a design of the same drawing at another size."""

    def __call__(self, outline: Outline, *, start: Design | None, progress: Progress) -> Design:
        """The design."""


def scaling_of(design: Design, buoyancy: Buoyancy) -> Scaling:
    """How a design scales."""
    inner = design.pattern.area
    return Scaling(
        max(design.target.size), design.inflation.volume, inner, buoyancy.film_area(design.pattern) - inner
    )


def foretold(outline: Outline, corrected: bool) -> Scaling:
    """How the balloon of an outline will scale, before any design: a disc, the mean of disc and strip else.

    In the closed forms of film that does not stretch, V L/A^2 is 1.748 for a disc drawn and 1.571 for a strip
    (A area, L length of the drawing's loops), 0.776 and 0.637 where the drawing is the pattern; the pattern
    has 1.72 and 1.57 times the area.
    """
    around = outline.perimeter
    shape, growth = (1.66, 1.65) if corrected else (0.70, 1.0)
    return Scaling(max(outline.size), shape * outline.area**2 / around, growth * outline.area, 0.0)


def design_to_size(
    work: DesignAtSize,
    outline: Outline,
    goal: SizeGoal,
    buoyancy: Buoyancy,
    *,
    corrected: bool = True,
    progress: Progress = no_progress,
) -> Design:
    """The design of an outline, scaled about the origin until its balloon meets the goal.

    corrected  the work corrects the pattern; else the outline is the pattern
    Raises InputError for goals that make no sense or need a balloon beyond LARGEST.
    """

    def make(scale: float, start: Design | None, progress: Progress) -> Design:
        return work(_scaled(outline, scale), start=start, progress=progress)

    known = foretold(outline, corrected)
    tried, remarks = tried_sizes(
        make, lambda design: scaling_of(design, buoyancy), known, goal, buoyancy, progress=progress
    )
    return replace(
        tried[-1],
        passes=sum(design.passes for design in tried),
        meshes=sum(design.meshes for design in tried),
        seconds=sum(design.seconds for design in tried),
        warnings=(*tried[-1].warnings, *remarks),
    )


def tried_sizes(
    make: Callable[[float, Sized | None, Progress], Sized],
    scaling: Callable[[Sized], Scaling],
    known: Scaling,
    goal: SizeGoal,
    buoyancy: Buoyancy,
    *,
    progress: Progress = no_progress,
) -> tuple[list[Sized], tuple[str, ...]]:
    """The designs at several sizes, of which the last one meets the goal, and remarks where it does not.

    make     designs at a scale, from the design at another one
    scaling  how a design scales; known: how the first one is expected to, at scale 1
    Raises InputError for goals that make no sense or need a balloon beyond LARGEST.
    """
    _check(goal, buoyancy)
    tried: list[Sized] = []
    scale = 1.0
    for trial in range(MOST_DESIGNS):
        scale *= _step(known, goal, buoyancy)
        tried.append(make(scale, tried[-1] if tried else None, _part(progress, trial)))
        before, known = known, scaling(tried[-1])
        if _miss(known, goal, buoyancy) <= TOLERANCE:
            break
        ratio = math.log(known.size / before.size)
        if trial and abs(ratio) > 1e-3:
            exponent = math.log(known.volume / before.volume) / ratio
            known = replace(known, exponent=min(max(exponent, 2.5), 3.5))
    return tried, _remarks(known, goal, buoyancy)


def _scaled(outline: Outline, scale: float) -> Outline:
    return outline.map(lambda loop: loop * scale)


def _check(goal: SizeGoal, buoyancy: Buoyancy) -> None:
    if (goal.volume is None) == (goal.lift is None):
        raise InputError("Give either a volume or a lift as the goal.")
    if goal.volume is not None and not (math.isfinite(goal.volume) and goal.volume > 0.0):
        raise InputError(f"A volume of {volume_text(goal.volume)} cannot be made: give one such as 10l.")
    if goal.lift is not None:
        if not (math.isfinite(goal.lift) and goal.lift >= 0.0):
            raise InputError(f"A lift of {mass_text(goal.lift)} cannot be made: give one such as 5g.")
        if buoyancy.lightness <= 0.0:
            raise InputError(
                "This gas is not lighter than the air around, so the balloon never floats: choose another gas"
                " or a higher temperature of the gas."
            )


def _step(known: Scaling, goal: SizeGoal, buoyancy: Buoyancy) -> float:
    """The scale that should meet the goal."""
    if goal.volume is not None:
        scale = (goal.volume / known.volume) ** (1.0 / known.exponent)
        if not SMALLEST <= scale * known.size <= LARGEST:
            raise InputError(
                f"For {volume_text(goal.volume)} the drawing would be {length_text(scale * known.size)}"
                f" large: choose a volume that makes it {length_text(SMALLEST)} to {length_text(LARGEST)}."
            )
        return scale
    assert goal.lift is not None
    scale = known.floating(buoyancy, goal.lift)
    if scale is None:
        most = known.lift_at(LARGEST / known.size, buoyancy)
        raise InputError(
            f"A lift of {mass_text(goal.lift)} is out of reach: {length_text(LARGEST)} large, this balloon"
            " would"
            f" {'carry' if most > 0.0 else 'lack'} {mass_text(abs(most))}. Choose a lighter film or gas, a"
            " smaller lift, or a rounder shape."
        )
    if scale * known.size < SMALLEST:
        raise InputError(f"The drawing would be smaller than {length_text(SMALLEST)}: choose a larger lift.")
    return scale


def _miss(known: Scaling, goal: SizeGoal, buoyancy: Buoyancy) -> float:
    """How far the goal is missed, relative to it, and to what the gas carries where the lift is small."""
    if goal.volume is not None:
        return abs(known.volume / goal.volume - 1.0)
    assert goal.lift is not None
    carried = buoyancy.lightness * known.volume
    return abs(known.lift_at(1.0, buoyancy) - goal.lift) / max(goal.lift, carried * SURE / TOLERANCE)


def _remarks(known: Scaling, goal: SizeGoal, buoyancy: Buoyancy) -> tuple[str, ...]:
    miss = _miss(known, goal, buoyancy)
    if miss <= TOLERANCE:
        return ()
    what = "volume" if goal.volume is not None else "lift"
    return (f"The {what} is {percent_text(miss)} off its goal: change the goal by as much.",)


def _part(progress: Progress, number: int) -> Progress:
    """Progress of one design within the search, which needs two or three of them."""
    before = 1.0 - 0.3**number
    return lambda fraction, text: progress(
        before + 0.7 * 0.3**number * fraction, f"size {number + 1}, {text}"
    )
