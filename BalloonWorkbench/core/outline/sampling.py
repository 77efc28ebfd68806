# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points along loops and lines: corners, even spacing, simplification, smoothing that spares corners."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.types import Floats

#: A turn sharper than this is a corner: well above the facets of a flattened curve, below an octagon's 45
#: degrees.
CORNER_ANGLE = np.radians(35.0)


def arc_lengths(loop: Floats) -> Floats:
    """Length along the closed loop (n, 2) up to each point, and at last all the way round: (n + 1,)."""
    steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def point_at(loop: Floats, lengths: Floats, at: Floats) -> Floats:
    """Points (k, 2) of the closed loop at arc lengths `at` (k,), which may run past the start.

    lengths  what `arc_lengths(loop)` gives
    """
    around = np.mod(at, lengths[-1])
    closed = np.vstack([loop, loop[:1]])
    return np.column_stack([np.interp(around, lengths, closed[:, k]) for k in (0, 1)])


def line_lengths(line: Floats) -> Floats:
    """Length along the open line (n, 2) up to each point: (n,)."""
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))


def point_on(line: Floats, lengths: Floats, at: Floats) -> Floats:
    """Points (k, 2) of the open line at lengths `at` (k,); `lengths` is what `line_lengths(line)` gives."""
    return np.column_stack([np.interp(at, lengths, line[:, k]) for k in (0, 1)])


def corners(loop: Floats, angle: float = CORNER_ANGLE, reach: float = 0.0) -> NDArray[np.intp]:
    """Indices of the corners of a closed loop (n, 2), in order.

    angle  turn that makes a corner [rad]
    reach  distance along the loop over which the directions before and after are taken, so that a corner cut
           off by the pixels of a picture is still one; 0 compares neighbouring segments [unit of the loop]
    """
    lengths = arc_lengths(loop)
    here = lengths[:-1]
    if reach > 0:
        before = loop - point_at(loop, lengths, here - reach)
        after = point_at(loop, lengths, here + reach) - loop
    else:
        before = loop - np.roll(loop, 1, axis=0)
        after = np.roll(loop, -1, axis=0) - loop
    turn = np.abs(
        np.arctan2(
            before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], np.einsum("ij,ij->i", before, after)
        )
    )
    sharp = np.flatnonzero(turn > angle)
    if reach <= 0:
        return sharp
    # The sharpest first; whatever else turns within its reach is the same corner. Bins keep the search short.
    bins: dict[int, list[float]] = {}
    count = max(1, int(lengths[-1] // reach))
    found: list[int] = []
    for k in sharp[np.argsort(-turn[sharp], kind="stable")]:
        at = float(here[k])
        own = int(at / lengths[-1] * count)
        near = [other for shift in (-1, 0, 1) for other in bins.get((own + shift) % count, ())]
        if all(reach < abs(at - other) < lengths[-1] - reach for other in near):
            found.append(int(k))
            bins.setdefault(own % count, []).append(at)
    return np.array(sorted(found), dtype=np.intp)


def resample(loop: Floats, spacing: float, corner_angle: float = CORNER_ANGLE) -> Floats:
    """The closed loop (n, 2) with points at most about `spacing` apart, evenly spaced between its corners.

    Corners stay where they are. Points lie on the given loop: a curve loses spacing^2 / (8 radius) at most.
    At least three points come back.
    """
    lengths = arc_lengths(loop)
    fixed = corners(loop, corner_angle, reach=0.5 * spacing)
    starts = lengths[fixed] if len(fixed) else np.zeros(1)
    spans = np.diff(np.append(starts, starts[0] + lengths[-1]))
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
    kept = [first]
    stack = [(first, last)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        chord = points[b] - points[a]
        offset = points[a + 1 : b] - points[a]
        length2 = float(chord @ chord)
        # on so few numbers np.clip and np.linalg.norm take several times as long
        along = (
            np.maximum(np.minimum(offset @ chord / length2, 1.0), 0.0) if length2 > 0 else 0.0 * offset[:, 0]
        )
        x, y = (offset - along[:, None] * chord).T
        away = np.sqrt(x * x + y * y)
        far = int(np.argmax(away))
        if away[far] > tolerance:
            middle = a + 1 + far
            kept.append(middle)
            stack += [(a, middle), (middle, b)]
    return sorted(kept)


def smooth(loop: Floats, width: float, fixed: NDArray[np.intp]) -> Floats:
    """The closed loop with ripples shorter than about 3 `width` removed and the points `fixed` held in place.

    A Gaussian along the loop, standard deviation `width`, on points `width` / 3 apart; between fixed points
    each piece is continued as its own point reflection at both ends, which holds the ends and directions.
    A circle of radius r shrinks by width^2 / (2 r).
    """
    lengths = arc_lengths(loop)
    starts = lengths[fixed] if len(fixed) else np.zeros(1)
    spans = np.diff(np.append(starts, starts[0] + lengths[-1]))
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
