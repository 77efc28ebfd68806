# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of an assembly: panels side by side, which of their vertices are one, and whether they fit."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import length_text

#: Both sides of a seam are equally long within the larger of these: a part of the length, and metres.
RELATIVE_EASE, EASE = 1e-3, 3e-4

Edge = tuple[int, int]


@dataclass(frozen=True)
class Surface:
    """What the panels of an assembly make together.

    rest_positions  (n, 2) m, all panels side by side in a row, as on the roll
    triangles       (m, 3) of all panels, counter-clockwise seen from outside
    first           (n,) for each vertex the first of those that are one with it
    by_seams        (n,) the same without the welds inside
    turned          (p,) whether a panel lies with its other side out: it is mirrored in rest_positions
    bodies          how many surfaces there are that do not hang together
    """

    rest_positions: Floats
    triangles: Ints
    first: Ints
    by_seams: Ints
    turned: Bools
    bodies: int

    @property
    def euler_number(self) -> int:
        """Vertices - edges + triangles where all seams are given: 2 for a ball, 0 for a ring."""
        return len(np.unique(self.by_seams)) - len(self.triangles) // 2  # two triangles to an edge

    @property
    def poles(self) -> Ints:
        """The vertices, by the first of each, in which three corners of panels or more meet."""
        vertices, counts = np.unique(self.by_seams, return_counts=True)
        return vertices[counts > 2]


def checked_surface(
    panels: Sequence[Panel], seams: Sequence[Seam], welds: Sequence[Seam], mirror: bool
) -> Surface:
    """The surface of an assembly. Raises AssemblyError with what does not fit."""
    if not panels:
        raise AssemblyError("There is no panel. Give at least one.")
    for number, panel in enumerate(panels, 1):
        _check_panel(panel, number, may_turn=mirror)
    turned = np.zeros(len(panels), dtype=bool)
    bodies = 1
    if not mirror:
        for number, seam in enumerate((*seams, *welds), 1):
            _check_sides(panels, seam, number)
        senses = _senses(panels, seams)
        turned, bodies = _orientation(len(panels), seams, senses)
    offsets = np.cumsum([0, *(len(panel.rest_positions) for panel in panels)])
    triangles = outward_triangles([panel.triangles for panel in panels], turned, offsets)
    by_seams = first_of_each(int(offsets[-1]), _pairs(seams, offsets))
    glued = by_seams[triangles]
    if seams and np.any(glued == np.roll(glued, 1, axis=1)):
        raise AssemblyError("A seam closes an edge of a triangle to a point. Check which runs it joins.")
    first = first_of_each(int(offsets[-1]), _pairs((*seams, *welds), offsets)) if welds else by_seams
    return Surface(_side_by_side(panels, turned), triangles, first, by_seams, turned, bodies)


def outward_triangles(triangles: Sequence[Ints], turned: Bools, offsets: Sequence[int] | Ints) -> Ints:
    """The triangles of all panels (m, 3), numbered from the offset of each; reversed in those turned over."""
    sides = [(part[:, ::-1] if over else part) + at for part, over, at in zip(triangles, turned, offsets)]
    return np.concatenate(sides).astype(np.int32)


def _check_panel(panel: Panel, number: int, *, may_turn: bool) -> None:
    """Each triangle has an area and runs counter-clockwise, each vertex has a triangle.

    may_turn  as in a quick preview, whose coarse panel may overlap itself a little
    """
    corners, count = panel.triangles.ravel(), len(panel.rest_positions)
    if len(corners) and not 0 <= corners.min() <= corners.max() < count:
        raise AssemblyError(f"Panel {number} has a triangle with a vertex that is not there. Mesh it anew.")
    if not len(corners) or not np.bincount(corners, minlength=count).all():
        raise AssemblyError(f"Panel {number} has a vertex without triangles. Mesh it anew.")
    area, least = signed_areas(panel.rest_positions, panel.triangles), 1e-12 * panel.size**2
    bad = np.flatnonzero(~(np.abs(area) > 0.0) if may_turn else ~(area > least))
    if len(bad) and area[bad[0]] < -least:
        raise AssemblyError(f"Triangle {bad[0] + 1} of panel {number} runs clockwise. Mesh the panel anew.")
    if len(bad):
        raise AssemblyError(f"Triangle {bad[0] + 1} of panel {number} has no area. Mesh the panel anew.")


def _check_sides(panels: Sequence[Panel], seam: Seam, number: int) -> None:
    """Both sides of a seam have equally many vertices, at equal lengths along them."""
    for run in seam.runs:
        if not 0 <= run.panel < len(panels):
            raise AssemblyError(
                f"Seam {number} is along a panel {run.panel + 1}, but there are {len(panels)}."
            )
        if (
            len(run.vertices) < 2
            or not np.isin(run.vertices, np.arange(len(panels[run.panel].rest_positions))).all()
        ):
            raise AssemblyError(f"Seam {number} is along vertices that panel {run.panel + 1} does not have.")
    first, second = (len(run.vertices) for run in seam.runs)
    if first != second:
        raise AssemblyError(
            f"Seam {number} joins {first} vertices to {second}. Divide both sides into equally many parts."
        )
    one, other = (_lengths_along(panels[run.panel], run) for run in seam.runs)
    ease = max(max(RELATIVE_EASE, seam.ease) * max(one[-1], other[-1]), EASE)
    if abs(one[-1] - other[-1]) > ease:
        raise AssemblyError(
            f"The sides of seam {number} are {length_text(one[-1])} and {length_text(other[-1])} long."
            " Make them equally long."
        )
    if np.abs(one - other).max() > ease:
        raise AssemblyError(
            f"The vertices along both sides of seam {number} are up to"
            f" {length_text(float(np.abs(one - other).max()))} apart. Put them at equal lengths along it."
        )


