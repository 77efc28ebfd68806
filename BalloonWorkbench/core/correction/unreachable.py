# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an outline stays away from another: where film cannot follow the drawing, where a weld creases."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.design.compare import Misfit
from BalloonWorkbench.core.design.design import FarStretch
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

#: Distance from which a stretch counts, and what may remain at its ends, in parts of the larger dimension.
UNREACHED, NEARLY = 0.01, 0.005


def far_stretches(outline: Outline, misfit: Misfit) -> tuple[FarStretch, ...]:
    """The stretches of an outline from which another stays away, the farthest first."""
    size = max(outline.size)
    stretches = []
    for number, loop in enumerate(outline.loops):
        mine = misfit.loop == number
        lengths = arc_lengths(loop)
        order = np.argsort(misfit.share[mine], kind="stable")
        along, away = misfit.share[mine][order] * lengths[-1], misfit.distances[mine][order]
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
    breaks = np.flatnonzero(np.diff(np.append(at, at[0] + around)) > UNREACHED * size)
    if not len(breaks):
        return [(0.0, around)]
    runs = []
    for begin, end in zip(np.roll(breaks, 1) + 1, breaks, strict=True):
        chosen = np.arange(begin, end + 1 if begin <= end else end + 1 + len(off)) % len(off)
        if (away[off[chosen]] > UNREACHED * size).any():
            first, last = float(at[chosen[0]]), float(at[chosen[-1]])
            runs.append((first, last if last >= first else last + around))
    return runs
