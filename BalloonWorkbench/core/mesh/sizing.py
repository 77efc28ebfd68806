# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fine the mesh has to be where: the wanted size, smaller in thin parts, changing gradually."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.polyline import arc_lengths, line_lengths, point_on
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.mesh.thickness import fine_spacing, thickness
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, place_text

#: Elements wanted across a thin part; where thin parts are few, and that costs no more than this share of all
#: vertices; and the fewest that will do.
_ACROSS, _MORE_ACROSS, _COST, _FEWEST_ACROSS = 4.0, 5.0, 0.2, 2.0
#: How much smaller than asked elements get for that: in thin parts, and in tips that taper off anyway.
_CHANNEL_SHARE, _TIP_SHARE = 0.25, 0.5
_MOST_SAMPLES = 20_000
#: Growth of the size with distance.
_GRADING = 0.25
#: The pull of the film on a hole gathers in a line along its rim, narrower than an element: the size there
#: and how it grows. (A ring's volume is 1.2 % too small on even elements, 0.6 % with these.)
_HOLE_SHARE, _HOLE_GRADING = 0.25, 0.35
_SAMPLES_PER_SIZE = 6.0
#: No size is finer than this, in quarter octaves: an edge of no length asks for no end of vertices.
_FINEST = 24
#: More vertices are surely a slip of the unit.
_MOST_VERTICES = 1_000_000


@dataclass(frozen=True)
class SizeField:
    """Wanted edge length: `size`, limited by sources whose influence fades with distance.

    groups  (edge length [m], points (k, 2) where it is needed, growth of the size with their distance)
    """

    size: float
    groups: tuple[tuple[float, Floats, float], ...] = ()

    @property
    def smallest(self) -> float:
        """Smallest edge length anywhere [m]."""
        return min([self.size, *(length for length, *_ in self.groups)])

    def at(self, points: Floats) -> Floats:
        """Edge lengths (n,) at points (n, 2)."""
        sizes = np.full(len(points), self.size)
        for length, sources, grading in self.groups:
            reach = (self.size - length) / grading
            distance, _ = kd_tree(sources).query(points, distance_upper_bound=reach)
            np.minimum(sizes, length + grading * distance, out=sizes)
        return sizes

    def limited(self, points: Floats, lengths: Floats, grading: float = _GRADING) -> SizeField:
        """The field with further sources: at points (n, 2) at most lengths (n,)."""
        needed = lengths < 0.97 * self.size
        # Rounded down to quarter octaves: a lookup is then a few tree queries.
        step = np.ceil(4.0 * np.log2(self.size / lengths[needed]) - 1e-9).astype(int)
        step = np.minimum(step, _FINEST)
        groups = tuple(
            (self.size * 2.0 ** (-k / 4.0), points[needed][step == k], grading) for k in np.unique(step)
        )
        return SizeField(self.size, self.groups + groups)


def size_field(outline: Outline, size: float, rough: bool = False) -> SizeField:
    """The sizes for an outline; MeshError where `size` [m] is out of all proportion or too coarse.

    rough  thin parts are looked for in steps of the size, whatever the outline has: several times as quick
    """
    _check_proportion(outline, size)
    spacing = size / _SAMPLES_PER_SIZE if rough else _sample_spacing(outline, size)
    walls = thickness(outline, 1.1 * _MORE_ACROSS * size, spacing)
    thinnest, place = walls.thinnest
    mean = 2.0 * outline.area / outline.perimeter
    if mean < thinnest:  # walls nearer to each other than the samples do not see each other
        thinnest, place = mean, walls.points[0]
    coarsest = thinnest / (_FEWEST_ACROSS * _CHANNEL_SHARE)
    if size > coarsest:
        raise MeshError(
            f"The shape is only {length_text(thinnest, 2)} thick near {place_text(place)}, too thin for a"
            f" mesh of {length_text(size)}: make it thicker there, or use a mesh size of at most"
            f" {length_text(0.9 * coarsest, 2)}.",
            (float(place[0]), float(place[1])),
        )
    share = np.where(walls.channel, _CHANNEL_SHARE, _TIP_SHARE)
    lengths = _lengths(outline, walls.across, share * size, size)
    field = SizeField(size).limited(walls.points, lengths)
    for loop in outline.loops:  # a small hole still gets eight edges
        points = evenly(loop, size)
        field = field.limited(points, np.full(len(points), arc_lengths(loop)[-1] / 8.0))
    if not rough:
        for hole in outline.holes:
            rim = evenly(hole, size / _SAMPLES_PER_SIZE)
            field = field.limited(rim, np.full(len(rim), _HOLE_SHARE * size), _HOLE_GRADING)
    return _beside_welds(outline, field)


