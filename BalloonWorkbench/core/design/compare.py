# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two-way distance between outlines, and where they are far apart; a balloon laid over another."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.design.design import FarStretch, Residual
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops, nearest_places, way_round
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at, point_weights
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import alignment, perpendicular, rotation
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Ints

_SAMPLES = 1000  # along the longest loop
_FITS = 8  # of a silhouette to the drawing, at most
_LAID = 1e-6  # of the drawing's size, by which the last fit may move it
#: Distance from which a stretch counts, and what may remain at its ends, in parts of the larger dimension.
FAR, NEARLY = 0.01, 0.005


@dataclass(frozen=True)
class Misfit:
    """How far two outlines are apart, place by place, both ways.

    distances  (k,) from points of either outline to the other one [m]
    loop       (k,) loop of the drawing where that is
    share      (k,) how far round that loop, 0 to 1
    """

    distances: Floats
    loop: Ints
    share: Floats

    @property
    def residual(self) -> Residual:
        """Mean, 95th percentile and maximum."""
        away = self.distances
        return Residual(float(away.mean()), float(np.percentile(away, 95)), float(away.max()))


def residual(drawing: Outline, visible: Outline) -> Residual:
    """Distances from each outline to the other one, at points evenly spaced along both [m]."""
    return misfit(drawing, visible).residual


def misfit(drawing: Outline, visible: Outline) -> Misfit:
    """Distances from each outline to the other one, at points evenly spaced along both, place by place."""
    spacing = max(float(arc_lengths(loop)[-1]) for loop in drawing.loops) / _SAMPLES
    here = [evenly(loop, spacing) for loop in drawing.loops]
    there = np.concatenate([evenly(loop, spacing) for loop in visible.loops])
    forth, back = (
        nearest_on_loops(visible.loops, np.concatenate(here)),
        nearest_on_loops(drawing.loops, there),
    )
    loop, share = way_round(drawing.loops, back)
    owner = np.repeat(np.arange(len(here)), [len(points) for points in here])
    return Misfit(
        np.concatenate([forth.distance, back.distance]),
        np.concatenate([owner, loop]).astype(np.int32),
        np.concatenate([*(np.arange(len(points)) / len(points) for points in here), share]),
    )


def far_stretches(outline: Outline, apart: Misfit) -> tuple[FarStretch, ...]:
    """The stretches of an outline from which another stays away, the farthest first."""
    size = max(outline.size)
    stretches = []
    for number, loop in enumerate(outline.loops):
        mine = apart.loop == number
        lengths = arc_lengths(loop)
        order = np.argsort(apart.share[mine], kind="stable")
        along, away = apart.share[mine][order] * lengths[-1], apart.distances[mine][order]
        for first, last in _runs(along, away, float(lengths[-1]), size):
            inside = np.mod(along - first, lengths[-1]) <= last - first
            points = point_at(
                loop, lengths, np.linspace(first, last, max(2, int(400 * (last - first) / size)))
            )
            farthest = np.argmax(np.where(inside, away, 0.0))
            place = point_at(loop, lengths, along[[farthest]])[0]
            stretches.append(
                FarStretch(
                    number, first, last, points, float(away[inside].mean()), float(away[inside].max()), place
                )
            )
    return tuple(sorted(stretches, key=lambda stretch: -stretch.max))


def _runs(along: Floats, away: Floats, around: float, size: float) -> list[tuple[float, float]]:
    """Beginnings and ends of the stretches; those with less than 1 % of the size between them are one."""
    off = np.flatnonzero(away > NEARLY * size)
    if not len(off):
        return []
    at = along[off]
    breaks = np.flatnonzero(np.diff(np.append(at, at[0] + around)) > FAR * size)
    if not len(breaks):
        return [(0.0, around)]
    runs = []
    for begin, end in zip(np.roll(breaks, 1) + 1, breaks, strict=True):
        chosen = np.arange(begin, end + 1 if begin <= end else end + 1 + len(off)) % len(off)
        if (away[off[chosen]] > FAR * size).any():
            first, last = float(at[chosen[0]]), float(at[chosen[-1]])
            runs.append((first, last if last >= first else last + around))
    return runs


def laid_over(inflation: Inflation, places: Floats) -> Inflation:
    """The balloon moved and turned in its plane of symmetry, its seam as near as may be to places (k, 2) [m].

    There is one for each vertex of the panel's loops, in a row.
    """
    loops, rest = inflation.panel.loops, inflation.panel.rest_positions
    seam = inflation.positions[np.concatenate(loops), :2]
    weights = np.concatenate([point_weights(rest[loop]) for loop in loops])
    return moved(inflation, *alignment(seam, places, weights))


def laid_on(inflation: Inflation, visible: Outline, drawing: Outline) -> Inflation:
    """The balloon with a silhouette moved and turned to where that is nearest to the drawing.

    Only what is missing across the silhouette counts, as its film may have slid along it (Chen and Medioni,
    Object modelling by registration of multiple range images, Image Vision Comput. 10, 1992, 145-155).
    """
    spacing = max(float(arc_lengths(loop)[-1]) for loop in visible.loops) / _SAMPLES
    loops = [evenly(loop, spacing) for loop in visible.loops]
    points, across = np.concatenate(loops), np.concatenate([left_normals(loop) for loop in loops])
    matrix, shift = np.eye(2), np.zeros(2)
    for _ in range(_FITS):
        here, normals = points @ matrix.T + shift, across @ matrix.T
        missing = np.einsum("ij,ij->i", nearest_places(drawing.loops, here) - here, normals)
        centre = here.mean(axis=0)
        lever = np.einsum("ij,ij->i", perpendicular(here - centre), normals)
        x, y, angle = np.linalg.lstsq(np.column_stack([normals, lever]), missing, rcond=None)[0]
        turn = rotation(float(angle)).T
        matrix, shift = turn @ matrix, turn @ (shift - centre) + centre + np.array([x, y])
        size = max(drawing.size)
        if max(abs(x), abs(y), abs(angle) * size) < _LAID * size:
            break
    return moved(inflation, matrix, shift)


def moved(inflation: Inflation, turn: Floats, shift: Floats) -> Inflation:
    """The balloon turned by a matrix (2, 2) and shifted (2,) m in its plane of symmetry."""
    positions, directors = inflation.positions.copy(), inflation.directors.copy()
    positions[:, :2] = positions[:, :2] @ turn.T + shift
    directors[:, :2] = directors[:, :2] @ turn.T
    lower = inflation.lower
    if lower is not None:
        lower = np.column_stack([lower[:, :2] @ turn.T + shift, lower[:, 2]])
    return replace(inflation, positions=positions, directors=directors, lower=lower)
