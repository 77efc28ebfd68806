# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are projected along an axis onto a body, on all sides of it or on the near one."""

from __future__ import annotations

import itertools
from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.geometry.polyline import line_lengths
from BalloonWorkbench.core.geometry.vectors import cross, unit
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats

#: Places on the body along a line, at least so many on its diagonal.
_STEPS = 60
#: Times that the end of a line at the rim of a body is halved.
_HALVINGS = 24
_SAME = 1e-7  # of the diagonal: places that are one
_INSIDE = -1e-9  # shares of a triangle's corners within it


class _Rays(NamedTuple):
    """Rays along z: the body turned so that they are.

    corners  (m, 3, 3) of its triangles; back (3, 3) turns places back; size: its diagonal [m]
    """

    corners: Floats
    back: Floats
    size: float

    def depths(self, places: Floats) -> list[Floats]:
        """For each of places (k, 2) the depths (h,) at which the surface lies there, in their order."""
        a, ab, ac = self.corners[:, 0], *(self.corners[:, k] - self.corners[:, 0] for k in (1, 2))
        double = cross(ab, ac)
        steep = np.abs(double) < 1e-12 * self.size**2
        scale = np.where(steep, 1.0, double)
        depths = []
        for x, y in places:
            dx, dy = x - a[:, 0], y - a[:, 1]
            v = (dx * ac[:, 1] - dy * ac[:, 0]) / scale
            w = (dy * ab[:, 0] - dx * ab[:, 1]) / scale
            hit = ~steep & (v >= _INSIDE) & (w >= _INSIDE) & (v + w <= 1.0 - _INSIDE)
            depth = np.sort(a[hit, 2] + v[hit] * ab[hit, 2] + w[hit] * ac[hit, 2])
            kept = np.diff(depth, prepend=-np.inf) > _SAME * self.size
            depth = depth[kept]
            depths.append(depth)
        return depths


class ProjectedLine(NamedTuple):
    """Places (k, 3) m on the body along a projected line, and whether it ends where it began."""

    places: Floats
    closed: bool


def projected(target: Target, line: Floats, direction: Floats, *, near: bool) -> list[ProjectedLine]:
    """The lines on a body over which a line (k, 3) m lies, seen along a direction (3,); none where it misses.

    near  only those that are nearest to it along the direction
    """
    axis = unit(direction)
    across = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    back = np.stack([across, np.cross(axis, across), axis])
    rays = _Rays((target.points @ back.T)[target.triangles], back, target.diagonal)
    flat = line @ back.T
    dense = _dense(flat, target.diagonal / _STEPS)
    dense, depths = _with_rims(rays, dense)
    middle = 0.5 * (rays.corners[..., 2].min() + rays.corners[..., 2].max())
    runs = _Runs()
    closed = bool(np.linalg.norm((flat[0] - flat[-1])[:2]) <= _SAME * rays.size)
    runs.follow(dense, depths, float(flat[:, 2].mean()) > middle, closed)
    lines = runs.nearest() if near else runs.whole()
    return [ProjectedLine(np.array(run) @ back, closed) for run, closed in lines if len(run) > 1]


def _dense(line: Floats, step: float) -> Floats:
    """Points (n, 3) along a line, at most so far from each other; its own points are among them."""
    parts = [line[:1]]
    for one, other in itertools.pairwise(line):
        count = max(1, int(np.ceil(np.linalg.norm((other - one)[:2]) / step)))
        parts.append(one + (np.arange(1, count + 1) / count)[:, None] * (other - one))
    dense = np.concatenate(parts)
    kept = np.append(True, np.diff(line_lengths(dense[:, :2])) > 1e-3 * step)
    return dense[kept]


def _with_rims(rays: _Rays, dense: Floats) -> tuple[Floats, list[Floats]]:
    """Places (n, 3) with the depths at each, more of them where their number changes, found by halving.

    A ray that only touches the body, or an edge of it, has an odd number of depths, and is left out.
    """
    known = [(place, depth) for place, depth in zip(dense, rays.depths(dense[:, :2])) if len(depth) % 2 == 0]
    marked = known[:1]
    for one, other in itertools.pairwise(known):
        if len(one[1]) != len(other[1]):
            sides, ends = [one, other], [one[0], other[0]]
            for _ in range(_HALVINGS):
                middle = 0.5 * (ends[0] + ends[1])
                (depth,) = rays.depths(middle[None, :2])
                side = 0 if len(depth) == len(one[1]) else 1
                ends[side] = middle
                if len(depth) == len(sides[side][1]):
                    sides[side] = middle, depth
            marked += sides
        marked.append(other)
    return np.array([place for place, _ in marked]), [depth for _, depth in marked]


class _Runs:
    """Lines on the surface while they are followed, and which of their ends are joined.

    spots  of each run its places (3,), and whether each is the one near the line
    links  the end that an end goes on with: (run, 0 for its first or 1 for its last place)
    """

    def __init__(self) -> None:
        self.spots: list[list[tuple[Floats, bool]]] = []
        self.links: dict[tuple[int, int], tuple[int, int]] = {}

    def follow(self, dense: Floats, depths: list[Floats], last: bool, closed: bool) -> None:
        """All runs over places (n, 3) with their depths; where two meet the line turns round."""
        going: list[int] = []
        first: list[int] = []
        for number, (place, depth) in enumerate(zip(dense, depths)):
            spots = [
                (np.array([place[0], place[1], each]), k == (len(depth) - 1 if last else 0))
                for k, each in enumerate(depth)
            ]
            while len(going) > len(spots):
                k = _meeting([float(self.spots[run][-1][0][2]) for run in going])
                self.link((going[k], 1), (going[k + 1], 1))
                del going[k : k + 2]
            while len(going) < len(spots):
                k = _meeting([float(spot[2]) for spot, _ in spots]) if going or number else 0
                new = [len(self.spots), len(self.spots) + 1]
                self.spots += [[], []]
                if number:
                    self.link((new[0], 0), (new[1], 0))
                going[k:k] = new
            for run, spot in zip(going, spots):
                self.spots[run].append(spot)
            first = first if number else list(going)
        if closed and len(first) == len(going):
            for begun, ended in zip(first, going):
                self.link((begun, 0), (ended, 1))

    def link(self, one: tuple[int, int], other: tuple[int, int]) -> None:
        self.links[one], self.links[other] = other, one

    def whole(self) -> list[tuple[list[Floats], bool]]:
        """Each line with the runs that it consists of, and whether it is closed."""
        left, made = set(range(len(self.spots))), []
        free = [end for run in sorted(left) for end in ((run, 0), (run, 1)) if end not in self.links]
        for start in [*free, *((run, 0) for run in sorted(left))]:
            if start[0] not in left:
                continue
            line, end = [], start
            while True:
                run, side = end
                left.discard(run)
                own = [spot for spot, _ in self.spots[run]]
                line += own[::-1] if side else own
                going_on = self.links.get((run, 1 - side))
                if going_on is None or going_on[0] not in left:
                    break
                end = going_on
            made.append((line, going_on is not None))
        return made

    def nearest(self) -> list[tuple[list[Floats], bool]]:
        """The parts of the runs that are near the line."""
        made = []
        for run in self.spots:
            part: list[Floats] = []
            for spot, near in [*run, (np.zeros(3), False)]:
                if near:
                    part.append(spot)
                elif part:
                    made.append((part, False))
                    part = []
        return made


def _meeting(depths: list[float]) -> int:
    """The first of the two neighbours that are nearest to each other."""
    return int(np.argmin([other - one for one, other in itertools.pairwise(depths)]))
