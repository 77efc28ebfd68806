# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pen drawings: recognised by their thin lines, gaps between the lines closed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.core.options.drawing import TracingOptions
from BalloonWorkbench.core.tracing.pen_stroke_ends import meeting_ends
from BalloonWorkbench.core.tracing.raster import Pixels, distance, grow, label, neighbours
from BalloonWorkbench.core.types import Bools, Floats

# Sizes relative to the diagonal of the drawing's bounding box.
_WIDEST_GAP = 0.10  # wider gaps are left open
_LINES_PART = 0.6  # of the drawn area, for a pen drawing; the rest may be eyes and other filled spots
# A gap is closed only where the room behind it is this much wider than the gap itself: a bay is not a gap.
_ROOM_BEHIND = 1.75
# A drawing has fewer strokes, gaps and loose parts; a texture may have any number, and each takes its time.
_MOST_STROKES = 1000
_MOST_GAPS = 100
_MOST_PARTS = 30


@dataclass(frozen=True)
class Strokes:
    """What the lines of a drawing are like.

    pen       whether it is a pen drawing
    thin      pixels (h, w) that belong to thin parts
    width     of the lines [px]
    diagonal  of the drawing's bounding box [px]
    """

    pen: bool
    thin: Bools
    width: float
    diagonal: float


def strokes(drawn: Bools, thin_below: float = TracingOptions.line_width) -> Strokes:
    """How thick the drawn parts (h, w) are; a line is thinner than a part of the diagonal of their box."""
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    diagonal = float(np.hypot(np.ptp(rows) + 1, np.ptp(columns) + 1))
    half = 0.5 * thin_below * diagonal
    depth = distance(np.pad(drawn, 1))[1:-1, 1:-1]
    thin = drawn & ~grow(depth > half, half + 1)
    # Across a line of width w the depth runs evenly from 0 to w / 2.
    width = max(1.0, 4 * float(np.median(depth[drawn])) - 1)
    return Strokes(bool(thin.sum() > _LINES_PART * drawn.sum()), thin, width, diagonal)


def close_gaps(drawn: Bools, lines: Strokes) -> list[tuple[Floats, Floats]]:
    """Straight bridges (from, to), each (x, y) px, that close gaps through which rooms of a drawing are open.

    First, ends of strokes that run towards each other are joined. Then each room that is still open is
    closed: the distance to the lines is a landscape, a room is a summit in it, and its widest gap is the
    highest pass on the way outside; twice the height of the pass is the width of the gap. The lowest passes
    come first.
    """
    if label(drawn)[1] > _MOST_STROKES:
        return []
    margin = int(np.ceil(0.5 * _WIDEST_GAP * lines.diagonal)) + 2
    limit = 0.5 * _WIDEST_GAP * lines.diagonal
    ink = np.pad(drawn, margin).astype(np.float32)
    bridges = meeting_ends(ink > 0.5, lines.width, 2 * limit)
    for one, other in bridges:
        draw_line(ink, one, other, lines.width)
    refused: set[int] = set()
    height, ground = _landscape(ink)
    for level in limit * 2.0 ** np.arange(-np.ceil(2 * np.log2(limit)) / 2, 0.25, 0.5):
        while len(bridges) + len(refused) < _MOST_GAPS:
            summit = _open_room(height, ground, level, lines.width, refused)
            if summit is None:
                break
            one, other = _narrowest(ink > 0.5, _highest_pass(height, summit, level))
            gap = float(np.linalg.norm(other - one))
            if not 0 < gap <= 2 * limit or height.flat[summit] < 0.5 * _ROOM_BEHIND * gap:
                refused.add(summit)
                continue
            draw_line(ink, one, other, lines.width)
            bridges.append((one, other))
            height, ground = _landscape(ink)
    return [(one - margin, other - margin) for one, other in bridges]