def _lengths_along(panel: Panel, run: Run) -> Floats:
    steps = np.linalg.norm(np.diff(panel.rest_positions[run.vertices], axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _boundary(panel: Panel, number: int) -> set[Edge]:
    """Edges of one triangle alone, in its direction."""
    ahead = np.concatenate([panel.triangles[:, [k, (k + 1) % 3]] for k in range(3)]).tolist()
    edges = {(start, end) for start, end in ahead}
    if len(edges) < len(ahead):
        raise AssemblyError(f"Panel {number} has an edge with more than two triangles. Mesh it anew.")
    return {(start, end) for start, end in edges if (end, start) not in edges}


def _senses(panels: Sequence[Panel], seams: Sequence[Seam]) -> list[tuple[int, int]]:
    """For both sides of each seam: 1 along the boundary counter-clockwise, -1 the other way round.

    Raises AssemblyError for a side off the boundary, and where a piece of it is in no seam or in two.
    """
    boundaries = [_boundary(panel, number) for number, panel in enumerate(panels, 1)]
    seam_of: dict[tuple[int, Edge], int] = {}
    senses = []
    for number, seam in enumerate(seams, 1):
        one, other = (_sense(boundaries[run.panel], run, number) for run in seam.runs)
        sides = [
            (run.panel, edge) for run, sense in zip(seam.runs, (one, other)) for edge in _edges(run, sense)
        ]
        twice = [side for side in sides if side in seam_of] or [
            side for side, count in Counter(sides).items() if count > 1
        ]
        if twice:
            raise AssemblyError(
                f"Seams {seam_of.get(twice[0], number)} and {number} hold the same piece of the boundary of"
                f" panel {twice[0][0] + 1}. Seal each piece once."
            )
        seam_of.update(dict.fromkeys(sides, number))
        senses.append((one, other))
    for index, boundary in enumerate(boundaries):
        left = sorted(edge for edge in boundary if (index, edge) not in seam_of)
        if left:
            raise AssemblyError(
                f"Panel {index + 1} is open between its vertices {left[0][0]} and {left[0][1]}: the boundary"
                " is in no seam there. Seal it to another."
            )
    return senses


def _edges(run: Run, sense: int) -> list[Edge]:
    ahead = run.vertices[::sense].tolist()
    return list(pairwise(ahead))


def _sense(boundary: set[Edge], run: Run, number: int) -> int:
    for sense in (1, -1):
        if boundary.issuperset(_edges(run, sense)):
            return sense
    raise AssemblyError(
        f"Seam {number} leaves the boundary of panel {run.panel + 1}. Give its vertices in a row along it."
    )


def _orientation(count: int, seams: Sequence[Seam], senses: list[tuple[int, int]]) -> tuple[Bools, int]:
    """Which panels lie with their other side out, so that all agree; and how many bodies they are.

    Of two panels that are sealed together one boundary runs against the other. The first panel of each body
    lies as it is. Raises AssemblyError where no choice agrees.
    """
    neighbours: list[list[tuple[int, int, int]]] = [[] for _ in range(count)]
    for number, (seam, (one, other)) in enumerate(zip(seams, senses), 1):
        first, second = (run.panel for run in seam.runs)
        neighbours[first].append((second, -one * other, number))
        neighbours[second].append((first, -one * other, number))
    side = [0] * count
    bodies = 0
    for root in range(count):
        if side[root]:
            continue
        bodies += 1
        side[root] = 1
        waiting = [root]
        while waiting:
            panel = waiting.pop()
            for other, same, number in neighbours[panel]:
                if not side[other]:
                    side[other] = same * side[panel]
                    waiting.append(other)
                elif side[other] != same * side[panel]:
                    raise AssemblyError(
                        f"Seam {number} joins the outside of the film to its inside, as in a Moebius strip."
                        " Turn one of its sides round."
                    )
    return np.array(side) < 0, bodies


def _pairs(seams: Sequence[Seam], offsets: Ints) -> Ints:
    """Vertices (k, 2) that are one, numbered through all panels."""
    pairs = [np.column_stack([run.vertices + offsets[run.panel] for run in seam.runs]) for seam in seams]
    return np.concatenate([np.zeros((0, 2), dtype=np.int64), *pairs])


def first_of_each(count: int, pairs: Ints) -> Ints:
    """For each of so many things the first of those that pairs (k, 2) make one with it: (count,)."""
    first = np.arange(count)
    while len(pairs):
        least = np.minimum(first[pairs[:, 0]], first[pairs[:, 1]])
        before = first.copy()
        for side in range(2):
            np.minimum.at(first, first[pairs[:, side]], least)
            np.minimum.at(first, pairs[:, side], least)
        first = first[first]
        if np.array_equal(first, before):
            break
    return first.astype(np.int32)


def _side_by_side(panels: Sequence[Panel], turned: Bools) -> Floats:
    """Rest positions of all panels in a row along x; the first stays where it is."""
    placed = [panels[0].rest_positions]
    for panel, over in zip(panels[1:], turned[1:]):
        flat = panel.rest_positions * (-1.0, 1.0) if over else panel.rest_positions
        placed.append(flat + np.array([placed[-1][:, 0].max() - flat[:, 0].min(), 0.0]))
    return np.concatenate(placed)
