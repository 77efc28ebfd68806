# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edits of a drawing in their order; one whose place is gone is named and left out.

An edit knows its node and the nodes beside it by their places. On the drawing that it was made on these are
nodes exactly. On another one, of a changed picture, the line within reach of each of them gets a node there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.nearest import nearest_on_line, nearest_on_loops, way_round
from BalloonWorkbench.core.geometry.polyline import bounds, extent, ring
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.outline.drawing import Drawing, checked
from BalloonWorkbench.core.outline.symmetry import Mirror, exact_mirror
from BalloonWorkbench.core.outline_edits.curves import bendable, redrawn, shares
from BalloonWorkbench.core.outline_edits.edit import ADD, FILL, MOVE, REMOVE, SHARP, OutlineEdit
from BalloonWorkbench.core.outline_edits.nodes import (
    CORNER,
    FEWEST,
    PLAIN,
    SMOOTH,
    NodeDrawing,
    NodeLoop,
    with_nodes,
)
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import place_text

#: A changed outline has the place of an edit if it passes this near to it, in parts of its size; a node this
#: near is the one that was meant.
REACH, _SAME_NODE = 0.04, 0.015
#: A stretch that leaves its chord by less than this part of the size is straight.
_STRAIGHT = 2e-3
_HAIR = 1e-6  # of the size: two places nearer than this are one


@dataclass(frozen=True)
class EditedDrawing:
    """A drawing after its edits.

    nodes     the drawing with its nodes
    left_out  a sentence on each edit that has no place in it
    """

    nodes: NodeDrawing
    left_out: tuple[str, ...]

    @property
    def drawing(self) -> Drawing:
        """Checked, with the sentences among its notes."""
        first, *others = checked(self.nodes.drawing).parts
        noted = replace(first, notes=(*first.notes, *self.left_out))
        return replace(self.nodes.drawing, parts=(noted, *others))


class NoPlace(InputError):
    """The outline is not where an edit was made any more."""


@memoized(8)
def apply_edits(drawing: Drawing, edits: Sequence[OutlineEdit]) -> EditedDrawing:
    """The drawing after all edits, in their order. What would make it cross itself is left out, too."""
    canvas = EditFrame.of(drawing)
    nodes = with_nodes(drawing)
    axes = axes_of(drawing) if any(edit.mirrored for edit in edits) else ()
    left_out = []
    for number, edit in enumerate(edits, start=1):
        try:
            nodes = with_edit(nodes, canvas.on(edit), axes)
        except (InputError, OutlineError) as error:
            place = place_text(np.round(canvas.on(edit).node, 4))
            left_out.append(f"Outline edit {number} at {place} is left out. {error}")
    return EditedDrawing(nodes, tuple(left_out))


@dataclass(frozen=True)
class EditFrame:
    """What the places of edits are parts of: its lower left corner (2,) and its size (2,) m."""

    low: Floats
    size: Floats

    @staticmethod
    def of(drawing: Drawing) -> EditFrame:
        """The picture that a drawing was traced in, else the box round it."""
        every = np.concatenate([part.outer for part in drawing.parts])
        low, high = bounds(every if drawing.canvas is None else drawing.canvas)
        return EditFrame(low, high - low)

    def on(self, edit: OutlineEdit) -> OutlineEdit:
        """An edit with its places in metres."""
        return replace(edit, places=self.low + edit.places * self.size, to=self.low + edit.to * self.size)

    def kept(self, edit: OutlineEdit) -> OutlineEdit:
        """An edit with places in metres as it is kept."""
        return replace(edit, places=(edit.places - self.low) / self.size, to=(edit.to - self.low) / self.size)


def with_edit(nodes: NodeDrawing, edit: OutlineEdit, axes: Sequence[Mirror] = ()) -> NodeDrawing:
    """The drawing after one edit, in metres, and after its image on the other side of the axes.

    NoPlace, or OutlineError where loops would cross.
    """
    after = unchecked(nodes, edit, axes)
    checked(after.drawing)
    return after


