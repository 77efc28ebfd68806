# SPDX-License-Identifier: LGPL-2.1-or-later
"""From sketches and flat faces to a bag: each is a panel, and texts say which edge is joined to which.

An edge is told as "Sketch.Edge3", one of a face as "Box.Face2.Edge3" or, where a single panel has it,
"Box.Edge3". A seam is "Sketch.Edge1=Sketch001.Edge3". Edges that two faces of one object share are joined
without being told.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from BalloonWorkbench.app.drawings.sketch import frame_of, joined, polyline, shape_of
from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.errors import AssemblyError, InputError, OutlineError
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on, signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.panels.surface import EASE, RELATIVE_EASE
from BalloonWorkbench.core.units import from_mm, length_text

_DEFLECTION = 1e-4  # of a polyline from its curve, relative to the size of the panel
_NO_SIZE = 1e-4  # mm


@dataclass
class DrawnEdge:
    """An edge of a panel, in the direction of its loop.

    name    as the user reads it: "Sketch.Edge3"
    points  (n, 2) m in the panel's plane
    closed  it is a whole loop
    """

    name: str
    number: int
    points: np.ndarray
    closed: bool

    @property
    def length(self) -> float:
        """Its length [m]."""
        return length(self.points)


@dataclass
class DrawnPanel:
    """A panel by the edges of its loops, the outer one first."""

    name: str
    source: object
    face: str
    loops: list[list[DrawnEdge]]

    @property
    def edges(self) -> list[DrawnEdge]:
        """All of them."""
        return [edge for loop in self.loops for edge in loop]


@dataclass(frozen=True)
class DrawnBag:
    """The bag of drawn panels, and what its seams are called.

    seams    the edges that are joined, as texts
    lengths  (seams, 2) m, of both sides
    names    of edges, by panel, loop and each point at which a piece of them begins
    """

    bag: Bag
    seams: tuple[str, ...]
    lengths: np.ndarray
    names: dict[tuple[int, int, int], str]


def drawn_panels(sources) -> list[DrawnPanel]:
    """The panels of sources: pairs of a document object and names of faces of it, ("",) for the whole."""
    panels, budget = [], Budget()
    for source, elements in sources:
        for face in elements or ("",):
            panels.append(_panel(source, face, budget))
    if not panels:
        raise InputError("There are no panels: choose sketches or flat faces.")
    taken: dict[str, int] = {}
    for panel in panels:
        taken[panel.name] = taken.get(panel.name, 0) + 1
        if taken[panel.name] > 1:
            panel.name = f"{panel.name} {taken[panel.name]}"
    return panels


def joined_pairs(panels: list[DrawnPanel], seams) -> list[tuple[DrawnEdge, DrawnEdge]]:
    """The pairs of edges that texts join, and those that faces of one object share.

    Raises InputError for a text that names no edge, AssemblyError for an edge in two seams.
    """
    pairs, used = [], set()
    for text in seams:
        names = [name.strip() for name in text.split("=")]
        if len(names) != 2:
            raise InputError(
                f'The seam "{text}" names no two edges: write it as "Sketch.Edge1=Sketch001.Edge3".'
            )
        one, other = (edge_named(panels, name) for name in names)
        pairs.append((one, other))
        for edge in (one, other):
            if id(edge) in used:
                raise AssemblyError(f"{edge.name} is in two seams: take one of them away.")
            used.add(id(edge))
    for one, other in combinations(panels, 2):
        if one.source != other.source:
            continue
        for a in one.edges:
            for b in other.edges:
                if a.number == b.number and not {id(a), id(b)} & used:
                    pairs.append((a, b))
                    used |= {id(a), id(b)}
    return pairs


def unjoined(panels: list[DrawnPanel], pairs) -> list[str]:
    """A sentence for each edge that is in no seam."""
    used = {id(edge) for pair in pairs for edge in pair}
    return [
        f"{edge.name} is in no seam: join it to another edge."
        for panel in panels
        for edge in panel.edges
        if id(edge) not in used
    ]


def edge_named(panels: list[DrawnPanel], name: str) -> DrawnEdge:
    """The edge that a text tells; InputError where there is none, or more than one."""
    owner, *rest = name.split(".")
    matching = [
        edge
        for panel in panels
        for edge in panel.edges
        if owner in (panel.source.Name, panel.source.Label)
        and rest in ([f"Edge{edge.number}"], [panel.face, f"Edge{edge.number}"])
    ]
    if not matching:
        raise InputError(f'No panel has an edge "{name}": choose one of an outline or face of this bag.')
    if len(matching) > 1:
        raise InputError(
            f'"{name}" is an edge of {len(matching)} panels: name the face too, as in {matching[0].name}.'
        )
    return matching[0]


def bag_of(panels: list[DrawnPanel], pairs, opening: str = "", ease: float = 0.0) -> DrawnBag:
    """The bag of panels whose pairs of edges are joined, of which some may be missing.

    opening  the edge at which it is filled; empty for none
    ease     as in `Bag`

    Raises InputError for an opening that there is not.
    """
    opened = edge_named(panels, opening) if opening else None
    halved = {id(edge) for pair in pairs if any(each.closed for each in pair) for edge in pair}
    made, names, ends = [], {}, {}
    for number, panel in enumerate(panels):
        loops = []
        for k, loop in enumerate(panel.loops):
            for edge in loop:
                edge.points = _with_middle(edge.points) if id(edge) in halved else edge.points
            count = sum(len(edge.points) - 1 for edge in loop)
            start = 0
            for edge in loop:
                end = start + len(edge.points) - 1
                middle = [start + _middle(edge.points)] if id(edge) in halved else []
                ends[id(edge)] = (number, k, [at % count for at in (start, *middle, end)])
                names |= {(number, k, at): edge.name for at in range(start, end)}
                start = end
            loops.append(np.concatenate([edge.points[:-1] for edge in loop]))
        made.append(BagPanel(panel.name, loops[0], tuple(loops[1:])))
    joints = tuple(joint for one, other in pairs for joint in _joints(ends[id(one)], ends[id(other)]))
    place = None if opened is None else _opening(opened, ends[id(opened)])
    lengths = np.array([[edge.length for edge in pair] for pair in pairs]).reshape(-1, 2)
    texts = tuple(f"{one.name}={other.name}" for one, other in pairs)
    return DrawnBag(Bag(tuple(made), joints, place, ease), texts, lengths, names)


def _joints(one, other) -> list[BagSeam]:
    """The seams between two edges, each given by panel, loop and the points at which it stops."""
    (panel, loop, along), (partner, its_loop, against) = one, other
    return [
        BagSeam(
            Side(panel, along[k], along[k + 1], loop),
            Side(partner, against[-1 - k], against[-2 - k], its_loop),
        )
        for k in range(len(along) - 1)
    ]


def _opening(edge: DrawnEdge, ends) -> Opening:
    panel, loop, stops = ends
    if loop:
        raise InputError(f"{edge.name} is an edge of a hole: choose one of an outer loop as the opening.")
    return Opening(panel, (stops[0] + (len(edge.points) - 1) // 2))


def unequal(drawn: DrawnBag) -> list[str]:
    """A sentence for each seam whose sides are not equally long."""
    sentences, ease = [], drawn.bag.ease
    for seam, (a, b) in zip(drawn.seams, drawn.lengths.tolist(), strict=True):
        one, _, other = seam.partition("=")
        if abs(a - b) > max(max(RELATIVE_EASE, ease) * max(a, b), EASE):
            sentences.append(
                f"{one} is {length_text(a)} long, {other} is {length_text(b)}: make them equally long."
            )
    return sentences


def _panel(source, face: str, budget: Budget) -> DrawnPanel:
    """The panel that an object or a face of it draws."""
    name = f"{source.Label} {face}" if face else source.Label
    shape = shape_of(source, (face,))
    size = shape.BoundBox.DiagonalLength if shape.Edges else 0.0
    if size <= _NO_SIZE:
        raise OutlineError(f"{name} is empty: draw a closed line in it.")
    if len(shape.Faces) > 1:
        raise OutlineError(f"{name} has several faces: select those that are panels.")
    lines = [polyline(edge, size, _DEFLECTION) for edge in shape.Edges]
    budget.spend_points(sum(map(len, lines)))
    frame = frame_of(shape, np.concatenate(lines), size, name)
    back = np.array(frame.inverse().Matrix.A).reshape(4, 4)
    numbers = _numbers(source, face)
    prefix = f"{source.Name}.{face}" if face else source.Name
    loops = []
    for wire in shape.Wires:
        if not wire.isClosed():
            raise OutlineError(f"{name} is open: close its line.")
        edges = wire.OrderedEdges
        drawn = [polyline(edge, size, _DEFLECTION) @ back[:2, :3].T + back[:2, 3] for edge in edges]
        own = [numbers[_same(shape.Edges, edge)] for edge in edges]
        loops.append(_loop(prefix, own, [from_mm(line) for line in drawn]))
    loops.sort(key=lambda loop: -abs(_area(loop)))
    turned = [loop if (_area(loop) > 0.0) == (k == 0) else _reversed(loop) for k, loop in enumerate(loops)]
    return DrawnPanel(name, source, face, turned)


def _numbers(source, face: str) -> list[int]:
    """The numbers that the object has for the edges of one of its faces, or of the whole."""
    everything = source.Shape.Edges
    if not face:
        return [k + 1 for k in range(len(everything))]
    return [_same(everything, edge) + 1 for edge in source.Shape.getElement(face).Edges]


def _same(edges, edge) -> int:
    return next(k for k, other in enumerate(edges) if other.isSame(edge))


def _loop(prefix: str, numbers: list[int], lines: list[np.ndarray]) -> list[DrawnEdge]:
    """The edges of a closed line, each turned so that it begins where the last one ends."""
    whole, edges, at = joined(lines), [], 0
    for number, line in zip(numbers, lines):
        points = whole[at : at + len(line)]
        at += len(line) - 1
        edges.append(DrawnEdge(f"{prefix}.Edge{number}", number, points, len(lines) == 1))
    edges[-1].points = np.concatenate([edges[-1].points[:-1], edges[0].points[:1]])
    return edges


def _area(loop: list[DrawnEdge]) -> float:
    return float(signed_area(np.concatenate([edge.points[:-1] for edge in loop])))


def _reversed(loop: list[DrawnEdge]) -> list[DrawnEdge]:
    for edge in loop:
        edge.points = edge.points[::-1]
    return loop[::-1]


def _with_middle(points: np.ndarray) -> np.ndarray:
    """The line with a point at half its length."""
    along = line_lengths(points)
    half = 0.5 * along[-1]
    if np.abs(along - half).min() < 1e-9 * along[-1]:
        return points
    at = int(np.searchsorted(along, half))
    middle = point_on(points, along, np.array([half]))[0]
    return np.insert(points, at, middle, axis=0)


def _middle(points: np.ndarray) -> int:
    """The number of the point at half the length of a line."""
    along = line_lengths(points)
    return int(np.abs(along - 0.5 * along[-1]).argmin())
