# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and lines put into the triangles of a division, whose surface and panels stay what they are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.seam_edits.carried_flats import carried_flats
from BalloonWorkbench.core.seam_edits.paths import SurfacePath
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.nearest_surface import nearest_shares
from BalloonWorkbench.core.targets.refine import Split, split_edges
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import place_text

#: A vertex, or an edge, so near to a point is taken for it: as a part of the triangle, and of the diagonal.
_ON, ON_DIAGONAL = 0.03, 1e-3


def edge_keys(edges: Ints, count: int) -> Ints:
    """One number (k,) for each edge (k, 2) between so many vertices, whichever way it runs."""
    return np.asarray(np.sort(edges, axis=1).astype(np.int64) @ (count, 1))


def nearest_place(target: Target, place: Floats, allowed: Bools | None = None) -> tuple[int, Floats, float]:
    """The triangle nearest to a place (3,), the shares (3,) of its corners there, and how far it is [m].

    allowed  (m,) triangles that are looked at; None: all
    """
    own = np.arange(len(target.triangles)) if allowed is None else np.flatnonzero(allowed)
    corners = target.points[target.triangles[own]]
    shares = nearest_shares(np.broadcast_to(place, (len(own), 3)), corners)
    away = np.linalg.norm(np.einsum("kc,kcd->kd", shares, corners) - place, axis=1)
    best = int(np.argmin(away))
    return int(own[best]), shares[best], float(away[best])


def with_point(division: Division, triangle: int, shares: Floats) -> tuple[Division, int]:
    """The division with a vertex at shares (3,) of a triangle's corners, or near by, and the vertex."""
    target = division.target
    corners = target.triangles[triangle]
    spot = shares @ target.points[corners]
    near = ON_DIAGONAL * target.diagonal
    if shares.max() > 1.0 - _ON and np.linalg.norm(target.points[corners] - spot, axis=1).min() < near:
        return division, int(corners[np.argmax(shares)])
    count = len(target.points)
    least = int(np.argmin(shares))
    if shares[least] < min(_ON, near / _height(target.points[corners], least)):
        edge = 3 * triangle + (least + 1) % 3
        kept = np.where(np.arange(3) == least, 0.0, shares)
        marked = np.zeros(target.triangles.size, dtype=bool)
        marked[[edge, target.twins[edge]]] = True
        places = np.broadcast_to((kept / kept.sum()) @ target.points[corners], (len(marked), 3))
        return _split(division, split_edges(target.points, target.triangles, marked, places)), count
    a, b, c = corners
    points = np.concatenate([target.points, [spot]])
    parts = np.array([(a, b, count), (b, c, count), (c, a, count)], dtype=np.int32)
    triangles = np.insert(np.delete(target.triangles, triangle, axis=0), [triangle] * 3, parts, axis=0)
    origin = np.repeat(
        np.arange(len(target.triangles)), np.where(np.arange(len(target.triangles)) == triangle, 3, 1)
    )
    return _split(division, Split(points, triangles.astype(np.int32), origin.astype(np.int32))), count


def _height(corners: Floats, corner: int) -> float:
    """How far a corner of a triangle (3, 3) is from its other side [m]."""
    one, other = (corners[(corner + step) % 3] for step in (1, 2))
    along = other - one
    double = np.linalg.norm(np.cross(along, corners[corner] - one))
    return float(double / max(float(np.linalg.norm(along)), 1e-300))


def with_path(division: Division, path: SurfacePath) -> tuple[Division, Ints]:
    """The division with a path along edges, and the vertices (k,) of that.

    InputError for one that passes an edge twice.
    """
    target = division.target
    count = len(target.points)
    ends = np.sort(path.ends, axis=1)
    shares = np.where(path.ends[:, 0] > path.ends[:, 1], 1.0 - path.shares, path.shares)
    lengths = np.linalg.norm(target.points[ends[:, 0]] - target.points[ends[:, 1]], axis=1)
    near = np.minimum(_ON, ON_DIAGONAL * target.diagonal / np.maximum(lengths, 1e-300))
    first, last = shares < near, shares > 1.0 - near
    on_edge = ~(first | last) & (ends[:, 0] != ends[:, 1])
    edges = half_edges(target.triangles)
    keys, crossed = edge_keys(edges, count), edge_keys(ends, count)
    known, at = np.unique(crossed[on_edge], return_index=True)
    if len(known) < on_edge.sum():
        place = place_text(path.places(target.points)[len(path.shares) // 2])
        raise InputError(f"A seam near {place} would pass the same place twice. Draw it in two parts.")
    share = np.zeros(len(keys))
    marked = np.isin(keys, known)
    share[marked] = shares[on_edge][at][np.searchsorted(known, keys[marked])]
    low, high = np.sort(edges, axis=1).T
    places = target.points[low] + share[:, None] * (target.points[high] - target.points[low])
    split = split_edges(target.points, target.triangles, marked, places)
    line = np.where(last, ends[:, 1], ends[:, 0])
    line[on_edge] = count + np.searchsorted(known, crossed[on_edge])
    line = line[np.append(True, line[1:] != line[:-1])]
    return _split(division, split), line.astype(np.int32)


def split_division(division: Division, split: Split) -> Division:
    """The same panels on triangles that were split: new points lie behind the old ones."""
    return _split(division, split)


def _split(division: Division, split: Split) -> Division:
    target = replace(division.target, points=split.points, triangles=split.triangles)
    count = len(division.target.points)
    cuts = _in_parts(division.cuts, count, split) if len(division.cuts) else division.cuts
    flats = carried_flats(division, split)
    return Division(target, division.panels[split.origin], division.names, cuts, flats)


def _in_parts(cuts: Ints, count: int, split: Split) -> Ints:
    """Edges (k, 2), those that got a point as two of them; before there were so many points."""
    edges = half_edges(split.triangles)
    there = np.isin(edge_keys(cuts, len(split.points)), edge_keys(edges, len(split.points)))
    parts = [cuts[there]]
    for one, other in cuts[~there].tolist():
        beside = [edges[(edges[:, 0] == end) & (edges[:, 1] >= count), 1] for end in (one, other)]
        middles = np.intersect1d(*beside)
        away = split.points[middles]
        ahead = split.points[other] - split.points[one]
        off = np.linalg.norm(np.cross(away - split.points[one], ahead), axis=1)
        middle = int(middles[np.argmin(off)])
        parts.append(np.array([(one, middle), (middle, other)], dtype=np.int32))
    return np.concatenate(parts).astype(np.int32)