def unchecked(nodes: NodeDrawing, edit: OutlineEdit, axes: Sequence[Mirror] = ()) -> NodeDrawing:
    """The same where loops may cross: while a node is dragged."""
    axes = axes if edit.mirrored else ()
    if edit.kind == MOVE:
        return _moved(nodes, edit, axes)
    for places in [edit.places] if edit.kind in (ADD, FILL) else edit.places.reshape(-1, 3, 2):
        one = replace(edit, places=places)
        for each in (one, *_images(one, axes, nodes.size)):
            nodes = _applied(nodes, each)
    return nodes


def _images(edit: OutlineEdit, axes: Sequence[Mirror], size: float) -> list[OutlineEdit]:
    """The images of an edit of one node that is on none of the axes, of a drawing of a size [m]."""
    images = [_image(edit, axis) for axis in axes]
    return [image for image in images if np.linalg.norm(image.node - edit.node) > _SAME_NODE * size]


def _moved(nodes: NodeDrawing, edit: OutlineEdit, axes: Sequence[Mirror]) -> NodeDrawing:
    """All nodes of an edit, and their images, displaced at once; one on an axis stays on it."""
    size, by, moves = nodes.size, edit.to - edit.node, []
    for places in edit.places.reshape(-1, 3, 2):
        own = by
        for axis in axes:
            image = axis.reflect(places)[::-1]
            behind = axis.reflect((image[1] + by)[None])[0] - places[1]
            if np.linalg.norm(image[1] - places[1]) > _SAME_NODE * size:
                moves.append((image, behind))
            else:
                own = 0.5 * (own + behind)
        moves.append((places, own))
    loops = {_loop_at(nodes, places[1]) for places, _ in moves}
    for number in sorted(loops):
        own_moves = [move for move in moves if _loop_at(nodes, move[0][1]) == number]
        loop = nodes.loops[number]
        for places, _ in own_moves:
            loop = bendable(*_stretch(loop, places, size))
        displaced = loop.points.copy()
        for places, vector in own_moves:
            rolled, node, after = _stretch(loop, places, size)
            first = _index_of(loop, rolled.points[0])
            displaced += np.roll(shares(rolled, node, after), first)[:, None] * vector
        nodes = nodes.with_loop(number, NodeLoop(displaced, loop.kinds))
    return nodes


def _applied(nodes: NodeDrawing, edit: OutlineEdit) -> NodeDrawing:
    """The drawing after an edit of one node that does not move it."""
    number = _loop_at(nodes, edit.node)
    size = nodes.size
    if edit.kind == FILL:
        if nodes.owner(number)[1] == 0:
            raise NoPlace("There is no hole any more: delete the edit.")
        return nodes.without_loop(number)
    if edit.kind == ADD:
        return nodes.with_loop(number, _with_node(nodes.loops[number], edit.node, size, _HAIR * size)[0])
    kind = PLAIN if edit.kind == REMOVE else CORNER if edit.kind == SHARP else SMOOTH
    rolled, node, after = _stretch(nodes.loops[number], edit.places, size)
    return nodes.with_loop(number, redrawn(rolled, node, after, kind))


def _stretch(loop: NodeLoop, places: Floats, size: float) -> tuple[NodeLoop, int, int]:
    """The loop from the first of three places (3, 2) m on, and the points of the other two; NoPlace."""
    spread = np.linalg.norm(places[[0, 2]] - places[1], axis=1).min()
    points = []
    for place in places:
        loop, point = _with_node(loop, place, size, min(_SAME_NODE * size, 0.4 * float(spread)))
        points.append(point)
    begin, at, end = (_index_of(loop, point) for point in points)
    count = len(loop.points)
    node, after = (at - begin) % count, (end - begin) % count or count
    if not 0 < node < after:
        raise NoPlace("The outline runs another way there: delete the edit.")
    return loop.rolled(begin), node, after


