# SPDX-License-Identifier: LGPL-2.1-or-later
"""A symmetric drawing gets a symmetric pattern: mirrored halves, and the same all round.

The mesh is not symmetric, so the balloon and what is left between it and the drawing are so only nearly. Each
point of the pattern is therefore replaced by the mean of all that the symmetry makes of the pattern, before
it is inflated.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.nearest import Indices, nearest_on_loops
from BalloonWorkbench.core.geometry.polyline import centroid, extent, point_at
from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.outline.symmetry import EXACT, Mirror
from BalloonWorkbench.core.types import Floats, Ints

_ON_AXIS = 1e-9  # of the size
_MOST_TURNS = 24  # of a drawing that is the same all round
_TRIED = 40  # points of the drawing, of each turn


@dataclass(frozen=True)
class Turn:
    """A rotation that brings the drawing onto itself.

    matrix  (2, 2) by which rows of points are multiplied
    before, after, share  for each loop and each of its points: the points, numbered through all loops,
        between which its image lies, and how far from one to the other
    """

    matrix: Floats
    before: tuple[Indices, ...]
    after: tuple[Indices, ...]
    share: tuple[Floats, ...]

    def moves(self, of_all: Floats, number: int) -> Floats:
        """The moves of one loop's images, turned back; of_all (m, 2): of the points of all loops."""
        share = self.share[number][:, None]
        there = (1.0 - share) * of_all[self.before[number]] + share * of_all[self.after[number]]
        return there @ self.matrix.T


@dataclass(frozen=True)
class PatternSymmetry:
    """What a drawing's symmetry makes of its pattern.

    loops   which loop mirrors each loop; points: for each loop, the counterparts of its points in that
    turns   rotations that bring the drawing onto itself
    """

    mirror: Mirror | None
    loops: tuple[int, ...] = ()
    points: tuple[Ints, ...] = ()
    turns: tuple[Turn, ...] = ()

    def symmetrised(self, seam_map: SeamMap, earlier: SeamMap | None = None) -> SeamMap:
        """The map with its pattern symmetric, about an axis exactly; as it is where there is no symmetry.

        Where its parts would then cross, it goes back to an earlier one, which is symmetric too.
        """
        if self.mirror is None and not self.turns:
            return seam_map
        pattern = self._mirrored(self._turned(seam_map))
        even = replace(seam_map, pattern=pattern)
        if earlier is None or first_crossing(pattern) is None:
            return even
        return even.half_back(earlier, None, 0.0)

    def _turned(self, seam_map: SeamMap) -> tuple[Floats, ...]:
        """The drawing moved by the mean of the pattern's moves and of what the turns make of them."""
        moves = [mine - drawn for mine, drawn in zip(seam_map.pattern, seam_map.drawing, strict=True)]
        of_all, parts = np.concatenate(moves), 1.0 + len(self.turns)
        return tuple(
            drawn + sum((turn.moves(of_all, number) for turn in self.turns), start=move) / parts
            for number, (drawn, move) in enumerate(zip(seam_map.drawing, moves, strict=True))
        )

    def _mirrored(self, pattern: tuple[Floats, ...]) -> tuple[Floats, ...]:
        """Each loop and the image of its counterpart, half and half."""
        if self.mirror is None:
            return pattern
        return tuple(
            0.5 * (mine + self.mirror.reflect(pattern[other][points]))
            for mine, other, points in zip(pattern, self.loops, self.points, strict=True)
        )


NO_SYMMETRY = PatternSymmetry(None)


def pattern_symmetry(
    seam_map: SeamMap, mirror: Mirror | None, exact: float = EXACT
) -> tuple[SeamMap, PatternSymmetry]:
    """The map of a drawing sampled so that every point has a counterpart, and the symmetry of its pattern.

    mirror  its axis, where it has one
    exact   mean distance, of its size, up to which a drawing that was turned is the same
    """
    drawn, symmetry = _mirror_pairs(seam_map, mirror)
    return drawn, replace(symmetry, turns=_turns(drawn.drawing, exact))


