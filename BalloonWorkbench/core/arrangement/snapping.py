# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a piece snaps to that is moved or turned: it touches others, lies parallel to their edges, or its
grain runs along the axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.arrangement.arrangement import LaidPieces, PiecePlace
from BalloonWorkbench.core.geometry.nearest import nearest_edges
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import length, perimeter
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece
from BalloonWorkbench.core.types import Floats

#: Pieces are turned by so much with a key, and snap to multiples of it.
STEP = float(np.radians(15.0))
#: As far as a turn snaps [rad].
NEAR_TURN = float(np.radians(3.0))
#: An edge whose ends are that much of its length apart has a direction.
_STRAIGHT = 0.95
#: Corners are looked for within that part of the way round.
_REACH = 1.0 / 200.0


class Neighbours:
    """The other pieces, for one that is being moved or turned."""

    def __init__(self, laid: LaidPieces, number: int):
        self._own = _outlines(laid.pieces.pieces[number])
        others = [
            loop
            for other, piece in enumerate(laid.pieces.pieces)
            if other != number
            for loop in _outlines(piece)
        ]
        self._own_corners, self._corners = _corners(self._own), _corners(others)
        self._points, self._next = _joined(self._own), _following(self._own)
        self._starts, self._ends = _joined(others), _following(others)
        self._directions = [
            angle for edge in laid.pieces.edges if edge.piece != number for angle in _direction(edge.line)
        ]
        self._own_directions = [
            angle for edge in laid.base.edges if edge.piece == number for angle in _direction(edge.line)
        ]

    def touching(self, shift: Floats, reach: float) -> Floats:
        """The shift (2,) [m] near a shift of the piece at which it touches another: a corner in a corner,
        else its outline on that of another; the shift itself where none is within reach [m]."""
        low, high = self._points.min(axis=0) + shift - reach, self._points.max(axis=0) + shift + reach
        corner = _nearest_points(self._own_corners + shift, _between(self._corners, low, high), reach)
        if corner is not None:
            return np.asarray(shift + corner)
        near = (np.minimum(self._starts, self._ends) <= high) & (np.maximum(self._starts, self._ends) >= low)
        near = near.all(axis=1)
        starts, ends = self._starts[near], self._ends[near]
        if not len(starts):
            return shift
        own = self._points + shift
        away = [
            _to_edges(_between(own, starts.min(axis=0) - reach, starts.max(axis=0) + reach), starts, ends),
            -_to_edges(_between(starts, low, high), own, self._next + shift),
        ]
        gaps = np.concatenate(away)
        lengths = np.hypot(*gaps.T)
        return shift if not len(gaps) or lengths.min() > reach else np.asarray(shift + gaps[lengths.argmin()])

    def turn(self, place: PiecePlace, grain: float | None, near: float = NEAR_TURN) -> PiecePlace:
        """The place turned to what is nearest within `near` [rad]: a multiple of STEP, its grain along an
        axis, or one of its edges along one of another piece; as it is where there is none.

        grain  its direction in the pattern [rad], None of a film without
        """
        sense = -1.0 if place.mirrored else 1.0
        goals = [STEP * round(place.angle / STEP)]
        if grain is not None:
            goals += [float(_closest(-sense * grain, 0.5 * np.pi, place.angle))]
        own, others = np.array(self._own_directions), np.array(self._directions)
        goals += _closest((others[:, None] - sense * own).ravel(), np.pi, place.angle).tolist()
        turns = np.array(goals) - place.angle
        least = turns[np.abs(turns).argmin()]
        return place.turned(float(least)) if abs(least) <= near else place


def _closest(angles: Floats | float, period: float, goal: float) -> Floats:
    """Angles [rad] plus that multiple of a period with which they are nearest to a goal."""
    return np.asarray(angles + period * np.round((goal - np.asarray(angles)) / period))


def _outlines(piece: FlatPiece) -> list[Floats]:
    return [cut.points for cut in piece.pattern.of(Role.CUT) if cut.closed]


def _corners(loops: Sequence[Floats]) -> Floats:
    return _joined([loop[corners(loop, reach=_REACH * perimeter(loop))] for loop in loops])


def _joined(parts: Sequence[Floats]) -> Floats:
    return np.concatenate([np.zeros((0, 2)), *parts])


def _following(loops: Sequence[Floats]) -> Floats:
    """The point after each one."""
    return _joined([np.roll(loop, -1, axis=0) for loop in loops])


def _direction(line: Floats) -> list[float]:
    """The direction of an edge (k, 2) as a list of one; empty of one that bends."""
    x, y = (line[-1] - line[0]).tolist()
    return [float(np.arctan2(y, x))] if np.hypot(x, y) >= _STRAIGHT * length(line) else []


def _between(points: Floats, low: Floats, high: Floats) -> Floats:
    return points[((points >= low) & (points <= high)).all(axis=1)]


def _nearest_points(own: Floats, others: Floats, reach: float) -> Floats | None:
    """From one of own points to one of others, the shortest; None beyond reach."""
    if not len(own) or not len(others):
        return None
    ways = others[None] - own[:, None]
    lengths = np.hypot(ways[..., 0], ways[..., 1])
    least = np.unravel_index(lengths.argmin(), lengths.shape)
    return np.asarray(ways[least]) if lengths[least] <= reach else None


def _to_edges(points: Floats, starts: Floats, ends: Floats) -> Floats:
    """From each point (k, 2) to the nearest place of the edges: (k, 2)."""
    if not len(points):
        return np.zeros((0, 2))
    edge, share, _ = nearest_edges(points, starts, ends)
    return np.asarray(starts[edge] + share[:, None] * (ends[edge] - starts[edge]) - points)
