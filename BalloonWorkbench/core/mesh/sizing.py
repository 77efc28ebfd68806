# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fine the mesh has to be where: the wanted size, smaller in thin parts, changing gradually."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import MeshError, MissingPackageError
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Elements wanted across a thin part, and how much smaller than asked they may get for it.
ELEMENTS_ACROSS = 4.0
SMALLEST_SHARE = 0.25
#: Growth of the size per distance.
GRADING = 0.25
_SAMPLES_PER_SIZE = 6
#: Opposite walls face each other: a ball touching both sees them this far apart [rad].
_FACING = np.radians(150.0)
_PARALLEL = np.radians(165.0)
_BUMP = np.radians(60.0)


@dataclass(frozen=True)
class SizeField:
    """Wanted edge length: `size`, limited by sources whose influence fades with distance.

    groups  pairs of (edge length [m], points (k, 2) where it is needed)
    """

    size: float
    groups: tuple[tuple[float, Floats], ...] = ()

    @property
    def smallest(self) -> float:
        """Smallest edge length anywhere [m]."""
        return min([self.size, *(length for length, _ in self.groups)])

    def at(self, points: Floats) -> Floats:
        """Edge lengths (n,) at points (n, 2)."""
        tree_class = kd_tree()
        sizes = np.full(len(points), self.size)
        for length, sources in self.groups:
            reach = (self.size - length) / GRADING
            distance, _ = tree_class(sources).query(points, distance_upper_bound=reach)
            np.minimum(sizes, length + GRADING * distance, out=sizes)
        return sizes

    def limited(self, points: Floats, lengths: Floats) -> SizeField:
        """The field with further sources: at points (n, 2) at most lengths (n,)."""
        needed = lengths < 0.97 * self.size
        if not needed.any():
            return self
        # Few groups, each rounded down, make a lookup a few tree queries.
        steps = np.ceil(np.log(self.size / lengths[needed]) / np.log(2.0) * 4.0 - 1e-9).astype(int)
        groups = [(self.size * 2.0 ** (-step / 4.0), points[needed][steps == step]) for step in np.unique(steps)]
        return SizeField(self.size, (*self.groups, *groups))


@dataclass(frozen=True)
class Thickness:
    """Distance between facing walls at samples of the boundary.

    points     (n, 2) m, on the boundary
    thickness  (n,) m; infinite where no wall faces the sample within reach
    channel    (n,) the walls run side by side there (not a tip that tapers off)
    """

    points: Floats
    thickness: Floats
    channel: Bools


def kd_tree():  # type: ignore[no-untyped-def]
    """scipy's k-d tree, imported when it is needed."""
    try:
        from scipy.spatial import cKDTree
    except ImportError as error:
        raise MissingPackageError("Meshing needs scipy: install it (pip install scipy).") from error
    return cKDTree


def dense(loop: Floats, spacing: float) -> Floats:
    """Points (k, 2) at even distances of at most about `spacing` along a closed loop."""
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    count = max(12, int(np.ceil(along[-1] / spacing)))
    marks = np.arange(count) * (along[-1] / count)
    return np.stack([np.interp(marks, along, closed[:, k]) for k in range(2)], axis=1)


def thickness(outline: Outline, reach: float, spacing: float) -> Thickness:
    """How far the outline's walls are apart, where that is below about `reach` [m].

    Largest inner tangent balls by shrinking (Ma, Bae & Choi, The Visual Computer 28 (2012) 7-19), from
    boundary samples `spacing` apart.
    """
    loops = [dense(loop, spacing) for loop in outline.loops]
    points = np.concatenate(loops)
    normals = np.concatenate([_inward(loop) for loop in loops])
    tree = kd_tree()(points)
    count = len(points)
    radius = np.full(count, 0.5 * reach)
    partner = np.full(count, -1)
    active = np.arange(count)
    for _ in range(30):
        centre = points[active] + radius[active, None] * normals[active]
        distance, nearest = tree.query(centre)
        shrinks = distance < radius[active] * (1.0 - 1e-6)
        active, centre, nearest = active[shrinks], centre[shrinks], nearest[shrinks]
        gap = points[nearest] - points[active]
        ahead = (gap * normals[active]).sum(axis=1)
        smaller = (gap**2).sum(axis=1) / np.maximum(2.0 * ahead, 1e-300)
        new_centre = points[active] + smaller[:, None] * normals[active]
        # A wall seen under a small angle is a bump beside the sample, not the other side.
        wall = (ahead > 0.0) & (_separation(points[active], points[nearest], new_centre) > _BUMP)
        active = active[wall]
        radius[active], partner[active] = smaller[wall], nearest[wall]
        if not len(active):
            break
    found = np.flatnonzero(partner >= 0)
    centre = points[found] + radius[found, None] * normals[found]
    seen = _separation(points[found], points[partner[found]], centre)
    across = np.full(count, np.inf)
    facing = seen > _FACING
    across[found[facing]] = 2.0 * radius[found[facing]]
    channel = np.zeros(count, dtype=bool)
    parallel = found[seen > _PARALLEL]
    channel[parallel] = ~_tapers(loops, parallel, partner[parallel], across[parallel])
    return Thickness(points, across, channel)


