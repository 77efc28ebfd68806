# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams and welds of a mesh: vertices evenly spaced along each loop and line, corners kept."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, extent, line_lengths, point_at, point_on
from BalloonWorkbench.core.geometry.vectors import turn
from BalloonWorkbench.core.mesh.sizing import SizeField
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import place_text

#: Turn within about an edge length that makes a corner [rad].
_CORNER = np.radians(30.0)
#: An end of a weld that is nearer to a loop is at it: relative to the outline, and in edges.
AT_RIM, _BESIDE = 6e-3, 0.6
_NONE: Ints = np.empty(0, dtype=np.int32)


@dataclass(frozen=True)
class Weld:
    """A weld's own vertices (k, 2), and the numbers of the seam vertices at which it begins and ends."""

    points: Floats
    begin: int | None
    end: int | None

    def chain(self, first: int) -> Ints:
        """Its vertices in order, where its own ones are numbered from `first`."""
        ends = [[] if at is None else [at] for at in (self.begin, self.end)]
        return np.array([*ends[0], *range(first, first + len(self.points)), *ends[1]], dtype=np.int32)


def seam_points(
    loops: tuple[Floats, ...], field: SizeField, fixed: Ints = _NONE
) -> tuple[tuple[Floats, ...], SizeField]:
    """Resampled loops (k, 2), in the order and sense given, and the field.

    fixed: points of the first loop that stay. Where the coarser loops would cross (a narrow slit) the field
    is refined. Raises MeshError when that does not help.
    """

    def seams_on(field: SizeField) -> tuple[Floats, ...]:
        return tuple(_resampled(loop, field, _NONE if n else fixed) for n, loop in enumerate(loops))

    seams = seams_on(field)
    while (place := first_crossing(seams)) is not None:
        closer = 0.5 * float(field.at(place[None])[0])
        if closer < 0.02 * field.size:
            raise MeshError(
                f"The outline crosses or nearly touches itself near {place_text(place)}:"
                " separate the parts that meet there.",
                (float(place[0]), float(place[1])),
            )
        field = field.limited(place[None], np.array([closer]))
        seams = seams_on(field)
    return seams, field


def weld_points(welds: tuple[Floats, ...], seams: tuple[Floats, ...], field: SizeField) -> list[Weld]:
    """Resampled welds. An end at a seam becomes the nearest vertex of the seam.

    Raises MeshError where welds or seams meet at this size.
    """
    rim, size = np.concatenate(seams), extent(seams[0])
    taken = np.zeros(len(rim), dtype=bool)
    resampled = []
    for line in welds:
        points = _resampled_line(line, field)
        ends = []
        for end in (0, -1):
            away = np.where(taken, np.inf, np.linalg.norm(rim - points[end], axis=1))
            nearest, here = int(np.argmin(away)), points[end : end + 1 or None]
            reach = max(AT_RIM * size, _BESIDE * float(field.at(here)[0]))
            at_rim = bool(nearest_on_loops(seams, here).distance[0] < reach)
            taken[nearest] |= at_rim
            ends.append(nearest if at_rim else None)
        resampled.append(Weld(points[ends[0] is not None : len(points) - (ends[1] is not None)], *ends))
    place = (
        first_crossing(seams, [weld.points for weld in resampled if len(weld.points) > 1])
        if resampled
        else None
    )
    if place is not None:
        raise MeshError(
            f"A weld runs too near to another one or to the outline at {place_text(place)} for this mesh:"
            " move it away, or use a smaller mesh size.",
            (float(place[0]), float(place[1])),
        )
    return resampled


def _resampled_line(line: Floats, field: SizeField) -> Floats:
    """An open line (n, 2) with even edges, two at least, its ends and corners kept."""
    at = line_lengths(line)
    edges = np.diff(line, axis=0)
    stops = np.concatenate([at[:1], at[1:-1][np.abs(turn(edges[:-1], edges[1:])) > _CORNER], at[-1:]])
    pieces = []
    for low, high in pairwise(stops):
        fine = np.linspace(low, high, max(64, int(4.0 * (high - low) / field.smallest)))
        density = 1.0 / field.at(point_on(line, at, fine))
        count = np.append(0.0, np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(fine)))
        parts = max(round(float(count[-1])), 2 if len(stops) == 2 else 1)
        even = np.interp(np.linspace(0.0, count[-1], parts + 1)[:-1], count, fine)
        pieces.append(point_on(line, at, even))
    return np.concatenate([*pieces, line[-1:]])


def _resampled(loop: Floats, field: SizeField, required: Ints) -> Floats:
    lengths = arc_lengths(loop)
    around = float(lengths[-1])
    fixed = np.union1d(corners(loop, _CORNER, reach=min(0.6 * field.smallest, around / 8.0)), required)
    stops = np.append(lengths[fixed], lengths[fixed[0]] + around) if len(fixed) else np.array([0.0, around])
    # Edges along the loop: the integral of 1 / size.
    fine = np.linspace(0.0, around, max(64, int(4.0 * around / field.smallest))) + stops[0]
    fine = np.union1d(fine, stops)
    density = 1.0 / field.at(point_at(loop, lengths, fine))
    count = np.append(0.0, np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(fine)))
    pieces = []
    for low, high in pairwise(np.interp(stops, fine, count)):
        edges = max(round(high - low), 1 if len(fixed) > 2 else 3)
        pieces.append(np.interp(np.linspace(low, high, edges + 1)[:-1], count, fine))
    return point_at(loop, lengths, np.concatenate(pieces))
