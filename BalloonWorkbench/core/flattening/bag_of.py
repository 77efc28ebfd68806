# SPDX-License-Identifier: LGPL-2.1-or-later
"""A divided target that has been laid flat, as a bag whose points lie alike on both sides of a seam."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.bags.opening import free_opening
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.flattening.loops import SeamSide, panel_loops
from BalloonWorkbench.core.flattening.seam_curves import smooth_line
from BalloonWorkbench.core.flattening.seam_points import with_equal_seams
from BalloonWorkbench.core.flattening.unrolled import UnrolledPanel, unrolled_panels
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on, signed_area
from BalloonWorkbench.core.geometry.triangulation import Located
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats

#: Points along a seam: so many edges on the diagonal of the body, and for any seam at least.
PER_DIAGONAL, FEWEST = 80, 4
#: Edges of a span of the smooth curve of a seam, and how far that may be from the seam, of the diagonal.
PER_SPAN, AWAY = 4.0, 2e-3
#: Points of all seams together that make areas exact, at most.
MOST_EXACT = 10_000


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


@memoized(4)
def flat_body(division: Division, *, exact: bool = False) -> FlatBody:
    """A division laid flat as it is, before any correction; exact: as bag_of. Raises what flatten raises."""
    return bag_of(division, flatten(division), exact=exact)


def bag_of(division: Division, flats: Sequence[Floats], *, exact: bool = False) -> FlatBody:
    """The bag of panels laid flat. Its opening is in the middle of a long seam, with room for an intake.

    exact  panels that unroll get so many points that their areas are exact, too
    """
    known, diagonal = unrolled_panels(division), division.target.diagonal
    counts = edge_counts(division)
    if exact:
        counts = _for_areas(division, counts, known)
    flat = np.concatenate(flats)
    space = division.target.points[division.opened.vertices]
    panels, places, ends = [], [], {}
    for number, loops in enumerate(panel_loops(division)):
        rims = [_sampled(loop, flat, counts, diagonal, known.get(number)) for loop in loops]
        order = sorted(range(len(loops)), key=lambda k: -abs(signed_area(rims[k])))
        panels.append(BagPanel(division.names[number], rims[order[0]], tuple(rims[k] for k in order[1:])))
        places.append(np.concatenate([_sampled(loops[k], space, counts, diagonal) for k in order]))
        for at, k in enumerate(order):
            ends.update(_ends(loops[k], counts, number, at))
    seams = tuple(BagSeam(ends[k, False], ends[k, True]) for k in range(len(division.seams)))
    level = with_equal_seams(Bag(tuple(panels), seams), known)
    bag = Bag(level.panels, seams, free_opening(level.panels, seams), notes=division.target.notes)
    return FlatBody(division, tuple(flats), bag, tuple(places))


def edge_counts(division: Division) -> list[int]:
    """Into how many edges each seam is parted."""
    per_length = PER_DIAGONAL / division.target.diagonal
    lengths = [length(division.target.points[seam.vertices]) for seam in division.seams]
    return [max(FEWEST, round(each * per_length)) for each in lengths]


def _for_areas(division: Division, counts: list[int], known: dict[int, UnrolledPanel]) -> list[int]:
    """At least so many edges of each seam, and so many that the areas of panels that unroll are exact."""
    needs = list(counts)
    loops = panel_loops(division)
    for number, panel in known.items():
        sides = [side for loop in loops[number] for side in loop]
        area = float(division.target.areas[division.panels == number].sum())
        for side in sides:
            needed = panel.edges_needed(side.vertices, area, len(sides))
            needs[side.seam] = max(needs[side.seam], needed)
    # very many small panels are as exact as so many points allow
    share = min(1.0, MOST_EXACT / max(sum(needs), 1))
    return [max(count, round(share * needed)) for count, needed in zip(counts, needs)]


def _sampled(
    loop: list[SeamSide],
    points: Floats,
    counts: list[int],
    diagonal: float,
    known: UnrolledPanel | None = None,
) -> Floats:
    """Points (k, d) round a loop, at equal distances along each seam; known: of a panel that unrolls."""
    parts = []
    for side in loop:
        count = counts[side.seam]
        if known is not None:
            line = known.line(side.vertices)
        else:
            most = min(count, max(FEWEST, round(length(points[side.vertices]) * PER_DIAGONAL / diagonal)))
            first = max(2, round(most / PER_SPAN))
            line = smooth_line(points[side.vertices], first, max(first, most), AWAY * diagonal)
        lengths = line_lengths(line)
        parts.append(point_on(line, lengths, np.linspace(0.0, lengths[-1], count + 1)[:-1]))
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
