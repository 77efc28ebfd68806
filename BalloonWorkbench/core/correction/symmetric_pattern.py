# SPDX-License-Identifier: LGPL-2.1-or-later
"""A symmetric drawing gets a symmetric pattern: each point of the course has a twin beyond the axis.

The mesh is not symmetric, so the balloon and what is left between it and the drawing are so only nearly. Each
point of the pattern and the image of its twin are therefore replaced by their mean before every pass.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.seam_map import Course
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.outline.crossings import first_crossing
from BalloonWorkbench.core.outline.sampling import point_at
from BalloonWorkbench.core.outline.symmetry import Mirror
from BalloonWorkbench.core.types import Floats, Ints

_ON_AXIS = 1e-9  # of the size


@dataclass(frozen=True)
class Twins:
    """loops: which loop mirrors each loop; points: for each loop, the twins of its points in that loop."""

    mirror: Mirror | None
    loops: tuple[int, ...]
    points: tuple[Ints, ...]

    def matched(self, course: Course, earlier: Course | None = None) -> Course:
        """The course with its pattern exactly symmetric; as it is where there is no axis.

        Where the two halves would then cross, it goes back to an earlier one, which is symmetric too.
        """
        if self.mirror is None:
            return course
        pattern = [
            0.5 * (mine + self.mirror.reflect(course.pattern[other][points]))
            for mine, other, points in zip(course.pattern, self.loops, self.points, strict=True)
        ]
        even = replace(course, pattern=tuple(pattern))
        if earlier is None or first_crossing(pattern) is None:
            return even
        return even.taken_back(earlier, None, 0.0)


FREE = Twins(None, (), ())
"""No symmetry."""


def twinned(course: Course, mirror: Mirror | None) -> tuple[Course, Twins]:
    """The course of a symmetric drawing sampled anew, so that every point has its twin, and the twins.

    Of each loop across the axis, and of each pair of loops beside it, the left half is taken and mirrored.
    Without an axis the course stays as it is.
    """
    if mirror is None:
        return course, FREE
    size = float(np.ptp(course.drawing[0], axis=0).max())
    left = [((loop - mirror.point) @ mirror.frame)[:, 0] for loop in course.drawing]
    crossing = [bool(across.min() < -_ON_AXIS * size and across.max() > _ON_AXIS * size) for across in left]
    drawing, pattern = list(course.drawing), list(course.pattern)
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
    twins = Twins(mirror, tuple(loops), tuple(points))
    return twins.matched(Course(tuple(drawing), tuple(pattern))), twins


def nearer(symmetric: Design, free: Design) -> Design:
    """The better of two designs for a symmetric drawing, with a remark where its pattern is not symmetric."""
    passes, seconds = symmetric.passes + free.passes, symmetric.seconds + free.seconds
    if free.residual.mean >= symmetric.residual.mean:
        return replace(symmetric, passes=passes, seconds=seconds)
    remark = (
        "The pattern is not symmetric: the balloon buckles to one side, and this comes nearer to the drawing."
    )
    return replace(free, passes=passes, seconds=seconds, warnings=(*free.warnings, remark))


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