def _index_of(loop: NodeLoop, point: Floats) -> int:
    return int(np.argmin(np.linalg.norm(loop.points - point, axis=1)))


def _loop_at(nodes: NodeDrawing, place: Floats) -> int:
    """The number of the loop that passes nearest to a place (2,) m. NoPlace where none is within reach."""
    loops = [loop.points for loop in nodes.loops]
    nearest = nearest_on_loops(loops, place[None])
    if nearest.distance[0] > REACH * nodes.size:
        raise NoPlace("The outline does not pass there any more: delete the edit.")
    return int(way_round(loops, nearest)[0][0])


def _with_node(loop: NodeLoop, place: Floats, size: float, same: float) -> tuple[NodeLoop, Floats]:
    """The loop with a node at a place, and where that is: one that is there, as near as `same` [m], or a new
    one in the line. NoPlace."""
    at = loop.nodes
    away = np.linalg.norm(loop.points[at] - place, axis=1)
    if len(at) and away.min() <= max(same, _HAIR * size):
        return loop, loop.points[at[np.argmin(away)]]
    nearest = nearest_on_line(ring(loop.points), place[None])
    if nearest.distance[0] > REACH * size:
        raise NoPlace("The outline does not pass there any more: delete the edit.")
    edge, share = int(nearest.edge[0]), float(nearest.share[0])
    begin, end = loop.points[edge], loop.points[(edge + 1) % len(loop.points)]
    point = begin + share * (end - begin)
    ends = np.linalg.norm(np.stack([begin, end]) - point, axis=1)
    kinds = loop.kinds.copy()
    if ends.min() <= _HAIR * size:
        vertex = (edge + int(np.argmin(ends))) % len(loop.points)
        kinds[vertex] = kinds[vertex] or _kind_at(loop, vertex, size)
        return NodeLoop(loop.points, kinds), loop.points[vertex]
    inserted = NodeLoop(
        np.insert(loop.points, edge + 1, point, axis=0), np.insert(kinds, edge + 1, np.int8(PLAIN))
    )
    inserted.kinds[edge + 1] = _kind_at(inserted, edge + 1, size)
    return inserted, point


def _kind_at(loop: NodeLoop, at: int, size: float) -> int:
    """What a new node at a point is: on a straight stretch between two nodes a corner, else smooth."""
    rolled = loop.rolled(at)
    nodes = rolled.nodes
    line = np.concatenate([rolled.points[nodes[-1] :], rolled.points[: nodes[0] + 1]])
    away = nearest_on_line(line[[0, -1]], line).distance.max()
    return CORNER if away <= _STRAIGHT * size else SMOOTH


def node_edit(
    nodes: NodeDrawing, kind: str, at: Floats, to: Floats | None = None, mirrored: bool = False
) -> OutlineEdit:
    """The edit, in metres, that does something to the node nearest to a place (2,), or adds one there.

    A hole that would keep fewer than three nodes is filled. InputError where there is none within reach, or
    the outline itself would keep too few.
    """
    to = at if to is None else to
    if kind == ADD:
        _loop_at(nodes, at)
        return OutlineEdit(kind, at[None], to, mirrored)
    number, point = nearest_node(nodes, at)
    loop, is_outer = nodes.loops[number], nodes.owner(number)[1] == 0
    if kind == REMOVE and len(loop.nodes) <= FEWEST and is_outer:
        raise InputError("An outline keeps three nodes: move them instead.")
    if kind == FILL and is_outer:
        raise InputError(f"There is no hole at {place_text(at)}: give a place on its edge.")
    if kind == FILL or (kind == REMOVE and len(loop.nodes) <= FEWEST):
        return OutlineEdit(FILL, loop.points[point][None], to, mirrored)
    own = int(np.searchsorted(loop.nodes, point))
    beside = loop.nodes[[own - 1, own, (own + 1) % len(loop.nodes)]]
    return OutlineEdit(kind, loop.points[beside], to, mirrored)


