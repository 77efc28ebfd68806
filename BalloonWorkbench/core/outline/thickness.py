# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thin an outline gets."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.outline.crossings import contains
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths, corners, point_at
from BalloonWorkbench.core.types import Bools, Floats

# Points put along all loops together: 300 mm of silhouette are then seen every 2 mm or so.
_SAMPLES = 700
# Two facing points belong to a neck, an arm or a strip if the way round along the rim is this much longer
# than straight across; below, they are the two sides of one rounded end.
_DETOUR = 3.0
# A tip sharper than this narrows to nothing by its nature and is judged by its angle, not by its width.
_SHARP_TIP = np.radians(100.0)


def min_width(outline: Outline) -> float:
    """Width of the thinnest neck, arm or strip of the outline [m]; within about 5 %.

    Measured straight across between facing points of the rim; the pointed ends of sharp corners do not count.
    A shape without any such place (a disc) gives its smaller extent across.
    """
    points, inward, where, loop_of, lengths = _rim(outline)
    across = points[None] - points[:, None]
    width = np.linalg.norm(across, axis=2)
    np.fill_diagonal(width, np.inf)
    with np.errstate(invalid="ignore"):
        facing = (np.einsum("ijk,ik->ij", across, inward) > 0.8 * width) & (
            np.einsum("ijk,jk->ij", across, inward) < -0.8 * width
        )
    same = loop_of[:, None] == loop_of[None]
    way = np.abs(where[:, None] - where[None])
    way = np.where(same, np.minimum(way, lengths[loop_of][:, None] - way), np.inf)
    pairs = facing & (way > _DETOUR * width) & ~_at_a_tip(outline, points, width)
    widths = np.where(pairs, width, np.inf)
    # The nearest few are looked at in turn: the straight line between them must run inside.
    for k in np.argsort(widths, axis=None, kind="stable")[: 4 * _SAMPLES]:
        i, j = divmod(int(k), len(points))
        if not np.isfinite(widths[i, j]):
            break
        if _inside(outline, points[i] + across[i, j] * np.linspace(0.1, 0.9, 9)[:, None]):
            return float(widths[i, j])
    return _smaller_extent(outline.outer)


def _rim(outline: Outline) -> tuple[Floats, Floats, Floats, NDArray[np.intp], Floats]:
    """Points evenly spaced on all loops, inward normals, arc lengths, numbers of the loops; loop lengths."""
    lengths = np.array([arc_lengths(loop)[-1] for loop in outline.loops])
    step = lengths.sum() / _SAMPLES
    points, inward, where, loop_of = [], [], [], []
    for number, (loop, length) in enumerate(zip(outline.loops, lengths)):
        count = max(12, int(length / step))
        ends = arc_lengths(loop)
        at = (np.arange(count) + 0.5) * length / count
        half = 0.25 * length / count
        along = point_at(loop, ends, at + half) - point_at(loop, ends, at - half)
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
        points.append(point_at(loop, ends, at))
        inward.append(np.column_stack([-along[:, 1], along[:, 0]]))
        where.append(at)
        loop_of.append(np.full(count, number))
    return (*(np.concatenate(part) for part in (points, inward, where, loop_of)), lengths)  # type: ignore[return-value]


def _at_a_tip(outline: Outline, points: Floats, width: Floats) -> Bools:
    """Pairs (k, k) of points that are the two sides of one sharp corner of the outer loop."""
    loop = outline.outer
    reach = 0.01 * float(max(np.ptp(loop, axis=0)))
    tips = corners(loop, _SHARP_TIP, reach)
    found = np.zeros(width.shape, dtype=np.bool_)
    lengths = arc_lengths(loop)
    for tip in tips:
        arms = point_at(loop, lengths, lengths[tip] + np.array([-reach, reach])) - loop[tip]
        if arms[1, 0] * arms[0, 1] - arms[1, 1] * arms[0, 0] <= 0.0:
            continue  # a sharp notch, not a tip
        away = np.linalg.norm(points - loop[tip], axis=1)
        opening = float(np.linalg.norm(arms[1] - arms[0])) / reach
        # On straight sides both points are width / opening away from the tip; curved sides get half as much
        # again.
        near = away[:, None] * opening < 1.5 * width + 1e-12
        found |= near & near.T
    return found


def _inside(outline: Outline, points: Floats) -> bool:
    return bool(contains(outline.outer, points).all()) and not any(
        contains(hole, points).any() for hole in outline.holes
    )


def _smaller_extent(loop: Floats) -> float:
    """Smallest width of the loop's shadow over all directions, taken every 5 degrees."""
    angles = np.radians(np.arange(0, 180, 5))
    return float(np.ptp(loop @ np.vstack([np.cos(angles), np.sin(angles)]), axis=0).min())
