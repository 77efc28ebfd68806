# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vectors of the plane: products, directions, angles between them, the foot on an edge, rotations."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats

_TINY = 1e-300


def cross(one: Floats, other: Floats) -> Floats:
    """Cross products (...) of vectors (..., 2): positive where the other one points to the left."""
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])


def norm(vectors: Floats) -> Floats:
    """Lengths (...) of vectors (..., 2)."""
    return np.hypot(vectors[..., 0], vectors[..., 1])


def perpendicular(vectors: Floats) -> Floats:
    """Vectors (..., 2) turned to the left by a quarter."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def unit(vectors: Floats) -> Floats:
    """Vectors (..., d) brought to length 1; those without a length stay so."""
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), _TINY))


def direction(angles: Floats | float) -> Floats:
    """Unit vectors (..., 2) at angles (...) counter-clockwise from +x [rad]."""
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def turn(before: Floats, after: Floats) -> Floats:
    """Angles (...) from vectors (..., 2) to others, positive to the left, up to pi [rad]."""
    return np.arctan2(cross(before, after), (before * after).sum(axis=-1))


def wrapped(angles: Floats) -> Floats:
    """Angles between -pi and pi [rad]."""
    return (angles + np.pi) % (2.0 * np.pi) - np.pi


def foot(x: Floats, y: Floats, u: Floats | float, v: Floats | float) -> tuple[Floats, Floats]:
    """The nearest place of an edge (u, v) to a point (x, y), both from the edge's start: as a share of the
    edge, and how far it is. All of them may be arrays that broadcast; an edge without length is a point.
    """
    share = np.minimum(np.maximum((x * u + y * v) / (u * u + v * v + _TINY), 0.0), 1.0)
    across, beside = x - share * u, y - share * v
    return share, np.sqrt(across * across + beside * beside)


def rotation(angle: float) -> Floats:
    """The matrix (2, 2) by which rows of points are multiplied to turn by an angle [rad], counter-clockwise.

    Quarter turns are exact.
    """
    quarters = angle / (0.5 * np.pi)
    if abs(quarters - round(quarters)) < 1e-9:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    else:
        cosine, sine = float(np.cos(angle)), float(np.sin(angle))
    return np.array([[cosine, sine], [-sine, cosine]])


def alignment(points: Floats, goals: Floats, weights: Floats) -> tuple[Floats, Floats]:
    """Matrix (2, 2) and shift (2,) with which points @ matrix.T + shift are nearest to the goals (n, 2).

    Least squares (Kabsch), after the barycentres are brought together.
    """
    share = weights / weights.sum()
    centre, goal_centre = share @ points, share @ goals
    correlation = (points - centre).T @ ((goals - goal_centre) * share[:, None])
    angle = np.arctan2(correlation[0, 1] - correlation[1, 0], correlation[0, 0] + correlation[1, 1])
    matrix = rotation(float(angle)).T
    return matrix, goal_centre - matrix @ centre
