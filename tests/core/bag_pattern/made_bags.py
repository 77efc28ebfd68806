# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags for tests of their patterns: boxes, drums, gores closed and open, a ring with a side band."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from drawn_letters import letter_outline
from drawn_shapes import NAMED

from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.bodies.banded import banded_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import OPEN, Profile
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.types import Floats

FILM = film("bopp-foil")


def rectangle(width: float, height: float) -> Floats:
    return np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])


def box(x: float = 0.3, y: float = 0.2, z: float = 0.15) -> Bag:
    """Six rectangles."""
    sides = [BagPanel(f"side {k + 1}", rectangle((x, y, x, y)[k], z)) for k in range(4)]
    seams = [BagSeam(Side(k, 1, 2), Side((k + 1) % 4, 0, 3)) for k in range(4)]
    panels = [*sides, BagPanel("bottom", rectangle(x, y)), BagPanel("top", rectangle(x, y))]
    for k in range(4):
        # the bottom is seen from below: mirrored, its first edge below side 1 runs the other way
        seams.append(BagSeam(Side(k, 0, 1), Side(4, (4 - k + 1) % 4, (4 - k) % 4)))
        seams.append(BagSeam(Side(5, k, (k + 1) % 4), Side(k, 3, 2)))
    return Bag(tuple(panels), tuple(seams), Opening(5, 0))


def drum(radius: float = 0.15, height: float = 0.1, points: int = 96) -> Bag:
    """Two discs and a band whose ends meet."""
    angles = 2.0 * np.pi * np.arange(points) / points
    disc = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    x = np.arange(points + 1) * float(np.linalg.norm(disc[1] - disc[0]))
    band = np.concatenate([np.column_stack([x, 0.0 * x]), np.column_stack([x, 0.0 * x + height])[::-1]])
    panels = (BagPanel("top", disc), BagPanel("bottom", disc), BagPanel("band", band))
    last, half = 2 * points + 1, points // 2
    seams = (
        BagSeam(Side(0, 0, half), Side(2, last, last - half)),
        BagSeam(Side(0, half, 0), Side(2, last - half, last - points)),
        BagSeam(Side(2, 0, half), Side(1, 0, half)),
        BagSeam(Side(2, half, points), Side(1, half, 0)),
        BagSeam(Side(2, points, points + 1), Side(2, 0, last)),
    )
    return Bag(panels, seams, Opening(2, 3))


def profile(lower: str = "point", upper: str = "point", radius: float = 0.25) -> Profile:
    """Of a sphere, cut off at ends that are no points."""
    low, high = (0.0 if end == "point" else 0.3 for end in (lower, upper))
    angles = np.linspace(low - 0.5 * np.pi, 0.5 * np.pi - high, 60)
    points = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    points[0, 0] = points[0, 0] if low else 0.0
    points[-1, 0] = points[-1, 0] if high else 0.0
    return Profile(points, lower, upper)


BAGS = {
    "box": box(),
    "drum": drum(),
    "ball": gored_bag(profile(), 8),
    "airship": gored_bag(profile("disc", "disc"), 6),
    "envelope": gored_bag(profile(OPEN), 10),
    "ring": banded_bag(NAMED["ring"], 0.06, 0.4),
    "letter M": banded_bag(letter_outline("sans bold", "M"), 0.04, 0.5),
    **{f"ready {name}": ready_bag(name) for name in READY},
}


@cache
def made(name: str, **options: Any) -> BagPatterns:
    return bag_patterns(BAGS[name], FILM, PatternOptions(**options))