def join_near(drawn: Bools, lines: Strokes) -> list[tuple[Floats, Floats]]:
    """Bridges from the largest part of a drawing to parts that end less than a line's width away from it."""
    bridges = []
    labels, count = label(drawn)
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    sizes[0] = 0
    whole = labels == int(np.argmax(sizes))
    waiting = [
        int(k) for k in np.argsort(-sizes, kind="stable")[1:count][:_MOST_PARTS] if sizes[k] > lines.width**2
    ]
    while waiting:
        away = distance(~whole)
        nearest = {k: float(away[labels == k].min()) for k in waiting}
        part = min(waiting, key=lambda k: nearest[k])
        if nearest[part] > 1.5 * lines.width + 1:
            break
        y, x = np.nonzero((labels == part) & (away <= nearest[part] + 1e-3))
        other = np.array([x[0], y[0]], dtype=np.float64)
        rim = _rim(whole)
        bridges.append((rim[np.argmin(np.linalg.norm(rim - other, axis=1))], other))
        whole |= labels == part
        waiting.remove(part)
    return bridges


def draw_line(coverage: Pixels, one: Floats, other: Floats, width: float) -> None:
    """Add to a coverage image (h, w) a straight line with round ends between two points (x, y) px."""
    ends = np.vstack([one, other])
    left, top = np.maximum(np.floor(ends.min(axis=0) - width), 0).astype(int)
    right, bottom = np.ceil(ends.max(axis=0) + width).astype(int) + 1
    part = coverage[top:bottom, left:right]
    y, x = np.mgrid[top : top + part.shape[0], left : left + part.shape[1]]
    _, away = foot(x - one[0], y - one[1], *(other - one))
    np.maximum(part, np.clip(0.5 * width + 0.5 - away, 0, 1), out=part)


def _landscape(ink: Pixels) -> tuple[Pixels, Bools]:
    """Distance to the lines (h, w), and where one gets from outside without crossing any."""
    height = distance(ink <= 0.5)
    labels, _ = label(height > 0)
    return height, labels == labels[0, 0]


def _open_room(height: Pixels, ground: Bools, level: float, line: float, refused: set[int]) -> int | None:
    """Summit (flat index) of a room cut off from outside at this level, but not by the lines alone."""
    labels, count = label(height > level)
    if count < 2:
        return None
    least = max(0.7 * _ROOM_BEHIND * level, 0.5 * line)
    rooms = (labels > 0) & (labels != labels[0, 0]) & ground & (height >= least)
    high = np.flatnonzero(rooms)
    high = high[np.argsort(-height.ravel()[high], kind="stable")]
    # The first of each name is its summit.
    for k in np.sort(np.unique(labels.ravel()[high], return_index=True)[1]):
        if int(high[k]) not in refused:
            return int(high[k])
    return None


def _highest_pass(height: Pixels, summit: int, level: float) -> Floats:
    """The point (x, y) px where the way from the summit to outside leads over the highest pass."""
    low, high = 0.0, level
    while high - low > 0.25:
        middle = 0.5 * (low + high)
        labels, _ = label(height > middle)
        if labels.flat[summit] == labels[0, 0]:
            low = middle
        else:
            high = middle
    labels, _ = label(height > high)
    room, outside = labels == labels.flat[summit], labels == labels[0, 0]
    joined, _ = label(height > low)
    between = (joined == joined[0, 0]) & ~room & ~outside
    way = np.where(between, distance(~room) + distance(~outside), np.inf)
    y, x = np.unravel_index(int(np.argmin(way)), way.shape)
    return np.array([x, y], dtype=np.float64)


def _narrowest(ink: Bools, at: Floats) -> tuple[Floats, Floats]:
    """The two points (x, y) px of the lines between which the gap around a pass is narrowest."""
    rim = _rim(ink)
    offset = rim - at
    away = np.linalg.norm(offset, axis=1)
    one = int(np.argmin(away))
    opposite = offset @ offset[one] < -0.3 * away * away[one]
    if not opposite.any():
        return rim[one], rim[one]
    other = int(np.argmin(np.where(opposite, away, np.inf)))
    # Nearest pair around these two; the direction of the first guess says which side is which.
    near = away < 1.5 * away[other] + 2
    side = offset @ (rim[other] - rim[one])
    ones, others = rim[near & (side < 0)], rim[near & (side > 0)]
    pairs = np.linalg.norm(ones[:, None] - others[None], axis=2)
    i, j = np.unravel_index(int(np.argmin(pairs)), pairs.shape)
    return ones[i], others[j]


def _rim(mask: Bools) -> NDArray[np.float64]:
    """Pixels (k, 2) as (x, y) of the mask that have a neighbour outside it."""
    y, x = np.nonzero(mask & neighbours(~mask))
    return np.column_stack([x, y]).astype(np.float64)
