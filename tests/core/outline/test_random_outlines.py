# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any simple outline inflates, or says that it did not: smooth, star-like, spiky, thin, with holes.

BALLOON_OUTLINES sets how many outlines are tried (`make fuzz`: 2 000).
"""

from __future__ import annotations

import logging
import os

import numpy as np
from drawn_shapes import generated

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation

COUNT = int(os.environ.get("BALLOON_OUTLINES", "21"))
VERTICES = 300


def tried(seed: int) -> Inflation | None:
    """The balloon of a random outline; None where it is too thin for its mesh, which is an error."""
    outline = generated(seed)
    try:
        panel = triangulate(outline, size_for(outline, VERTICES))
    except MeshError:
        return None
    return inflate(panel, film("mylar"), 2000.0)


def test_random_outlines_inflate() -> None:
    balloons = {seed: tried(seed) for seed in range(COUNT)}
    solved = {seed: balloon for seed, balloon in balloons.items() if balloon is not None}
    assert len(solved) > 0.95 * COUNT
    for seed, balloon in solved.items():
        assert np.isfinite(balloon.positions).all(), seed
        assert np.isfinite(balloon.tensions).all(), seed
        assert balloon.volume > 0.0, seed
        assert abs(np.linalg.norm(balloon.directors, axis=1) - 1.0).max() < 1e-9, seed
    at_rest = [seed for seed, balloon in solved.items() if balloon.report.converged]
    assert len(at_rest) > 0.99 * len(solved), sorted(set(solved) - set(at_rest))
    work = {seed: balloon.report.factorisations for seed, balloon in solved.items()}
    typical = float(np.median(list(work.values())))
    logging.getLogger(__name__).info(
        "%d outlines, %d inflated, %d at rest; factorisations: median %g, most %d",
        *(COUNT, len(solved), len(at_rest), typical, max(work.values())),
    )
    slow = {seed: count for seed, count in work.items() if count > 10.0 * typical}
    assert not slow, (typical, slow)
