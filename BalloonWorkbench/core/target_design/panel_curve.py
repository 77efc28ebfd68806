# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near balloons of few and of many panels come to a body: a coarse balloon for each number of panels.

It is corrected once and not proved, so it stays farther away than the finished design will: measured with
Spot, spheroid, torus and rounded cube its mean distance was larger by up to a third of that, or by up to
0.1 % of the diagonal where that is more.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from BalloonWorkbench.core.errors import InputError, MeshError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.divide_flat import divide_flat
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.target_design.fit_target import begun
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Progress, no_progress, part_of

#: Numbers of panels that are looked at.
COUNTS = (6, 8, 12, 16, 24, 32, 48, 60)
#: Edges of the coarse mesh, of the usual one; how often its balloon is corrected.
COARSE, STEPS = 1.4, 1
#: What says that a body cannot be made of so many panels.
NO_BALLOON = (InputError, MeshError, SolverError)


@dataclass(frozen=True)
class CurvePoint:
    """A number of panels and what comes of it.

    panels       how many there are
    error        mean distance between film and body, the larger of both ways, in parts of the diagonal
    seam_length  [m], of all seams on the body
    seams        how many there are
    problem      why there is no balloon of so many panels; error is infinite
    """

    panels: int
    error: float
    seam_length: float = 0.0
    seams: int = 0
    problem: str = ""


@memoized(64)
def curve_point(
    target: Target,
    count: int,
    film: Film,
    pressure: float,
    *,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> CurvePoint:
    """That of so many panels, at a pressure [Pa]. Cancelled when progress returns False."""
    try:
        division = divide_flat(target, count)
        usual = begun(division, film, pressure, None, backend, model, progress)
        coarse = replace(usual, edge=COARSE * usual.edge)
        best = coarse.run(coarse.first(), 0.0, STEPS)
    except NO_BALLOON as error:
        return CurvePoint(count, float("inf"), problem=str(error))
    seams = division.seams
    return CurvePoint(
        len(division.names),
        best.residual(coarse.simulation.surface).mean / target.diagonal,
        sum(length(division.target.points[seam.vertices]) for seam in seams),
        len(seams),
    )


def panel_curve(
    target: Target,
    film: Film,
    pressure: float,
    counts: Sequence[int] = COUNTS,
    *,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> tuple[CurvePoint, ...]:
    """The points of all counts, those without a balloon as well.

    Points are remembered: what was stopped goes on where it was. Cancelled when progress returns False.
    """
    return tuple(
        curve_point(
            target,
            count,
            film,
            pressure,
            backend=backend,
            model=model,
            progress=part_of(progress, number / len(counts), (number + 1) / len(counts)),
        )
        for number, count in enumerate(counts)
    )


def envelope(points: Iterable[CurvePoint]) -> tuple[CurvePoint, ...]:
    """Those that come nearer to the body than all with fewer panels: what more panels buy."""
    best: list[CurvePoint] = []
    for point in sorted(points, key=lambda each: (each.panels, each.error)):
        if not point.problem and (not best or point.error < best[-1].error):
            best.append(point)
    return tuple(best)