def size_field(outline: Outline, size: float) -> SizeField:
    """The sizes for an outline; MeshError where even a quarter of `size` is too coarse."""
    walls = thickness(outline, 1.1 * ELEMENTS_ACROSS * size, size / _SAMPLES_PER_SIZE)
    smallest = SMALLEST_SHARE * size
    narrow = np.where(walls.channel, walls.thickness, np.inf)
    worst = int(np.argmin(narrow))
    if narrow[worst] < 2.0 * smallest:
        x, y = 1e3 * walls.points[worst]
        raise MeshError(
            f"The shape is only {1e3 * narrow[worst]:.2g} mm thick near ({x:.1f}, {y:.1f}) mm, too thin for a mesh of"
            f" {1e3 * size:.3g} mm: make it thicker there or use a mesh size of at most"
            f" {1e3 * narrow[worst] / 2.0 / SMALLEST_SHARE * 0.95:.2g} mm."
        )
    field = SizeField(size).limited(walls.points, np.maximum(walls.thickness / ELEMENTS_ACROSS, smallest))
    for loop in outline.loops:
        around = float(np.linalg.norm(loop - np.roll(loop, 1, axis=0), axis=1).sum())
        points = dense(loop, size)
        field = field.limited(points, np.full(len(points), around / 8.0))
    return field


def thinnest(outline: Outline, reach: float) -> float:
    """Smallest distance of walls that run side by side, if below `reach`; else infinity [m]."""
    walls = thickness(outline, reach, reach / ELEMENTS_ACROSS / _SAMPLES_PER_SIZE)
    return float(np.min(np.where(walls.channel, walls.thickness, np.inf)))


def size_for(outline: Outline, vertices: int) -> float:
    """The mesh size that gives about so many vertices, finer where the outline would be too thin for it [m]."""
    perimeter = sum(float(np.linalg.norm(loop - np.roll(loop, 1, axis=0), axis=1).sum()) for loop in outline.loops)
    # Equilateral triangles: one vertex per sqrt(3)/2 size^2, and half a vertex more per seam edge.
    cell, half = outline.area * 2.0 / np.sqrt(3.0), perimeter / 2.0
    size = (half + np.sqrt(half * half + 4.0 * cell * vertices)) / (2.0 * vertices)
    return min(size, 0.9 * thinnest(outline, ELEMENTS_ACROSS * size) / (2.0 * SMALLEST_SHARE))


def _inward(loop: Floats) -> Floats:
    tangent = np.roll(loop, -1, axis=0) - np.roll(loop, 1, axis=0)
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    result: Floats = normal / np.maximum(length, np.finfo(float).tiny)
    return result


def _separation(p: Floats, q: Floats, centre: Floats) -> Floats:
    u, v = p - centre, q - centre
    product = np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1)
    cosine = (u * v).sum(axis=1) / np.maximum(product, np.finfo(float).tiny)
    angle: Floats = np.arccos(np.clip(cosine, -1.0, 1.0))
    return angle


def _tapers(loops: list[Floats], first: Ints, second: Ints, across: Floats) -> Bools:
    """Whether the piece cut off between two samples of one loop is a tip rather than a strip.

    A strip of length l holds across * l, a tapering tip half as much.
    """
    starts = np.cumsum([0, *(len(loop) for loop in loops)])
    owner = np.searchsorted(starts, first, side="right") - 1
    tapers = np.zeros(len(first), dtype=bool)
    for index, loop in enumerate(loops):
        mine = np.flatnonzero((owner == index) & (second >= starts[index]) & (second < starts[index + 1]))
        i, j = (np.sort([first[mine], second[mine]], axis=0) - starts[index]).astype(int)
        following = np.roll(loop, -1, axis=0)
        cross = loop[:, 0] * following[:, 1] - loop[:, 1] * following[:, 0]
        steps = np.linalg.norm(following - loop, axis=1)
        area, along = (np.concatenate([[0.0], np.cumsum(values)]) for values in (cross, steps))
        arc = along[j] - along[i]
        chord = loop[j, 0] * loop[i, 1] - loop[j, 1] * loop[i, 0]
        piece = 0.5 * np.abs(area[j] - area[i] + chord)
        other = 2.0 * arc > along[-1]
        piece = np.where(other, np.abs(0.5 * area[-1]) - piece, piece)
        arc = np.where(other, along[-1] - arc, arc)
        tapers[mine] = piece < 0.75 * across[mine] * 0.5 * arc
    return tapers
