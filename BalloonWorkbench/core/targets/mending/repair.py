# SPDX-License-Identifier: LGPL-2.1-or-later
"""One closed body out of the triangles of a mesh: mended where that is safe, refused where it is not."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.panels.surface import first_of_each
from BalloonWorkbench.core.targets.half_edges import (
    Indices,
    area_vectors,
    connected_parts,
    enclosed_volume,
    first_corners,
    half_edges,
    twins,
)
from BalloonWorkbench.core.targets.mending.crossings import crossing_triangles
from BalloonWorkbench.core.targets.mending.holes import filled_holes
from BalloonWorkbench.core.targets.mending.junctions import junctions, parted, without_walls
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import number_text

#: Points nearer than this part of the size are one.
_ONE = 1e-6
#: A body of less volume than this part of its area times its size is flat.
_FLAT = 1e-3
_FARTHEST = 1e12
#: Rings of triangles round a crossing that are cut out with it, and at most this part of all triangles.
_RINGS, _CUT_OUT = 3, 0.05


@dataclass
class Mended:
    """A closed body, points (n, 3) and triangles (m, 3), and what was mended: one sentence each."""

    points: Floats
    triangles: Ints
    notes: list[str] = field(default_factory=list)


def mended(points: Floats, triangles: Ints) -> Mended:
    """The largest body of a mesh, closed and seen from outside. Raises InputError where there is none."""
    body = Mended(points, triangles)
    for step in _STEPS:
        checkpoint()
        step(body)
    return body


def _finite(body: Mended) -> None:
    """Without triangles whose points are no places."""
    count = len(body.points)
    if len(body.triangles) and not 0 <= body.triangles.min() <= body.triangles.max() < count:
        raise InputError("The mesh has a triangle with a point that is not there. Save it once more.")
    sound = (np.abs(body.points) < _FARTHEST).all(axis=1)
    kept = sound[body.triangles].all(axis=1)
    _keep(body, kept)
    if not kept.all():
        body.notes.append(
            f"Triangles of the mesh whose points are no numbers were left out: {(~kept).sum()}."
        )
    if not len(body.triangles):
        raise InputError("The mesh has no triangle. Save the body as a mesh of triangles.")


def _keep(body: Mended, kept: Bools) -> None:
    """Only these triangles, and the points that they need."""
    used, number = np.unique(body.triangles[kept], return_inverse=True)
    body.points, body.triangles = body.points[used], number.reshape(-1, 3).astype(np.int32)


def _welded(body: Mended) -> None:
    """Points in one place become one; triangles without area between them go."""
    points, number = np.unique(body.points, axis=0, return_inverse=True)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if not size > 0.0:
        raise InputError("All points of the mesh are in one place. Save the body as a mesh of triangles.")
    axes = np.linalg.eigvalsh(np.cov(points.T))
    if axes[0] <= _FLAT**2 * axes[2]:
        raise InputError("The mesh is flat. Give a closed body, or a drawing for two equal panels.")
    pairs = kd_tree(points).query_pairs(_ONE * size, output_type="ndarray")
    first = first_of_each(len(points), pairs)
    triangles = first[number.ravel()[body.triangles]]
    distinct = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    body.points, body.triangles = points, triangles.astype(np.int32)
    if not distinct.any():
        raise InputError("No triangle of the mesh has an area. Save the body as a mesh of triangles.")
    _keep(body, distinct)


def _without_doubles(body: Mended) -> None:
    """Of triangles between the same points one is kept."""
    _, first = np.unique(np.sort(body.triangles, axis=1), axis=0, return_index=True)
    left_out = len(body.triangles) - len(first)
    if left_out:
        body.notes.append(f"Triangles of the mesh that lay on others were left out: {left_out}.")
        _keep(body, np.sort(first))


def _without_walls(body: Mended) -> None:
    """Without sheets that stand on the surface, and walls inside it; touching bodies get own points."""
    if not junctions(body.triangles).crowded.any():
        return
    kept = without_walls(body.points, body.triangles)
    if not kept.all():
        body.notes.append(
            "Triangles of the mesh that stood on its surface, or were walls inside it, were left out:"
            f" {(~kept).sum()}."
        )
        _keep(body, kept)
    if junctions(body.triangles).crowded.any():
        first = parted(body.points, body.triangles)
        corners, number = np.unique(first, return_inverse=True)
        body.points = body.points[body.triangles.ravel()[corners]]
        body.triangles = number.reshape(-1, 3).astype(np.int32)


def _oriented(body: Mended) -> None:
    """Triangles beside each other run the same way round; InputError where they cannot."""
    known = junctions(body.triangles)
    crowded = np.flatnonzero(known.crowded)
    if len(crowded):
        place = _place(body.points[half_edges(body.triangles)[crowded[0], 0]])
        raise InputError(
            f"Edges of the mesh at which more than two triangles meet: {(known.counts > 2).sum()}, one of"
            f" them at ({place}) of the mesh. Repair it in the program that it comes from, so that it is the"
            " surface of a solid."
        )
    order = np.argsort(known.edge, kind="stable")
    start = (np.cumsum(known.counts) - known.counts)[known.counts == 2]
    one, other = order[start], order[start + 1]
    ahead = half_edges(body.triangles)
    same = ahead[one, 0] != ahead[other, 0]
    flipped = _flips(len(body.triangles), one // 3, other // 3, same)
    if flipped is None:
        raise InputError(
            "The surface of the mesh has no outside, as a Moebius strip. Give the mesh of a solid."
        )
    body.triangles = np.where(flipped[:, None], body.triangles[:, ::-1], body.triangles).astype(np.int32)
    turned = int(min(flipped.sum(), (~flipped).sum()))
    if turned:
        body.notes.append(f"Triangles of the mesh that were the wrong way round were turned: {turned}.")


def _flips(count: int, one: Indices, other: Indices, same: Bools) -> Bools | None:
    """Which triangles (count,) to turn so that all pairs agree that agree now where same; None if none do.

    Each triangle is taken twice, as it is and turned: what hangs together then agrees.
    """
    there, back = np.where(same, other, other + count), np.where(same, other + count, other)
    part = connected_parts(2 * count, np.concatenate([one, one + count]), np.concatenate([there, back]))
    if (part[:count] == part[count:]).any():
        return None
    return part[:count] > part[count:]


def _own_vertices(body: Mended) -> None:
    """Parts that touch in a point alone get a point each."""
    twin = twins(body.triangles)
    first = first_corners(twin, twin >= 0)
    corners, number = np.unique(first, return_inverse=True)
    body.points = body.points[body.triangles.ravel()[corners]]
    body.triangles = number.reshape(-1, 3).astype(np.int32)


def _largest(body: Mended) -> None:
    """Of several bodies the largest."""
    labels = _components(body)
    if labels.max() > 0:
        sizes = np.bincount(labels, np.linalg.norm(area_vectors(body.points, body.triangles), axis=1))
        body.notes.append(
            f"Of the bodies of the mesh only the largest is made; all in all there are: {len(sizes)}."
        )
        _keep(body, labels == np.argmax(sizes))


def _components(body: Mended) -> Ints:
    ends = half_edges(body.triangles)
    return connected_parts(len(body.points), ends[:, 0], ends[:, 1])[body.triangles[:, 0]]


def _closed(body: Mended) -> None:
    """Small holes are filled; InputError for large ones."""
    filled = filled_holes(body.points, body.triangles)
    body.points, body.triangles = filled.points, filled.triangles
    if filled.closed:
        body.notes.append(f"Holes of the mesh that were closed: {filled.closed}.")


def _outside(body: Mended) -> None:
    """Counter-clockwise seen from outside; InputError for a flat body."""
    volume = enclosed_volume(body.points, body.triangles)
    area = np.linalg.norm(area_vectors(body.points, body.triangles), axis=1).sum()
    size = np.linalg.norm(np.ptp(body.points, axis=0))
    if not abs(volume) > _FLAT * area * size:
        raise InputError(
            f"The body of the mesh is flat: it encloses {number_text(100.0 * abs(volume) / (area * size))} %"
            " of its size. Give a closed body, or a drawing for two equal panels."
        )
    if volume < 0.0:
        body.triangles = body.triangles[:, ::-1].copy()


_FIRST = (_finite, _welded, _without_doubles, _without_walls)
_STEPS = (*_FIRST, _oriented, _own_vertices, _largest, _closed, _outside)


def uncrossed(body: Mended) -> None:
    """Cut out where a closed body crosses itself, and close the holes; told where that does not help."""
    crossed = crossing_triangles(body.points, body.triangles)
    if not len(crossed):
        return
    for rings in range(_RINGS):
        gone = np.zeros(len(body.triangles), dtype=bool)
        gone[crossed] = True
        for _ in range(rings):
            touched = np.zeros(len(body.points), dtype=bool)
            touched[body.triangles[gone]] = True
            gone |= touched[body.triangles].any(axis=1)
        if gone.mean() > _CUT_OUT:
            break
        tried = Mended(body.points, body.triangles)
        _keep(tried, ~gone)
        try:
            for step in (_own_vertices, _largest, _closed, _outside):
                step(tried)
        except InputError:
            continue
        if not len(crossing_triangles(tried.points, tried.triangles)):
            body.points, body.triangles = tried.points, tried.triangles
            body.notes.append(f"Triangles that crossed others were cut out, and closed: {gone.sum()}.")
            return
    place = _place(body.points[body.triangles[crossed[0], 0]])
    body.notes.append(
        f"The surface crosses itself, at ({place}) of the mesh. Film cannot follow it there. Triangles that"
        f" cross others: {len(crossed)}."
    )


def _place(point: Floats) -> str:
    return ", ".join(map(number_text, point.tolist()))
