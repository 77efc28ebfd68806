# SPDX-License-Identifier: LGPL-2.1-or-later
"""A divided target that has been laid flat, as a bag whose points lie alike on both sides of a seam."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.bags.opening import free_opening
from BalloonWorkbench.core.flattening.loops import SeamSide, panel_loops
from BalloonWorkbench.core.flattening.seam_curves import smooth_line
from BalloonWorkbench.core.flattening.seam_points import with_equal_seams
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on, signed_area
from BalloonWorkbench.core.geometry.triangulation import Located
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats

#: Points along a seam: so many edges on the diagonal of the body, and for any seam at least.
PER_DIAGONAL, FEWEST = 80, 4
#: Edges of a span of the smooth curve of a seam, and how far that may be from the seam, of the diagonal.
PER_SPAN, AWAY = 4.0, 2e-3


@dataclass(frozen=True)
class FlatBody:
    """A division, its panels laid flat, and their bag.

    flats   for each panel the places (k, 2) m of its opened vertices
    bag     seam i of the bag is seam i of the division; both sides have their points at equal fractions
    places  for each panel the places (points, 3) m of its points on the target
    """

    division: Division
    flats: tuple[Floats, ...]
    bag: Bag
    places: tuple[Floats, ...]

    def on_target(self, meshed: MeshedBag) -> Floats:
        """Where the vertices (n, 3) m of a mesh lie on the target: of the bag, or of it with points moved."""
        opened, division = self.division.opened, self.division
        parts = []
        for number, flat in enumerate(self.flats):
            first, last = np.searchsorted(opened.panels, [number, number + 1])
            triangles = opened.triangles[division.panels == number] - first
            points = division.target.points[opened.vertices[first:last]]
            before = meshed.weights[number] @ np.concatenate(self.bag.panels[number].loops)
            at = Located(flat, triangles).values(points, before)
            rim = meshed.rims[number].places(self.places[number])
            at[: len(rim)] = rim
            parts.append(at)
        return np.concatenate(parts)


def bag_of(division: Division, flats: Sequence[Floats]) -> FlatBody:
    """The bag of panels laid flat. Its opening is in the middle of a long seam, with room for an intake."""
    counts, diagonal = edge_counts(division), division.target.diagonal
    flat = np.concatenate(flats)
    space = division.target.points[division.opened.vertices]
    panels, places, ends = [], [], {}
    for number, loops in enumerate(panel_loops(division)):
        rims = [_sampled(loop, flat, counts, diagonal) for loop in loops]
        order = sorted(range(len(loops)), key=lambda k: -abs(signed_area(rims[k])))
        panels.append(BagPanel(division.names[number], rims[order[0]], tuple(rims[k] for k in order[1:])))
        places.append(np.concatenate([_sampled(loops[k], space, counts, diagonal) for k in order]))
        for at, k in enumerate(order):
            ends.update(_ends(loops[k], counts, number, at))
    seams = tuple(BagSeam(ends[k, False], ends[k, True]) for k in range(len(division.seams)))
    level = with_equal_seams(Bag(tuple(panels), seams))
    bag = Bag(level.panels, seams, free_opening(level.panels, seams), notes=division.target.notes)
    return FlatBody(division, tuple(flats), bag, tuple(places))


def edge_counts(division: Division) -> list[int]:
    """Into how many edges each seam is parted."""
    per_length = PER_DIAGONAL / division.target.diagonal
    lengths = [length(division.target.points[seam.vertices]) for seam in division.seams]
    return [max(FEWEST, round(each * per_length)) for each in lengths]


def _sampled(loop: list[SeamSide], points: Floats, counts: list[int], diagonal: float) -> Floats:
    """Points (k, d) round a loop, at equal distances along each seam."""
    parts = []
    for side in loop:
        count = counts[side.seam]
        first = max(2, round(count / PER_SPAN))
        line = smooth_line(points[side.vertices], first, max(first, count), AWAY * diagonal)
        lengths = line_lengths(line)
        parts.append(point_on(line, lengths, np.linspace(0.0, lengths[-1], counts[side.seam] + 1)[:-1]))
    return np.concatenate(parts)


def _ends(loop: list[SeamSide], counts: list[int], panel: int, number: int) -> dict[tuple[int, bool], Side]:
    """The sides of seams round a loop of a panel, in the direction of the seams."""
    around = sum(counts[side.seam] for side in loop)
    sides, at = {}, 0
    for side in loop:
        begin, end = at, (at + counts[side.seam]) % around
        at += counts[side.seam]
        sides[side.seam, side.second] = Side(panel, *((end, begin) if side.second else (begin, end)), number)
    return sides