def edits_of_nodes(
    nodes: NodeDrawing,
    kind: str,
    places: Sequence[Floats],
    by: Floats,
    axes: Sequence[Mirror] = (),
    mirrored: bool = False,
) -> tuple[OutlineEdit, ...]:
    """The edits, in metres, that do the same to nodes at several places (2,): all nodes in one edit, and one
    for each hole that is filled by it; by (2,) m as far as they move. InputError as for `node_edit`."""
    images = [axis.reflect(np.stack(places)) for axis in axes if mirrored]
    places = [
        place
        for number, place in enumerate(places)  # one whose image goes is itself an image
        if not any(
            (np.abs(image[:number] - place) < _SAME_NODE * nodes.size).all(axis=1).any() for image in images
        )
    ]
    owners = [nearest_node(nodes, place)[0] for place in places]
    full = [
        number
        for number in sorted(set(owners))
        if kind == REMOVE
        and nodes.owner(number)[1] > 0
        and len(nodes.loops[number].nodes) - owners.count(number) < FEWEST
    ]
    fills = [node_edit(nodes, FILL, places[owners.index(number)], mirrored=mirrored) for number in full]
    triples = []
    for place in (place for place, owner in zip(places, owners) if owner not in full):
        edit = node_edit(nodes, kind, place, place + by, mirrored)
        triples.append(edit.places)
        nodes = nodes if kind == MOVE else unchecked(nodes, edit, axes)
    if not triples:
        return tuple(fills)
    whole = np.concatenate(triples)
    return (OutlineEdit(kind, whole, whole[1] + by, mirrored), *fills)


def nearest_node(nodes: NodeDrawing, at: Floats) -> tuple[int, int]:
    """The loop and the point of the node nearest to a place (2,) m. InputError where none is within reach."""
    best: tuple[float, int, int] = (np.inf, 0, 0)
    for number, loop in enumerate(nodes.loops):
        away = np.linalg.norm(loop.points[loop.nodes] - at, axis=1)
        nearest = int(np.argmin(away))
        best = min(best, (float(away[nearest]), number, int(loop.nodes[nearest])))
    if best[0] > REACH * nodes.size:
        raise InputError(f"There is no node near {place_text(at)}: add one there.")
    return best[1:]


def appended(edits: Sequence[OutlineEdit], edit: OutlineEdit) -> tuple[OutlineEdit, ...]:
    """The edits and one more, as they are kept; nodes that are moved on are moved once."""
    if edits and edit.kind == MOVE == edits[-1].kind and edit.mirrored == edits[-1].mirrored:
        last = edits[-1]
        gone = (np.abs(last.places[:, None] - last.places[None, 1::3]) < _HAIR).all(axis=2).any(axis=1)
        now = last.places + gone[:, None] * (last.to - last.node)
        if len(now) == len(edit.places) and np.allclose(now, edit.places, rtol=0.0, atol=_HAIR):
            return (*edits[:-1], replace(last, to=last.to + edit.to - edit.node))
    return (*edits, edit)


@memoized(8)
def axes_of(drawing: Drawing) -> tuple[Mirror, ...]:
    """The axis of each shape that is symmetric as it is."""
    return tuple(filter(None, map(exact_mirror, drawing.parts)))


def _image(edit: OutlineEdit, axis: Mirror) -> OutlineEdit:
    """An edit on the other side of an axis, where its stretch runs the other way, after the edit itself."""
    places = axis.reflect(edit.places)[::-1].copy()
    for end in (0, 2) if edit.kind == REMOVE else ():  # the node itself may have been beside its image
        if np.linalg.norm(places[end] - edit.node) < 1e-3 * extent(edit.places):
            places[end] = edit.places[end]
    return replace(edit, places=places)
