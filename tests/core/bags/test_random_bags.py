# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any bag inflates: convex polyhedra, bodies of gores, letters with a side band.

BALLOON_BAGS sets how many bags are tried (`make fuzz`: 300).
"""

from __future__ import annotations

import logging
import os

import numpy as np
import pytest
from drawn_letters import SIGNS, letter_outline
from drawn_shapes import generated

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import DISC, POINT, Profile
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats

COUNT = int(os.environ.get("BALLOON_BAGS", "12"))
VERTICES = 500


def polyhedron(rng: np.random.Generator) -> Bag:
    """The convex hull of points on an ellipsoid: a panel for each of its triangles."""
    from scipy.spatial import ConvexHull

    points = rng.normal(size=(int(rng.integers(5, 20)), 3))
    points *= rng.uniform(0.1, 0.4, 3) / np.linalg.norm(points, axis=1)[:, None]
    hull = ConvexHull(points)
    panels: list[BagPanel] = []
    sides: dict[tuple[int, int], Side] = {}
    seams = []
    for number, (face, outside) in enumerate(zip(hull.simplices.tolist(), hull.equations[:, :3])):
        a, b, c = points[face]
        corners = face
        if np.cross(b - a, c - a) @ outside < 0.0:
            corners, b, c = [face[0], face[2], face[1]], c, b
        base = float(np.linalg.norm(b - a))
        along = float((c - a) @ (b - a)) / base
        height = float(np.linalg.norm(np.cross(b - a, c - a))) / base
        panels.append(BagPanel(f"face {number}", np.array([(0.0, 0.0), (base, 0.0), (along, height)])))
        for k in range(3):
            start, end = corners[k], corners[(k + 1) % 3]
            if (end, start) in sides:
                seams.append(BagSeam(sides.pop((end, start)), Side(number, (k + 1) % 3, k)))
            else:
                sides[start, end] = Side(number, k, (k + 1) % 3)
    return Bag(tuple(panels), tuple(seams))


def gored(rng: np.random.Generator) -> Bag:
    """Some waves on a spheroid, its ends points or discs."""
    angles = np.linspace(0.0, np.pi, 61)
    waves = sum(rng.uniform(-0.15, 0.15) * np.cos(k * angles) for k in range(1, 4))
    radius = 0.2 * np.sin(angles) * (1.0 + waves)
    points = np.column_stack([radius, rng.uniform(0.1, 0.6) * -np.cos(angles)])
    ends = rng.choice([POINT, DISC], 2)
    first, last = (0 if ends[0] == POINT else 8), (60 if ends[1] == POINT else 52)
    points[[0, -1], 0] = 0.0
    return gored_bag(Profile(points[first : last + 1], str(ends[0]), str(ends[1])), int(rng.integers(3, 13)))


def banded(rng: np.random.Generator, seed: int) -> tuple[Bag, list[Floats]]:
    """A letter or a random outline, its band narrow or wide, of one piece or of several; where it begins."""
    outline = letter_outline("sans bold", SIGNS[rng.integers(len(SIGNS))]) if seed % 2 else generated(seed)
    band, piece = float(rng.uniform(0.01, 0.15)), float(rng.choice([0.0, 0.4]))
    bag = banded_bag(outline, band, piece)
    loops = bag.panels[0].loops
    return bag, band_places(loops, band_joints(loops, piece), band)


def tried(seed: int) -> tuple[Bag, Inflation]:
    rng = np.random.default_rng(seed)
    places = None
    if seed % 3 == 2:
        bag, places = banded(rng, seed // 3)
    else:
        bag = polyhedron(rng) if seed % 3 else gored(rng)
    check_bag(bag)
    meshed = mesh_bag(bag, default_size(bag, VERTICES))
    assert meshed.assembly.surface.euler_number == Topology(bag).euler_number, seed
    start = None if places is None else meshed.places(places)
    return bag, inflate(meshed.assembly, film("mylar"), 2000.0, start=start)


@pytest.mark.slow
def test_random_bags_inflate() -> None:
    balloons = {seed: tried(seed)[1] for seed in range(COUNT)}
    for seed, balloon in balloons.items():
        assert np.isfinite(balloon.positions).all(), seed
        assert np.isfinite(balloon.tensions).all(), seed
        assert balloon.volume > 0.0, seed
    at_rest = [seed for seed, balloon in balloons.items() if balloon.report.converged]
    steps = {seed: balloon.report.newton_steps for seed, balloon in balloons.items()}
    logging.getLogger(__name__).info(
        "%d bags, %d at rest; steps: median %g, most %d",
        *(COUNT, len(at_rest), float(np.median(list(steps.values()))), max(steps.values())),
    )
    assert len(at_rest) > 0.98 * COUNT, sorted(set(balloons) - set(at_rest))
