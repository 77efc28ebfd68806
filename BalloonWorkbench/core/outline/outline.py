# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline: one outer loop and its holes, in metres."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from BalloonWorkbench.core.geometry.polyline import arc_lengths, signed_area
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Outline:
    """What the user wants to see inflated.

    outer  (n, 2) m, counter-clockwise, y up, first point not repeated
    holes  each (k, 2) m, clockwise
    notes  remarks for the user made while the outline was found (specks dropped, gaps closed, ...)
    welds  open lines (k, 2) m inside, along which both films are sealed together
    spots  closed lines (k, 2) m, clockwise, whose inside is sealed: holes that are not cut out
    """

    outer: Floats
    holes: tuple[Floats, ...] = ()
    notes: tuple[str, ...] = field(default=(), compare=False)
    welds: tuple[Floats, ...] = ()
    spots: tuple[Floats, ...] = ()

    @property
    def loops(self) -> tuple[Floats, ...]:
        """The outer loop, then the holes, then the spots: where the free film ends."""
        return (self.outer, *self.holes, *self.spots)

    @property
    def area(self) -> float:
        """Area of the free film [m2]."""
        return sum(signed_area(loop) for loop in self.loops)

    @property
    def perimeter(self) -> float:
        """Length of all loops [m]."""
        return sum(float(arc_lengths(loop)[-1]) for loop in self.loops)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the bounding box [m]."""
        width, height = np.ptp(self.outer, axis=0)
        return float(width), float(height)

    def map(self, transform: Callable[[Floats], Floats]) -> Outline:
        """The outline with an orientation-keeping map of (n, 2) points applied to each loop and weld."""
        return Outline(
            transform(self.outer),
            tuple(transform(hole) for hole in self.holes),
            self.notes,
            tuple(transform(weld) for weld in self.welds),
            tuple(transform(spot) for spot in self.spots),
        )

    def with_loops(self, loops: Sequence[Floats], welds: Sequence[Floats] = ()) -> Outline:
        """Other loops, in the order of `loops`, and welds in the places of this outline's; without notes."""
        last = 1 + len(self.holes)
        return Outline(loops[0], tuple(loops[1:last]), (), tuple(welds), tuple(loops[last:]))