def _lengths(outline: Outline, across: Floats, least: Floats, size: float) -> Floats:
    """Edge lengths (n,) for walls so thick; arms that hardly fill lean one way or another on few elements."""
    coarse, fine = (np.clip(across / elements, least, size) for elements in (_ACROSS, _MORE_ACROSS))
    spacing = outline.perimeter / len(across)
    thick = np.where(np.isfinite(across), across, 0.0)
    more = 0.5 * spacing * float((thick * (fine**-2 - coarse**-2)).sum())
    return fine if more < _COST * outline.area / size**2 else coarse


def _beside_welds(outline: Outline, field: SizeField) -> SizeField:
    """The field with smaller elements between a weld and what runs beside it."""
    step = field.size / _SAMPLES_PER_SIZE
    welds = []
    for weld in outline.welds:
        lengths = line_lengths(weld)
        count = int(np.ceil(lengths[-1] / step)) + 1
        welds.append(point_on(weld, lengths, np.linspace(0.0, lengths[-1], count)))
    walls = [evenly(loop, step) for loop in outline.loops]
    for number, points in enumerate(welds):
        others = np.concatenate([*walls, *welds[:number], *welds[number + 1 :]])
        away, _ = kd_tree(others).query(points)
        field = field.limited(points, np.clip(away / _ACROSS, _CHANNEL_SHARE * field.size, field.size))
    return field


def size_for(outline: Outline, vertices: int) -> float:
    """The mesh size that gives about so many vertices, up to four times as many for thin parts [m]."""
    size = _even_size(outline, vertices)
    walls = thickness(outline, _ACROSS * size, _sample_spacing(outline, size))
    thin = 0.9 * walls.thinnest[0] / (_FEWEST_ACROSS * _CHANNEL_SHARE)
    return min(size, max(thin, 0.5 * size))


def _sample_spacing(outline: Outline, size: float) -> float:
    """Fine enough for the mesh and the thinnest part."""
    around = outline.perimeter
    return fine_spacing(outline, size / _SAMPLES_PER_SIZE, around / _MOST_SAMPLES)


def _even_size(outline: Outline, vertices: int) -> float:
    # Equilateral triangles: one vertex per sqrt(3)/2 size^2, and half a vertex more per seam edge.
    half = 0.5 * outline.perimeter
    cell = 2.0 / np.sqrt(3.0) * outline.area
    return float(half + np.sqrt(half * half + 4.0 * cell * vertices)) / (2.0 * vertices)


def _check_proportion(outline: Outline, size: float) -> None:
    if not (np.isfinite(size) and size > 0.0):
        raise MeshError(f"The mesh size is {length_text(size)}: give one above 0.")
    extent = max(outline.size)
    if size > 0.5 * extent:
        raise MeshError(
            f"A mesh of {length_text(size)} is too coarse for a shape of {length_text(extent)}:"
            f" use at most {length_text(0.1 * extent)}."
        )
    finest = _even_size(outline, _MOST_VERTICES)
    if size < finest:
        raise MeshError(
            f"A mesh of {length_text(size)} would need more than a million vertices for a shape of"
            f" {length_text(extent)}: use at least {length_text(finest)}."
        )
