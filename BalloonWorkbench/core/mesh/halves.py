# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a symmetric outline: its left half is meshed and mirrored, so that the balloon does not lean.

An arm on an uneven mesh bends a little to one side, and no symmetric pattern could straighten it.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.mesh.boundary import seam_points
from BalloonWorkbench.core.mesh.lattice import lattice
from BalloonWorkbench.core.mesh.relax import SWEEPS, relax
from BalloonWorkbench.core.mesh.sizing import size_field
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import Mirror
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Floats, Ints

_ON_AXIS = 1e-9  # of the size


@dataclass(frozen=True)
class _Half:
    """What lies on the left of the axis.

    rim    its outer boundary (n, 2): halves of the loops across the axis, with the axis between them
    across the loops across the axis, in the order of their halves along the rim
    starts where each half begins in the rim, where it ends, where the next begins ...
    holes  the loops on the left, and twins: for each the loop that is its image
    """

    rim: Floats
    across: tuple[int, ...]
    starts: Ints
    holes: tuple[int, ...]
    twins: tuple[int, ...]


def triangulate_mirrored(outline: Outline, size: float, mirror: Mirror) -> Panel | None:
    """The panel of `triangulate` for an exactly symmetric outline, its right half the image of the left one.

    None where the loops do not meet the axis as those of such an outline do, or where there are welds.

    Raises MeshError as `triangulate` does.
    """
    half = None if outline.welds or outline.spots else _left(outline, mirror)
    if half is None:
        return None
    field = size_field(outline, size)
    loops = (half.rim, *(outline.loops[number] for number in half.holes))
    seams, field = seam_points(loops, field, half.starts)
    counts = np.cumsum([0, *(len(seam) for seam in seams)])
    chains = tuple(np.arange(*pair, dtype=np.int32) for pair in pairwise(counts))
    points, triangles = relax(np.concatenate([*seams, lattice(seams, field)]), chains, field, (), SWEEPS)
    return _Whole(half, _numbers(half, seams[0]), mirror, points, chains).panel(triangles, len(outline.loops))


def _left(outline: Outline, mirror: Mirror) -> _Half | None:
    """The left half; None where loops do not meet the axis as those of a symmetric outline do."""
    near = _ON_AXIS * max(outline.size)
    cut: list[tuple[int, Floats, Floats]] = []  # loop, its half, where on the axis that begins and ends
    beside: dict[bool, list[int]] = {False: [], True: []}  # loops by whether they lie on the left
    for number, loop in enumerate(outline.loops):
        x, along = ((loop - mirror.point) @ mirror.frame).T
        if x.min() > -near or x.max() < near:
            beside[bool(x.mean() < 0.0)].append(number)
            continue
        on_axis = np.flatnonzero(np.abs(x) <= near)
        if len(on_axis) != 2:
            return None
        first, last = on_axis if x[on_axis[0] + 1] < 0.0 else (on_axis[1], on_axis[0] + len(loop))
        cut.append((number, loop[np.arange(first, last + 1) % len(loop)], along[[first, last % len(loop)]]))
    if len(beside[True]) != len(beside[False]) or not cut or cut[0][0] != 0:
        return None
    # along the axis from where the outer half ends, back to where it begins
    begin, end = cut[0][2]
    cut[1:] = sorted(cut[1:], key=lambda part: abs(float(part[2][0]) - end))
    stops = np.concatenate([[end], *(ends for _, _, ends in cut[1:]), [begin]])
    if np.any(np.diff(stops) * (begin - end) <= 0.0):
        return None
    lengths = np.cumsum([0, *(len(part) for _, part, _ in cut)])
    starts = np.stack([lengths[:-1], lengths[1:] - 1], axis=1).ravel()
    twins = _twins(outline, mirror, beside[True], beside[False])
    rim = np.concatenate([part for _, part, _ in cut])
    return _Half(rim, tuple(number for number, _, _ in cut), starts, tuple(beside[True]), twins)


def _twins(outline: Outline, mirror: Mirror, left: list[int], right: list[int]) -> tuple[int, ...]:
    """For each loop on the left the one on the right that is its image."""
    images: list[int] = []
    for number in left:
        image = mirror.reflect(outline.loops[number]).mean(axis=0)
        rest = [other for other in right if other not in images]
        images.append(
            min(rest, key=lambda other: float(np.linalg.norm(outline.loops[other].mean(0) - image)))
        )
    return tuple(images)


def _numbers(half: _Half, rim: Floats) -> list[int]:
    """Where in the sampled rim (n, 2) the halves begin and end."""
    return [int(np.argmin(np.linalg.norm(rim - half.rim[start], axis=1))) for start in half.starts]


class _Whole:
    """Numbers the vertices of both halves: seams first, loop by loop, then the axis, then what is inside."""

    def __init__(
        self, half: _Half, at: list[int], mirror: Mirror, points: Floats, chains: tuple[Ints, ...]
    ) -> None:
        self._half, self._at, self._mirror, self._points, self._chains = half, at, mirror, points, chains
        self._mine = np.full(len(points), -1, dtype=np.int32)  # the number of a vertex, and of its image
        self._image = np.full(len(points), -1, dtype=np.int32)
        self._added_points: list[Floats] = []
        self._count = 0

    def panel(self, triangles: Ints, loops: int) -> Panel:
        """Both halves as one."""
        seams = tuple(self._loop(number) for number in range(loops))
        self._axis(np.array([k for k in self._chains[0] if self._mine[k] < 0], dtype=np.int32))
        inside = np.flatnonzero(self._mine + self._image == -2)
        self._mine[inside] = self._added(self._points[inside])
        self._image[inside] = self._added(self._mirror.reflect(self._points[inside]))
        both = np.concatenate([self._mine[triangles], self._image[triangles][:, [0, 2, 1]]])
        return Panel(np.concatenate(self._added_points), both, seams)

    def _loop(self, number: int) -> Ints:
        """The seam along a loop: a half and its image, a loop on the left, or the image of such a one."""
        half, at, points = self._half, self._at, self._points
        if number in half.across:
            index = half.across.index(number)
            mine = np.arange(at[2 * index], at[2 * index + 1] + 1)
            self._axis(mine[[0]])
            inner = mine[1:-1]
            self._mine[inner] = self._added(points[inner])
            self._axis(mine[[-1]])
            self._image[inner[::-1]] = self._added(self._mirror.reflect(points[inner])[::-1])
            return np.concatenate([self._mine[mine], self._image[inner[::-1]]])
        if number in half.holes:
            mine = self._chains[1 + half.holes.index(number)]
            self._mine[mine] = self._added(points[mine])
            return self._mine[mine]
        mine = self._chains[1 + half.twins.index(number)][::-1]
        self._image[mine] = self._added(self._mirror.reflect(points[mine]))
        return self._image[mine]

    def _axis(self, mine: Ints) -> None:
        """Vertices on the axis are their own images."""
        points = self._points[mine]
        self._mine[mine] = self._image[mine] = self._added(0.5 * (points + self._mirror.reflect(points)))

    def _added(self, points: Floats) -> Ints:
        """Numbers for vertices at these points (n, 2)."""
        self._added_points.append(points)
        self._count += len(points)
        return np.arange(self._count - len(points), self._count, dtype=np.int32)
