# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a body of revolution: gores from pole to pole; of a ring, strips round it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from BalloonWorkbench.core.geometry.vectors import cross, rotation
from BalloonWorkbench.core.segmentation.proposal import Proposal
from BalloonWorkbench.core.targets.half_edges import area_vectors
from BalloonWorkbench.core.targets.refine import cut_where_zero
from BalloonWorkbench.core.types import Floats, Ints


def in_gores(points: Floats, triangles: Ints, axis: tuple[Floats, Floats], count: int) -> Proposal:
    """A body cut by half planes through its axis into so many equal sectors.

    axis  a point (3,) and a direction (3,) of it
    """
    return _in_sectors(points, triangles, lambda places: _across(places, axis), count)


def in_strips(points: Floats, triangles: Ints, axis: tuple[Floats, Floats], count: int) -> Proposal:
    """A ring cut into so many strips round it, each of two halves that are one panel."""
    first = _in_sectors(points, triangles, lambda places: _across(places, axis), 2)
    whole = _out_and_up(points, axis)
    core = 0.5 * (whole.min(axis=0) + whole.max(axis=0))
    turn = rotation(-np.pi / count)  # the first strip lies round the outside
    draft = _in_sectors(
        first.points, first.triangles, lambda places: (_out_and_up(places, axis) - core) @ turn, count
    )
    halves = _sectors(_across(draft.points[draft.triangles].mean(axis=1), axis), 2)
    return draft._replace(pieces=draft.pieces + count * halves, owners=np.tile(np.arange(count), 2))


def _in_sectors(points: Floats, triangles: Ints, flat: Callable[[Floats], Floats], count: int) -> Proposal:
    """A surface cut into equal sectors of a plane; flat: where places (k, 3) are in it, (k, 2)."""
    lines = count // 2 if count % 2 == 0 else count
    points, poles = _with_poles(points, triangles, flat(points))
    for line in range(lines):
        angle = 2.0 * np.pi * line / count
        values = flat(points) @ (-np.sin(angle), np.cos(angle))
        values[poles] = 0.0
        points, triangles, _ = cut_where_zero(points, triangles, values)
    sectors = _sectors(flat(points[triangles].mean(axis=1)), count)
    return Proposal(points, triangles, sectors, np.arange(count))


def _with_poles(points: Floats, triangles: Ints, across: Floats) -> tuple[Floats, list[int]]:
    """The points, with one moved to wherever all sectors meet, and their numbers; across (k, 2): see flat.

    The corner next to that place goes there within its triangle: else sectors end beside each other.
    """
    corners = across[triangles]
    shares = np.stack([cross(corners[:, (k + 1) % 3], corners[:, (k + 2) % 3]) for k in range(3)], axis=1)
    total = shares.sum(axis=1, keepdims=True)
    shares = np.divide(shares, total, out=np.full_like(shares, -1.0), where=total != 0.0)
    normals, poles = area_vectors(points, triangles), []
    for triangle in np.flatnonzero((shares >= 0.0).all(axis=1)).tolist():
        nearest = int(triangles[triangle, np.argmax(shares[triangle])])
        moved = points.copy()
        moved[nearest] = shares[triangle] @ points[triangles[triangle]]
        turned = np.einsum("ij,ij->i", area_vectors(moved, triangles), normals) <= 0.0
        if nearest not in poles and not turned.any():
            points = moved
            poles.append(nearest)
    return points, poles


def _sectors(flat: Floats, count: int) -> Ints:
    """Number (k,) of the sector in which places (k, 2) of a plane lie."""
    turn = np.arctan2(flat[:, 1], flat[:, 0]) % (2.0 * np.pi)
    return np.minimum(turn / (2.0 * np.pi) * count, count - 1).astype(np.int32)


def _across(places: Floats, axis: tuple[Floats, Floats]) -> Floats:
    """Places (k, 2) seen along an axis."""
    middle, along = axis
    first = np.eye(3)[int(np.argmin(np.abs(along) + 1e-6 * np.arange(3)))]
    first = first - (first @ along) * along
    first /= np.linalg.norm(first)
    return np.asarray((places - middle) @ np.column_stack([first, np.cross(along, first)]))


def _out_and_up(places: Floats, axis: tuple[Floats, Floats]) -> Floats:
    """How far places (k, 3) are from an axis, and how high along it: (k, 2)."""
    out = np.linalg.norm(_across(places, axis), axis=1)
    return np.column_stack([out, (places - axis[0]) @ axis[1]])