def _turns(drawing: tuple[Floats, ...], exact: float) -> tuple[Turn, ...]:
    """The turns by whole parts of a round, most of them first tried, that bring loops onto themselves."""
    centre, points = centroid(drawing), np.concatenate(drawing)
    some = points[:: max(1, len(points) // _TRIED)] - centre
    for count in range(_MOST_TURNS, 1, -1):
        away = nearest_on_loops(drawing, some @ rotation(2.0 * np.pi / count) + centre).distance
        if away.mean() <= exact * extent(drawing[0]):
            return tuple(_turn(drawing, centre, 2.0 * np.pi * k / count) for k in range(1, count))
    return ()


def _turn(drawing: tuple[Floats, ...], centre: Floats, angle: float) -> Turn:
    """The turn by an angle about a centre (2,)."""
    matrix, counts = rotation(angle), [len(loop) for loop in drawing]
    points = np.concatenate(drawing)
    edge, share, _ = nearest_on_loops(drawing, (points - centre) @ matrix + centre)
    ahead = np.concatenate([np.roll(part, -1) for part in np.split(np.arange(len(points)), _stops(counts))])
    parts = (np.split(values, _stops(counts)) for values in (edge, ahead[edge], share))
    before, after, shares = (tuple(part) for part in parts)
    return Turn(matrix, before, after, shares)


def _stops(counts: list[int]) -> Indices:
    return np.cumsum(counts)[:-1]


def _mirror_pairs(seam_map: SeamMap, mirror: Mirror | None) -> tuple[SeamMap, PatternSymmetry]:
    """The map of a symmetric drawing sampled anew, so that every point has a counterpart, and the pairs.

    Of each loop across the axis, and of each pair of loops beside it, the left half is taken and mirrored.
    Without an axis the map stays as it is.
    """
    if mirror is None:
        return seam_map, NO_SYMMETRY
    size = extent(seam_map.drawing[0])
    left = [((loop - mirror.point) @ mirror.frame)[:, 0] for loop in seam_map.drawing]
    crossing = [bool(across.min() < -_ON_AXIS * size and across.max() > _ON_AXIS * size) for across in left]
    drawing, pattern = list(seam_map.drawing), list(seam_map.pattern)
    loops = list(range(len(drawing)))
    points = [np.arange(len(loop), dtype=np.int32) for loop in drawing]
    for number, across in enumerate(left):
        if crossing[number]:
            drawing[number], pattern[number] = _whole(
                drawing[number], pattern[number], across, _ON_AXIS * size, mirror
            )
            points[number] = (-np.arange(len(drawing[number]), dtype=np.int32)) % len(drawing[number])
        elif across.mean() < 0.0:
            image = mirror.reflect(drawing[number])
            others = [other for other, far in enumerate(left) if not crossing[other] and far.mean() > 0.0]
            other = min(others, key=lambda k: float(np.linalg.norm(drawing[k].mean(0) - image.mean(0))))
            drawing[other] = image[::-1]
            pattern[other] = mirror.reflect(pattern[number])[::-1]
            loops[number], loops[other] = other, number
            points[number] = points[other] = np.arange(len(image), dtype=np.int32)[::-1]
    pairs = PatternSymmetry(mirror, tuple(loops), tuple(points))
    return pairs.symmetrised(SeamMap(tuple(drawing), tuple(pattern))), pairs


def _whole(
    drawing: Floats, pattern: Floats, across: Floats, near: float, mirror: Mirror
) -> tuple[Floats, Floats]:
    """A loop (n, 2) of the drawing and of the pattern as its left half and the image of that.

    across  distances (n,) to the right of the axis; nearer than `near` a point lies on it
    """
    count = len(across)
    ahead = np.roll(across, -1)
    leaving = np.flatnonzero((across >= -near) & (ahead < -near))  # last points before what lies on the left
    arriving = np.flatnonzero((across < -near) & (ahead >= -near))  # and last points of that
    length = np.mod(arriving[None] - leaving[:, None], count)
    longest = int(np.argmax(length.min(axis=1)))  # a symmetric loop meets its axis twice, but for rounding
    first, last = int(leaving[longest]), int(arriving[np.argmin(length[longest])])
    start = first + max(across[first], 0.0) / (max(across[first], 0.0) - ahead[first])
    end = last + across[last] / (across[last] - max(ahead[last], 0.0))
    end += count * (last < first)
    inner = np.arange(int(np.floor(start)) + 1, int(np.ceil(end)), dtype=np.float64)
    at = np.concatenate([[start], inner[(inner > start) & (inner < end)], [end]])
    halves = []
    for loop in (drawing, pattern):
        half = point_at(loop, np.arange(count + 1, dtype=np.float64), at)
        halves.append(np.concatenate([half, mirror.reflect(half)[-2:0:-1]]))
    return halves[0], halves[1]
