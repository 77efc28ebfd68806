# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that are laid flat exactly, after their triangles were split."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.splines import through
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.nearest_surface import nearest_shares
from BalloonWorkbench.core.targets.refine import Split
from BalloonWorkbench.core.targets.target import Division, FaceFlats
from BalloonWorkbench.core.types import Floats

#: Where a curve is known between its ends.
_BETWEEN = np.array([0.25, 0.5, 0.75])


def carried_flats(division: Division, split: Split) -> FaceFlats | None:
    """The places of the split triangles on the flat film; curves are split where their edges are."""
    flats, target = division.flats, division.target
    if flats is None:
        return None
    corners = flats.corners[split.origin]
    before = target.triangles[split.origin]
    changed = np.flatnonzero((before != split.triangles).any(axis=1))
    own = np.repeat(changed, 3)
    vertices = split.triangles[changed].ravel()
    shares = nearest_shares(split.points[vertices], target.points[before[own]])
    corners[changed] = np.einsum("kc,kcd->kd", shares, flats.corners[split.origin[own]]).reshape(-1, 3, 2)
    numbers = {tuple(ends): k for k, ends in enumerate(half_edges(split.triangles).tolist())}
    within: dict[int, list[int]] = {}
    for triangle in changed.tolist():
        within.setdefault(int(split.origin[triangle]), []).append(triangle)
    bent: list[int] = []
    between: list[Floats] = []
    for edge, curve in zip(flats.bent.tolist(), flats.between):
        start, end = _ends(division, edge)
        if (start, end) in numbers:
            bent.append(numbers[start, end])
            between.append(curve)
            continue
        parts = within[edge // 3]
        middle = _middle(split, parts, start, end, len(target.points))
        at = _share(split.points[[start, middle, end]])
        ends = flats.corners[edge // 3, [edge % 3, (edge + 1) % 3]]
        whole = np.concatenate([ends[:1], curve, ends[1:]])
        place = (through(np.array([at])) @ whole)[0]
        for triangle in parts:
            corners[triangle][split.triangles[triangle] == middle] = place
        bent += [numbers[start, middle], numbers[middle, end]]
        between += [through(each) @ whole for each in (at * _BETWEEN, at + (1.0 - at) * _BETWEEN)]
    order = np.argsort(bent, kind="stable")
    curves = np.array(between, dtype=np.float64).reshape(-1, 3, 2)
    return FaceFlats(corners, np.array(bent, dtype=np.intp)[order], curves[order])


def _ends(division: Division, edge: int) -> tuple[int, int]:
    """The vertices of a half-edge."""
    triangle = division.target.triangles[edge // 3]
    return int(triangle[edge % 3]), int(triangle[(edge + 1) % 3])


def _middle(split: Split, parts: list[int], start: int, end: int, count: int) -> int:
    """The new vertex on an edge among the parts of its triangle; before there were so many vertices."""
    new = np.unique(split.triangles[parts])
    new = new[new >= count]
    ahead = split.points[end] - split.points[start]
    off = np.linalg.norm(np.cross(split.points[new] - split.points[start], ahead), axis=1)
    return int(new[np.argmin(off)])


def _share(line: Floats) -> float:
    """How far along a line (3, 3) of three points its middle one lies, of its length."""
    one, other = np.linalg.norm(np.diff(line, axis=0), axis=1).tolist()
    return float(one / (one + other))
