# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other points on the same line: evenly spaced, few enough, smoothed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.normals import CORNER_ANGLE, corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.core.types import Floats


def evenly(loop: Floats, spacing: float) -> Floats:
    """Points (k, 2) along a closed loop from its first one, at even distances of at most `spacing`.

    Twelve at least.
    """
    lengths = arc_lengths(loop)
    count = max(12, int(np.ceil(lengths[-1] / spacing)))
    return point_at(loop, lengths, np.arange(count) * (lengths[-1] / count))


def with_points_at(loop: Floats, lengths: Floats, at: Floats) -> tuple[Floats, NDArray[np.intp]]:
    """The closed loop with points added at arc lengths `at`, and their indices."""
    everywhere = np.union1d(lengths[:-1], at)
    return point_at(loop, lengths, everywhere), np.searchsorted(everywhere, at)


def _stretches(lengths: Floats, fixed: NDArray[np.intp]) -> tuple[Floats, Floats]:
    """Arc lengths (k,) at which the stretches between fixed points begin, and how long they are (k,)."""
    starts = lengths[fixed] if len(fixed) else np.zeros(1)
    return starts, np.diff(np.append(starts, starts[0] + lengths[-1]))


def resample(loop: Floats, spacing: float, corner_angle: float = CORNER_ANGLE) -> Floats:
    """The closed loop (n, 2) with points at most about `spacing` apart, evenly spaced between its corners.

    Corners stay where they are. Points lie on the given loop: a curve loses spacing^2 / (8 radius) at most.
    At least three points come back.
    """
    lengths = arc_lengths(loop)
    fixed = corners(loop, corner_angle, reach=0.5 * spacing)
    starts, spans = _stretches(lengths, fixed)
    least = 3 if len(spans) == 1 else 2 if len(spans) == 2 else 1
    pieces = [
        start + span * np.arange(count) / count
        for start, span, count in zip(
            starts, spans, np.maximum(np.rint(spans / spacing), least).astype(int), strict=True
        )
    ]
    return point_at(loop, lengths, np.concatenate(pieces))


def simplify(loop: Floats, tolerance: float, keep: NDArray[np.intp] | None = None) -> Floats:
    """The closed loop with so few of its points that it stays within `tolerance` (Douglas and Peucker 1973).

    keep  indices, in order, of points that must stay; without them the two ends of the loop's diameter
    """
    if keep is None or len(keep) < 2:
        first = int(keep[0]) if keep is not None and len(keep) else 0
        keep = np.sort(np.array([first, int(np.argmax(np.linalg.norm(loop - loop[first], axis=1)))]))
    chosen: list[int] = []
    closed = np.vstack([loop, loop])
    stops = np.append(keep[1:], keep[0] + len(loop))
    for first, last in zip(keep, stops, strict=True):
        chosen.extend(k % len(loop) for k in _significant(closed, int(first), int(last), tolerance))
    return np.asarray(loop[np.array(chosen, dtype=np.intp)])


def _significant(points: Floats, first: int, last: int, tolerance: float) -> list[int]:
    """Indices from first (included) to last (excluded) of the points that keep the chain within tolerance."""
    significant = [first]
    stack = [(first, last)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        x, y = (points[a + 1 : b] - points[a]).T
        _, away = foot(x, y, *(points[b] - points[a]).tolist())
        far = int(np.argmax(away))
        if away[far] > tolerance:
            middle = a + 1 + far
            significant.append(middle)
            stack += [(a, middle), (middle, b)]
    return sorted(significant)


def smooth(loop: Floats, width: float, fixed: NDArray[np.intp]) -> Floats:
    """The closed loop with ripples shorter than about 3 `width` removed and the points `fixed` held in place.

    A Gaussian along the loop, standard deviation `width`, on points `width` / 3 apart; between fixed points
    each piece is continued as its own point reflection at both ends, which holds the ends and directions.
    A circle of radius r shrinks by width^2 / (2 r).
    """
    lengths = arc_lengths(loop)
    starts, spans = _stretches(lengths, fixed)
    pieces = []
    for start, span in zip(starts, spans, strict=True):
        count = max(4, int(np.ceil(3 * span / width)))
        step = span / count
        half = int(np.ceil(3 * width / step))
        kernel = np.exp(-0.5 * (np.arange(-half, half + 1) * step / width) ** 2)
        kernel /= kernel.sum()
        if len(fixed):
            piece = point_at(loop, lengths, start + step * np.arange(count + 1))
            ripple = piece
            while len(ripple) < count + 1 + 2 * half:
                head, tail = ripple[0], ripple[-1]
                ripple = np.vstack([2 * head - ripple[:0:-1], ripple, 2 * tail - ripple[-2::-1]])
            middle = (len(ripple) - count - 1) // 2
            padded = ripple[middle - half : middle + count + 1 + half]
        else:
            padded = point_at(loop, lengths, start + step * np.arange(-half, count + 1 + half))
        pieces.append(
            np.column_stack([np.convolve(padded[:, k], kernel, mode="valid")[:count] for k in (0, 1)])
        )
    return np.concatenate(pieces)
