# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bag: flat panels by their points, and which stretch of which loop is sealed to which."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.types import Floats, Ints


@dataclass(frozen=True)
class BagPanel:
    """A flat piece of film, seen from outside the balloon.

    outer  (n, 2) m, counter-clockwise
    holes  (k, 2) m each, clockwise
    cut    False: it only closes an open end in the simulation, and is not made of film
    """

    name: str
    outer: Floats
    holes: tuple[Floats, ...] = ()
    cut: bool = True

    @property
    def loops(self) -> tuple[Floats, ...]:
        """The outer loop, then the holes; the film is to the left of all of them."""
        return (self.outer, *self.holes)


@dataclass(frozen=True)
class Side:
    """A stretch of a loop, from one of its points to another; of a seam's second side it runs backwards.

    panel       number of the panel
    start, end  numbers of points of the loop
    loop        0 the outer one, then the holes
    """

    panel: int
    start: int
    end: int
    loop: int = 0

    def points(self, panels: tuple[BagPanel, ...], *, against: bool = False) -> Ints:
        """Numbers of the loop's points from start to end, (k,), k >= 2; against: in its other direction."""
        count = len(panels[self.panel].loops[self.loop])
        step = -1 if against else 1
        ahead = (step * (self.end - self.start) - 1) % count + 1  # all of it where start is end
        return np.asarray((self.start + step * np.arange(ahead + 1)) % count, dtype=np.int32)


@dataclass(frozen=True)
class BagSeam:
    """Two sides that are sealed together: a runs along the loop of its panel, b against the loop of its own.

    Both run the same way in space, so that start lies on start and end on end.
    """

    a: Side
    b: Side

    @property
    def sides(self) -> tuple[Side, Side]:
        """Both."""
        return self.a, self.b


@dataclass(frozen=True)
class Opening:
    """Where the bag is filled: the edge of a panel that begins at a point of its outer loop."""

    panel: int
    at: int


@dataclass(frozen=True)
class Bag:
    """Panels and seams; each edge of each loop is in exactly one seam.

    opening  None: the bag has no opening
    ease     how much longer one side of a seam may be than the other, as a part of its length; 0 as usual;
             beside a panel that is not cut it does not matter
    notes    one sentence each, for the user
    """

    panels: tuple[BagPanel, ...]
    seams: tuple[BagSeam, ...]
    opening: Opening | None = None
    ease: float = 0.0
    notes: tuple[str, ...] = ()

    def ease_of(self, seam: BagSeam) -> float:
        """That of a seam, as a part of its length."""
        return self.ease if all(self.panels[side.panel].cut for side in seam.sides) else 1.0
