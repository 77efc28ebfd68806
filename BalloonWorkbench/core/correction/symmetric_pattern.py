# SPDX-License-Identifier: LGPL-2.1-or-later
"""A symmetric drawing gets a symmetric pattern: each point of the seam map has its mirror image.

The mesh is not symmetric, so the balloon and what is left between it and the drawing are so only nearly. Each
point of the pattern and the image of its counterpart are therefore replaced by their mean before they are
inflated.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import extent, point_at
from BalloonWorkbench.core.outline.symmetry import Mirror
from BalloonWorkbench.core.types import Floats, Ints

_ON_AXIS = 1e-9  # of the size


@dataclass(frozen=True)
class MirrorPairs:
    """loops: which loop mirrors each loop; points: for each loop, the counterparts of its points in that."""

    mirror: Mirror | None
    loops: tuple[int, ...]
    points: tuple[Ints, ...]

    def symmetrised(self, seam_map: SeamMap, earlier: SeamMap | None = None) -> SeamMap:
        """The map with its pattern exactly symmetric; as it is where there is no axis.

        Where the two halves would then cross, it goes back to an earlier one, which is symmetric too.
        """
        if self.mirror is None:
            return seam_map
        pattern = [
            0.5 * (mine + self.mirror.reflect(seam_map.pattern[other][points]))
            for mine, other, points in zip(seam_map.pattern, self.loops, self.points, strict=True)
        ]
        even = replace(seam_map, pattern=tuple(pattern))
        if earlier is None or first_crossing(pattern) is None:
            return even
        return even.half_back(earlier, None, 0.0)


NO_MIRROR = MirrorPairs(None, (), ())
"""No symmetry."""


def mirror_pairs(seam_map: SeamMap, mirror: Mirror | None) -> tuple[SeamMap, MirrorPairs]:
    """The map of a symmetric drawing sampled anew, so that every point has a counterpart, and the pairs.

    Of each loop across the axis, and of each pair of loops beside it, the left half is taken and mirrored.
    Without an axis the map stays as it is.
    """
    if mirror is None:
        return seam_map, NO_MIRROR
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
    pairs = MirrorPairs(mirror, tuple(loops), tuple(points))
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
