# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design: the flat pattern, the balloon it inflates to and how far that is from the drawing."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation


@dataclass(frozen=True)
class Residual:
    """Two-way distance between the drawing and the inflated silhouette [m]."""

    mean: float
    p95: float
    max: float


@dataclass(frozen=True)
class Design:
    """A balloon and the pattern it is made from.

    target      the drawing
    pattern     the seam of the flat panel, unfolded film
    inflation   the balloon, placed in the drawing's frame
    silhouette  outline of the inflated balloon seen from above, in the drawing's frame
    meshes      how often the panel was meshed; in the other passes the mesh was moved
    reached     the silhouette is within the tolerance of the drawing
    warnings    one sentence each, for the user
    """

    target: Outline
    pattern: Outline
    inflation: Inflation
    silhouette: Outline
    residual: Residual
    passes: int
    meshes: int
    seconds: float
    reached: bool
    warnings: tuple[str, ...]
