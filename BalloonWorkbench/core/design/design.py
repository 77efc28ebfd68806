# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design: the flat pattern, the balloon it inflates to and how far that is from the drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace

from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Residual:
    """Two-way distance between the drawing and the inflated silhouette [m]."""

    mean: float
    p95: float
    max: float


@dataclass(frozen=True)
class FarStretch:
    """A stretch of an outline from which another one stays away.

    loop        number of the outline's loop: 0 the outer one, then the holes
    start, end  arc lengths along it [m]; end is the larger one and may run past the loop's first point
    points      (k, 2) the outline from start to end [m]
    mean, max   distances between both outlines there [m]
    place       (2,) m, where they are farthest apart
    """

    loop: int
    start: float
    end: float
    points: Floats
    mean: float
    max: float
    place: Floats


@dataclass(frozen=True)
class WeldRange:
    """The balloon of a design whose weld crumples freely: the other bound beside its elastic one.

    residual   distance between the drawing and the silhouette of that balloon
    creases    where that silhouette stays away from the elastic one's, along the latter, the farthest first
    converged  that balloon has come to rest; else it is its last good state
    """

    residual: Residual
    creases: tuple[FarStretch, ...]
    converged: bool


@dataclass(frozen=True)
class Design:
    """A balloon and the pattern it is made from.

    target      the drawing
    pattern     the seam of the flat panel, unfolded film
    inflation   the balloon, placed in the drawing's frame
    silhouette  outline of the inflated balloon seen from above, in the drawing's frame
    meshes      how often the panel was meshed; in the other passes the mesh was moved
    reached     the silhouette is within the tolerance of the drawing
    unreached   where the silhouette stays away from the drawing, the farthest first
    weld_range  what comes out where the weld crumples; None where that was not simulated
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
    unreached: tuple[FarStretch, ...] = ()
    weld_range: WeldRange | None = None

    def of_drawing(self, outline: Outline) -> Design:
        """The same design for another drawing of the same outline: with what that one's notes say."""
        own = self.warnings[len(self.target.notes) :]
        return replace(
            self,
            target=replace(self.target, notes=outline.notes),
            warnings=(*outline.notes, *own),
        )
