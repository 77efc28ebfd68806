# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance for weld and cut: facing parts of the pattern keep apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import arc_lengths, gaps
from BalloonWorkbench.core.types import Floats, Ints

#: Between two seams lie two welds, two allowances of 2 mm (pattern/build.py) and a strip of 1 mm that a blade
#: can still cut out [m].
CUT_CLEARANCE = 0.005
#: Points face each other across a bay when the way round it is this much longer; a notch of more than 39
#: degrees is no bay, it closes by itself.
_DETOUR = 3.0
_FACING = 0.5  # cosine between the normals and the line across
_TRIALS = 30
_SLACK = 0.02  # of the clearance


def enforce_clearance(
    drawing: Sequence[Floats], pattern: Sequence[Floats], clearance: float
) -> tuple[Floats, ...]:
    """The loops (n, 2) of a pattern, pushed apart where they face each other across less than the clearance.

    Where the drawing itself has less, that much is kept.
    """
    drawn = np.concatenate(drawing)
    stops = np.cumsum([len(loop) for loop in pattern])[:-1]
    for _ in range(_TRIALS):
        points = np.concatenate(pattern)
        one, other, missing = _too_near(drawn, pattern, points, clearance)
        if not len(one):
            break
        push = np.zeros_like(points)
        across = points[one] - points[other]
        across *= (0.5 * missing / np.maximum(np.linalg.norm(across, axis=1), 1e-300))[:, None]
        order = np.argsort(missing, kind="stable")  # of several pushes the largest is written last
        both = np.stack([one, other], axis=1)[order].ravel()
        push[both] = np.stack([across, -across], axis=1)[order].reshape(-1, 2)
        pattern = [
            loop + _spread(loop, share, clearance)
            for loop, share in zip(pattern, np.split(push, stops), strict=True)
        ]
    return tuple(pattern)


def _too_near(
    drawn: Floats, pattern: Sequence[Floats], points: Floats, clearance: float
) -> tuple[Ints, Ints, Floats]:
    """Pairs of facing points (k,), (k,) and how much they are too near (k,)."""
    pairs = kd_tree(points).query_pairs(clearance, output_type="ndarray")
    one, other = pairs.T
    normals = np.concatenate([-left_normals(loop) for loop in pattern])
    lengths = [arc_lengths(loop) for loop in pattern]
    along = np.concatenate([length[:-1] for length in lengths])
    around = np.concatenate([np.full(len(length) - 1, length[-1]) for length in lengths])
    owner = np.repeat(np.arange(len(pattern)), [len(loop) for loop in pattern])
    across = points[other] - points[one]
    distance = np.linalg.norm(across, axis=1)
    missing = np.minimum(clearance, np.linalg.norm(drawn[other] - drawn[one], axis=1)) - distance
    way = np.where(owner[one] == owner[other], gaps(along[one], along[other], around[one]), np.inf)
    facing = ((across * normals[one]).sum(axis=1) > _FACING * distance) & (
        (across * normals[other]).sum(axis=1) < -_FACING * distance
    )
    near = facing & (way > _DETOUR * distance) & (missing > _SLACK * clearance)
    order = np.lexsort((other[near], one[near]))
    return one[near][order], other[near][order], missing[near][order]


def _spread(loop: Floats, push: Floats, clearance: float) -> Floats:
    """The push (n, 2) smoothed along the loop over a third of the clearance, so that it leaves no steps."""
    if not push.any():
        return push
    lengths = arc_lengths(loop)
    pushed = np.flatnonzero(push.any(axis=1))
    weight = np.exp(-0.5 * (gaps(lengths[:-1, None], lengths[pushed], lengths[-1]) / (clearance / 3.0)) ** 2)
    # pushes side by side may well be opposite: they are blended, the nearest and strongest count most
    share = weight * np.linalg.norm(push[pushed], axis=1)
    blend = share @ push[pushed] / np.maximum(share.sum(axis=1), 1e-300)[:, None]
    return np.asarray(blend * weight.max(axis=1)[:, None])
