# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a Bag object's panels where its shape has them: of seams, and those that are free yet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app import bag as bag_object
from BalloonWorkbench.app.shapes.bag_shapes import panel_places
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.geometry.polyline import length, ring
from BalloonWorkbench.core.panels.surface import EASE, RELATIVE_EASE
from BalloonWorkbench.core.units import to_mm


@dataclass(frozen=True)
class PanelEdge:
    """An edge of a panel.

    line   (k, 2) mm, in the plane of the object's shape
    names  what the object calls each of its k - 1 pieces
    seam   number of its seam, None for an edge that is in none
    panel  number of the panel
    """

    line: np.ndarray
    names: tuple[str, ...]
    seam: int | None
    panel: int


@dataclass(frozen=True)
class BagEdges:
    """A bag as its object shows it.

    loops    of each panel, (n, 2) mm each
    wrong    numbers of the seams whose sides are not equally long
    lengths  mm, of both sides of each seam
    opening  (2,) mm, the middle of the edge at which it is filled
    """

    bag: Bag
    loops: list[list[np.ndarray]]
    edges: list[PanelEdge]
    wrong: frozenset[int]
    lengths: list[tuple[float, float]]
    opening: np.ndarray | None

    def of_seam(self, number: int | None) -> list[PanelEdge]:
        """Both edges of a seam."""
        return [edge for edge in self.edges if edge.seam == number is not None]


def edges_of(obj) -> BagEdges | None:
    """The edges of a Bag object; None while it has no panels."""
    if not obj.BagText:
        return None
    bag = bag_object.bag(obj)
    places = [to_mm(place) for place in panel_places(bag)]
    loops = [[to_mm(loop) + at for loop in panel.loops] for panel, at in zip(bag.panels, places)]
    names = _names(obj)
    edges, lengths, taken = [], [], set()
    for number, seam in enumerate(bag.seams):
        both = []
        for side, against in ((seam.a, False), (seam.b, True)):
            line = to_mm(side_line(bag, side, against=against)) + places[side.panel]
            edges.append(PanelEdge(line, _named(names, line), number, side.panel))
            taken |= set(map(_key, _middles(line)))
            both.append(length(line))
        lengths.append((both[0], both[1]))
    for panel, its in enumerate(loops):
        for loop in its:
            edges += _free(loop, names, taken, panel)
    wrong = frozenset(number for number, both in enumerate(lengths) if _is_wrong(*both, bag.ease))
    opening = None
    if bag.opening is not None:
        loop = loops[bag.opening.panel][0]
        opening = 0.5 * (loop[bag.opening.at] + loop[(bag.opening.at + 1) % len(loop)])
    return BagEdges(bag, loops, edges, wrong, lengths, opening)


def edge_seams(obj, shown: BagEdges) -> list[int | None]:
    """The number of the seam in which each straight piece of the object's shape is; None for free ones."""
    seams = {
        _key(at): edge.seam for edge in shown.edges if edge.seam is not None for at in _middles(edge.line)
    }
    return [seams.get(key) for key in _shape_keys(obj)]


def _is_wrong(one: float, other: float, ease: float) -> bool:
    return abs(one - other) > max(max(RELATIVE_EASE, ease) * max(one, other), to_mm(EASE))


def _free(loop: np.ndarray, names, taken, panel: int) -> list[PanelEdge]:
    """What of a loop is in no seam, an edge for each name."""
    closed = ring(loop)
    called = [None if _key(at) in taken else names.get(_key(at), "") for at in _middles(closed)]
    starts = [k for k in range(len(called)) if called[k] != called[k - 1]] or [0]
    edges = []
    for start, end in zip(starts, [*starts[1:], starts[0] + len(called)]):
        if called[start] is not None:
            numbers = np.arange(start, end + 1) % len(loop)
            edges.append(PanelEdge(loop[numbers], (called[start],) * (end - start), None, panel))
    return edges


def _names(obj) -> dict[tuple[int, int], str]:
    """What the object calls each straight piece of its shape, by the middle of that."""
    return dict(zip(_shape_keys(obj), obj.EdgeNames))


def _shape_keys(obj) -> list[tuple[int, int]]:
    back, keys = obj.Placement.inverse(), []
    for edge in obj.Shape.Edges:
        a, b = (back.multVec(vertex.Point) for vertex in edge.Vertexes)
        keys.append(_key((0.5 * (a.x + b.x), 0.5 * (a.y + b.y))))
    return keys


def _named(names, line: np.ndarray) -> tuple[str, ...]:
    return tuple(names.get(_key(at), "") for at in _middles(line))


def _middles(line: np.ndarray) -> list[list[float]]:
    return (0.5 * (line[1:] + line[:-1])).tolist()


def _key(at) -> tuple[int, int]:
    """A place on a grid that is finer than any edge, and coarser than what FreeCAD rounds."""
    return round(1e2 * at[0]), round(1e2 * at[1])
