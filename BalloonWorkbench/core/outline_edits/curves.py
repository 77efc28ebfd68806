# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an edit does to the loop of its node: a stretch is displaced with it, or drawn anew as a curve."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on, ring
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.outline_edits.nodes import PLAIN, SMOOTH, Kinds, NodeLoop, bezier
from BalloonWorkbench.core.types import Floats

#: Points of a stretch that bends when its node is moved.
_PIECES = 24
#: A direction at the end of a stretch is taken from this part of the stretch beside it, second order.
_BESIDE = 0.2


def bendable(loop: NodeLoop, node: int, after: int) -> NodeLoop:
    """The loop with points close enough that it can bend, from its first point to the node at `after`, where
    it is to; that is the number of points where it is the first one again."""
    points, kinds = _closed(loop)
    stretches = [(points[part], kinds[part]) for part in (slice(0, node + 1), slice(node, after + 1))]
    finer = [_denser(*each) if SMOOTH in (each[1][0], each[1][-1]) else each for each in stretches]
    return _joined(loop, after, *finer)


def shares(loop: NodeLoop, node: int, after: int) -> Floats:
    """How far each point (n,) of a loop goes with the node at an index, 1 as far, while the first point and
    the node at `after` stay.

    Where a node is smooth the line keeps its direction; between corners lines stay straight.
    """
    points, kinds = _closed(loop)
    share = np.zeros(len(loop.points))
    share[: node + 1] = _rising(points[: node + 1], kinds[[0, node]])
    share[node:after] = _rising(points[node : after + 1][::-1], kinds[[after, node]])[:0:-1]
    return share


def _rising(line: Floats, ends: Kinds) -> Floats:
    """From 0 to 1 along a line (n, 2); level at an end that is smooth, as a straight line at corners."""
    at = line_lengths(line)
    at = at / at[-1]
    first, last = (0.0 if kind == SMOOTH else 1.0 for kind in ends)
    return np.asarray(at**2 * (3 - 2 * at) + first * at * (1 - at) ** 2 - last * at**2 * (1 - at))


def _denser(line: Floats, kinds: Kinds) -> tuple[Floats, Kinds]:
    """The line with points close enough that it can bend."""
    lengths = line_lengths(line)
    step = lengths[-1] / _PIECES
    counts = np.maximum(1, np.ceil(np.diff(lengths) / step)).astype(int)
    at = [
        begin + span * np.arange(count) / count
        for begin, span, count in zip(lengths, np.diff(lengths), counts)
    ]
    own = np.cumsum([0, *counts.tolist()])
    finer: Kinds = np.zeros(own[-1] + 1, dtype=np.int8)
    finer[own] = kinds
    points = point_on(line, lengths, np.append(np.concatenate(at), lengths[-1]))
    points[own] = line
    return points, finer


def redrawn(loop: NodeLoop, node: int, after: int, kind: int) -> NodeLoop:
    """The loop with its node of another kind, PLAIN for none, and the stretch from its first point to the
    node at `after` drawn anew: straight between corners, without a kink where a node is smooth."""
    points, kinds = _closed(loop)
    begin, middle, end = points[0], points[node], points[after]
    whole = after == len(loop.points)
    rest, of_rest = points[after:], kinds[after:]
    into = -_direction_at(rest[::-1], of_rest[::-1]) if kinds[0] == SMOOTH and not whole else None
    out = _direction_at(rest, of_rest) if kinds[after] == SMOOTH and not whole else None
    if kind == PLAIN:
        return _joined(loop, after, _curve(begin, end, into, out))
    through = None
    if kind == SMOOTH:
        through = unit(unit((middle - begin)[None]) + unit((end - middle)[None]))[0]
        if not through.any():
            through = perpendicular(unit((middle - begin)[None]))[0]
    first, second = _curve(begin, middle, into, through), _curve(middle, end, through, out)
    first[1][-1] = second[1][0] = kind
    return _joined(loop, after, first, second)


def _direction_at(line: Floats, kinds: Kinds) -> Floats:
    """Unit vector (2,) along a line (n, 2) at its first point, from a part of its way to the next node."""
    line = line[: 2 + int(np.argmax(kinds[1:] != PLAIN))]
    lengths = line_lengths(line)
    reach = _BESIDE * lengths[-1]
    here, near, far = point_on(line, lengths, np.array([0.0, 0.5 * reach, reach]))
    return unit((4.0 * near - 3.0 * here - far)[None])[0]


def _curve(begin: Floats, end: Floats, leaves: Floats | None, arrives: Floats | None) -> tuple[Floats, Kinds]:
    """A line between two places with its directions there, straight on where there is none."""
    if leaves is None and arrives is None:
        return np.stack([begin, end]), np.zeros(2, dtype=np.int8)
    chord = end - begin
    long = float(np.hypot(*chord))
    straight = chord / max(long, 1e-300)
    one, two = (straight if each is None else each for each in (leaves, arrives))
    # the handles of a cubic that is an arc of a circle where both directions fit one
    reach = [2.0 * long / (3.0 * (1.0 + max(float(each @ straight), -0.5))) for each in (one, two)]
    line = bezier(np.stack([begin, begin + reach[0] * one, end - reach[1] * two, end]))
    return line, np.zeros(len(line), dtype=np.int8)


def _closed(loop: NodeLoop) -> tuple[Floats, Kinds]:
    """Points and kinds with the first ones repeated at the end."""
    return ring(loop.points), np.append(loop.kinds, loop.kinds[:1])


def _joined(loop: NodeLoop, after: int, *stretches: tuple[Floats, Kinds]) -> NodeLoop:
    """The loop with other stretches, one after the other, from its first point to the one at `after`."""
    points, kinds = [loop.points[:1]], [loop.kinds[:1]]
    for line, own in stretches:
        points.append(line[1:])
        kinds.append(own[1:])
    points[-1], kinds[-1] = points[-1][:-1], kinds[-1][:-1]  # the end is the first of the rest
    return NodeLoop(
        np.concatenate([*points, loop.points[after:]]), np.concatenate([*kinds, loop.kinds[after:]])
    )
