# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two constrained Delaunay triangulations, pythoncdt's and SciPy's with its edges recovered, are one.

BALLOON_TRIANGULATED sets how many outlines are tried.
"""

from __future__ import annotations

import os
from itertools import pairwise

import numpy as np
import pytest

from BalloonWorkbench.core.mesh import delaunay
from BalloonWorkbench.core.mesh.delaunay import triangulate_points

COUNT = int(os.environ.get("BALLOON_TRIANGULATED", "60"))


def jagged(random: np.random.Generator, count: int, inner: float, outer: float) -> np.ndarray:
    """A star with teeth of any depth: few of its long sides are Delaunay."""
    turn = np.sort(random.uniform(0.0, 2.0 * np.pi, count))
    turn = turn[np.diff(turn, prepend=turn[-1] - 2.0 * np.pi) > 1e-3]
    radius = random.uniform(inner, outer, len(turn))[:, None]
    return radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)


def drawn(seed: int) -> tuple[np.ndarray, tuple[np.ndarray, ...], tuple[np.ndarray, ...]]:
    """Points with an outer loop, a hole, a weld across the film between them, and loose points."""
    random = np.random.default_rng(seed)
    outer, hole = jagged(random, 60, 1.3, 3.0), jagged(random, 25, 0.1, 0.8)[::-1]
    weld = np.stack([np.full(9, 1.05), np.linspace(-0.3, 0.3, 9)], axis=1)
    loose = random.normal(0.0, 1.0, (200, 2))
    points = np.concatenate([outer, hole, weld, loose])
    ends = np.cumsum([0, len(outer), len(hole), len(weld)])
    loop, ring, line = (np.arange(first, last) for first, last in pairwise(ends))
    return points, (loop, ring), (line,)


def corners(triangles: np.ndarray) -> set[tuple[int, ...]]:
    """Triangles by their corners, each from its least one on."""
    return {tuple(np.roll(one, -int(np.argmin(one))).tolist()) for one in triangles}


@pytest.mark.parametrize("seed", range(COUNT))
def test_both_find_the_same_triangles(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    assert delaunay.pythoncdt is not None
    case = drawn(seed)
    expected = corners(triangulate_points(*case))
    monkeypatch.setattr(delaunay, "pythoncdt", None)
    assert corners(triangulate_points(*case)) == expected
