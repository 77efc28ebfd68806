# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the panels of a bag hang together: bodies, holes through them, and the points where seams meet."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagSeam, Side
from BalloonWorkbench.core.panels.surface import first_of_each
from BalloonWorkbench.core.types import Ints


@dataclass(frozen=True)
class Topology:
    """The surface that a bag's seams make of its panels; each edge is in exactly one seam.

    bag  whose seams join loops that there are
    """

    bag: Bag

    @cached_property
    def _starts(self) -> list[list[int]]:
        """Number of the first point of each loop of each panel, all points of the bag being counted."""
        starts: list[list[int]] = []
        count = 0
        for panel in self.bag.panels:
            starts.append([])
            for loop in panel.loops:
                starts[-1].append(count)
                count += len(loop)
        return starts

    @cached_property
    def first(self) -> Ints:
        """For each point of all loops, panel by panel, the first that an end of a seam makes one with it."""
        pairs = [
            (self._number(seam.a, one), self._number(seam.b, other))
            for seam in self.bag.seams
            for one, other in ((seam.a.start, seam.b.start), (seam.a.end, seam.b.end))
        ]
        count = sum(len(loop) for panel in self.bag.panels for loop in panel.loops)
        return first_of_each(count, np.array(pairs, dtype=np.int32).reshape(-1, 2))

    def _number(self, side: Side, point: int) -> int:
        return self._starts[side.panel][side.loop] + point

    def ends(self, seam: BagSeam) -> tuple[int, int]:
        """The points in space at which a seam starts and ends, by the first point of each."""
        one, other = (int(self.first[self._number(seam.a, end)]) for end in (seam.a.start, seam.a.end))
        return one, other

    @cached_property
    def body_of(self) -> Ints:
        """For each panel the first panel of the body that it belongs to: (p,)."""
        pairs = np.array([(seam.a.panel, seam.b.panel) for seam in self.bag.seams], dtype=np.int32)
        return first_of_each(len(self.bag.panels), pairs.reshape(-1, 2))

    @property
    def bodies(self) -> int:
        """How many surfaces there are that do not hang together."""
        return len(np.unique(self.body_of))

    @cached_property
    def _meeting(self) -> tuple[Ints, Ints]:
        """The points in space at which seams end, and how many ends of seams each has."""
        ends = [end for seam in self.bag.seams for end in self.ends(seam)]
        points, counts = np.unique(np.array(ends, dtype=np.int32), return_counts=True)
        return points, counts.astype(np.int32)

    @property
    def euler_number(self) -> int:
        """Points - seams + panels, a hole taking one off its panel: 2 for a ball, 0 for a ring."""
        faces = sum(1 - len(panel.holes) for panel in self.bag.panels)
        return len(self._meeting[0]) - len(self.bag.seams) + faces

    @property
    def poles(self) -> tuple[tuple[tuple[int, int, int], ...], ...]:
        """The points in space where more than two seams meet, each as (panel, loop, point) of its corners."""
        points, counts = self._meeting
        places = [
            (number, part, point)
            for number, panel in enumerate(self.bag.panels)
            for part, loop in enumerate(panel.loops)
            for point in range(len(loop))
        ]
        order = np.argsort(self.first, kind="stable")
        ahead = self.first[order]
        poles = []
        for pole in points[counts > 2]:
            low, high = np.searchsorted(ahead, [pole, pole + 1])
            poles.append(tuple(places[k] for k in order[low:high]))
        return tuple(poles)
