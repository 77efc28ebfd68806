# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points along both sides of the seams of a bag, among all its points; panels at other points."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.flattening.equal_seams import equal_lengths
from BalloonWorkbench.core.types import Floats, Ints


def all_points(bag: Bag) -> Floats:
    """The points (p, 2) m of all loops of all panels in a row."""
    return np.concatenate([loop for panel in bag.panels for loop in panel.loops])


def at_points(bag: Bag, points: Floats) -> Bag:
    """The bag with its points, all loops in a row, at other places (p, 2) m."""
    panels, first = [], 0
    for panel in bag.panels:
        stops = first + np.cumsum([0, *map(len, panel.loops)])
        outer, *holes = (points[low:high] for low, high in pairwise(stops))
        panels.append(replace(panel, outer=outer, holes=tuple(holes)))
        first = int(stops[-1])
    return replace(bag, panels=tuple(panels))


def panel_points(bag: Bag) -> list[Ints]:
    """For each panel the numbers (k,) of the points of its loops among all."""
    counts = [sum(map(len, panel.loops)) for panel in bag.panels]
    stops = np.cumsum([0, *counts])
    return [np.arange(low, high, dtype=np.int32) for low, high in pairwise(stops)]


def seam_points(bag: Bag) -> list[tuple[Ints, Ints]]:
    """For each seam the numbers (k,) of the points along its first and second side, as sealed."""
    starts: list[list[int]] = []
    count = 0
    for panel in bag.panels:
        starts.append([])
        for loop in panel.loops:
            starts[-1].append(count)
            count += len(loop)
    return [
        (
            starts[seam.a.panel][seam.a.loop] + seam.a.points(bag.panels),
            starts[seam.b.panel][seam.b.loop] + seam.b.points(bag.panels, against=True),
        )
        for seam in bag.seams
    ]


def with_equal_seams(bag: Bag, still: Collection[int] = ()) -> Bag:
    """The bag with points moved as little as can be so that both sides of each edge of a seam are as long.

    Both sides of each seam have the same number of points. Some panels stay still: a seam between two of
    these keeps its sides.
    """
    points = all_points(bag)
    pairs = [
        np.stack([np.column_stack([side[:-1], side[1:]]) for side in sides], axis=1)
        for sides in seam_points(bag)
    ]
    counts = [sum(map(len, panel.loops)) for panel in bag.panels]
    held = np.repeat([number in still for number in range(len(counts))], counts)
    moved = equal_lengths(points[:, 0] + 1j * points[:, 1], np.concatenate(pairs), held)
    return at_points(bag, np.column_stack([moved.real, moved.imag]))
