# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the vertices along the seams of a bag lie: at equal fractions of the lengths of both sides."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, Side
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import line_lengths, perimeter
from BalloonWorkbench.core.types import Floats, Ints

#: A turn within about an edge length that makes a corner, which keeps a vertex [rad].
_CORNER = np.radians(30.0)
#: Corners of both sides so near to each other, as a part of the length, are one.
_ONE = 1e-3


def side_line(bag: Bag, side: Side, *, against: bool) -> Floats:
    """The points (k, 2) along a side, in the direction of its seam."""
    return bag.panels[side.panel].loops[side.loop][side.points(bag.panels, against=against)]


def divisions(bag: Bag, sizes: Sequence[float]) -> list[Floats]:
    """For each seam the fractions (k,), from 0 to 1, of its length at which its vertices lie.

    sizes  wanted length of edges on each panel [m]; a seam takes the smaller of its two
    """
    sharp = [
        [
            corners(loop, _CORNER, reach=min(0.6 * size, perimeter(loop) / 8.0)).astype(np.int32)
            for loop in panel.loops
        ]
        for panel, size in zip(bag.panels, sizes)
    ]
    topology = Topology(bag)
    ends = [topology.ends(seam) for seam in bag.seams]
    beside = Counter(map(frozenset, ends))
    every = []
    for seam, (start, end) in zip(bag.seams, ends):
        size = min(sizes[side.panel] for side in seam.sides)
        lines = [side_line(bag, seam.a, against=False), side_line(bag, seam.b, against=True)]
        stops = _stops(bag, seam.sides, lines, sharp)
        # seams that share both ends, or close to a ring, must not fall on one another
        least = 3 if start == end else 2 if beside[frozenset((start, end))] > 1 else 1
        length = max(float(line_lengths(line)[-1]) for line in lines)
        counts = np.maximum(np.rint(np.diff(stops) * length / size), 1.0).astype(np.int32)
        if counts.sum() < least:
            counts += -(-least // len(counts)) - 1
        pieces = [
            np.linspace(low, high, count, endpoint=False)
            for (low, high), count in zip(pairwise(stops), counts)
        ]
        every.append(np.concatenate([*pieces, [1.0]]))
    return every


def _stops(bag: Bag, sides: Sequence[Side], lines: Sequence[Floats], sharp: list[list[Ints]]) -> list[float]:
    """Fractions at which there is a vertex anyway: the ends, and the corners of both sides."""
    fractions = []
    for side, line, against in zip(sides, lines, (False, True)):
        lengths = line_lengths(line)
        kept = np.isin(side.points(bag.panels, against=against), sharp[side.panel][side.loop])
        fractions += (lengths[kept] / lengths[-1]).tolist()
    stops = [0.0]
    for fraction in sorted(fractions):
        if fraction - stops[-1] > _ONE and fraction < 1.0 - _ONE:
            stops.append(fraction)
    return [*stops, 1.0]
