# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where film cannot follow the drawing: when to give up there, and how to say so."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.design.compare import Misfit
from BalloonWorkbench.core.design.design import UnreachedStretch
from BalloonWorkbench.core.geometry.polyline import arc_lengths, gaps, point_at
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Bools, Floats

#: Distance from which a stretch of the drawing counts as unreached, and what may remain at its ends, in parts
#: of the larger dimension.
UNREACHED, NEARLY = 0.01, 0.005
FAR = 0.01  # mean distance, of the larger dimension, above which nothing is given up as long as it falls
IDLE = 2  # passes without gain after which a place is given up
_FAR_OFF = 3.0  # medians of the distance, beyond which a place counts no more
_GAIN = 0.9  # a pass that leaves more than this part of the least distance is no gain


class StallTracker:
    """What each point of the seam map still gains from correction: a point that gains nothing is given up."""

    def __init__(self, seam_map: SeamMap, size: float) -> None:
        self._size = size
        self._least_mean = np.inf
        self._least = [np.full(len(loop), np.inf) for loop in seam_map.pattern]
        self._idle = [np.zeros(len(loop), dtype=np.int32) for loop in seam_map.pattern]
        self._tried: list[tuple[tuple[Floats, ...], list[Floats]]] = []  # patterns, distances
        self.unreachable: tuple[Bools, ...] = tuple(
            np.zeros(len(loop), dtype=np.bool_) for loop in seam_map.pattern
        )

    @property
    def abandoned(self) -> int:
        """Number of points that are given up."""
        return sum(int(unreachable.sum()) for unreachable in self.unreachable)

    def reachable_moves(
        self, seam_map: SeamMap, moves: tuple[Floats, ...], width: float
    ) -> tuple[Floats, ...]:
        """The moves (n, 2) of a seam map, none where they have not paid for some passes.

        There the pattern goes back to that pass which came nearest. Neighbours within about `width` [m] along
        the drawing take part, so that the pattern stays smooth.
        """
        away = [np.linalg.norm(move, axis=1) for move in moves]
        mean = float(np.concatenate(away).mean())
        if mean > FAR * self._size and mean < _GAIN * self._least_mean:
            self._least_mean = mean
            return moves
        self._tried.append((seam_map.pattern, away))
        allowed, unreachable = [], []
        for k, (drawing, pattern, move) in enumerate(
            zip(seam_map.drawing, seam_map.pattern, moves, strict=True)
        ):
            gained = away[k] < _GAIN * self._least[k]
            self._idle[k] = np.where(gained, 0, self._idle[k] + 1)
            self._least[k] = np.where(gained, away[k], self._least[k])
            hopeless = (self._idle[k] >= IDLE) & (away[k] > UNREACHED * self._size) & ~self.unreachable[k]
            unreachable.append(self.unreachable[k] | hopeless)
            moved = (1.0 - _nearness(drawing, unreachable[k], width)[:, None]) * move
            if hopeless.any():
                distances = [float(tried[k][hopeless].mean()) for _, tried in self._tried]
                nearest, _ = self._tried[int(np.argmin(distances))]
                moved += _nearness(drawing, hopeless, width)[:, None] * (nearest[k] - pattern)
            allowed.append(moved)
        self.unreachable = tuple(unreachable)
        return tuple(allowed)

    def mean_error(self, misfit: Misfit) -> float:
        """Mean distance [m] at the places that are not given up.

        Single far places, perhaps out of reach, count as much as others at most: else they hide what the rest
        gains.
        """
        used = np.ones(len(misfit.distances), dtype=np.bool_)
        for k, unreachable in enumerate(self.unreachable):
            mine = misfit.loop == k
            index = (misfit.share[mine] * len(unreachable)).astype(np.int64) % len(unreachable)
            used[mine] = ~unreachable[index]
        away = misfit.distances[used] if used.any() else misfit.distances
        return float(np.minimum(away, max(UNREACHED * self._size, _FAR_OFF * float(np.median(away)))).mean())


def _nearness(drawing: Floats, marked: Bools, width: float) -> Floats:
    """1 at marked points of a closed loop, falling to 0 over about `width` [m] beside them: (n,)."""
    if not marked.any():
        return np.zeros(len(drawing))
    lengths = arc_lengths(drawing)
    gap = gaps(lengths[:-1, None], lengths[:-1][marked], lengths[-1]).min(axis=1)
    return np.asarray(np.exp(-0.5 * (gap / width) ** 2))


def unreached_stretches(drawing: Outline, misfit: Misfit) -> tuple[UnreachedStretch, ...]:
    """The stretches of the drawing that are not reached, the farthest first."""
    size = max(drawing.size)
    stretches = []
    for number, loop in enumerate(drawing.loops):
        mine = misfit.loop == number
        lengths = arc_lengths(loop)
        order = np.argsort(misfit.share[mine], kind="stable")
        along, away = misfit.share[mine][order] * lengths[-1], misfit.distances[mine][order]
        for first, last in _runs(along, away, float(lengths[-1]), size):
            inside = np.mod(along - first, lengths[-1]) <= last - first
            points = point_at(
                loop, lengths, np.linspace(first, last, max(2, int(400 * (last - first) / size)))
            )
            stretches.append(
                UnreachedStretch(
                    number, first, last, points, float(away[inside].mean()), float(away[inside].max())
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
