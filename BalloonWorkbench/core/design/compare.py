# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two-way distance between outlines, and a balloon laid over another to be compared with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops, way_round
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_weights
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Ints

_SAMPLES = 1000  # along the longest loop


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


def laid_over(inflation: Inflation, places: Floats) -> Inflation:
    """The balloon moved and turned in its plane of symmetry, its seam as near as may be to places (k, 2) [m].

    There is one for each vertex of the panel's loops, in a row.
    """
    loops, rest = inflation.panel.loops, inflation.panel.rest_positions
    seam = inflation.positions[np.concatenate(loops), :2]
    rotation, shift = alignment(seam, places, np.concatenate([point_weights(rest[loop]) for loop in loops]))
    positions, directors = inflation.positions.copy(), inflation.directors.copy()
    positions[:, :2] = positions[:, :2] @ rotation.T + shift
    directors[:, :2] = directors[:, :2] @ rotation.T
    lower = inflation.lower
    if lower is not None:
        lower = np.column_stack([lower[:, :2] @ rotation.T + shift, lower[:, 2]])
    return replace(inflation, positions=positions, directors=directors, lower=lower)
