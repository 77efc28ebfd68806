# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of the pattern correction, and when each of them is over.

    stage     mesh     smoothing  Newton    hands over to     when
    coarse    coarser  broad      as usual  broad             the drawing is near, or nothing is gained
    broad     wanted   broad      as usual  fine, or at rest  the drawing is near, or nothing is gained
    fine      wanted   usual      as usual  -                 the pattern is good, or nothing more is gained
    at rest   wanted   usual      exact     -                 the pattern is good, or nothing more is gained

Far from the drawing a short wave in what is missing is a lean or a fold of the film, which another pattern
has not; followed, it leads astray. Film may fold one way or another round a hole, so a drawing with holes is
corrected with balloons at rest as soon as it is near.

What comes out is blown up anew, from the flat film and on other meshes. Where that is another balloon than
the one that led to the pattern, the correction goes on from it.
"""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.solver.problem import NewtonSettings

NEAR = 3e-3  # mean error, of the larger dimension, at which the next stage takes over


@dataclass(frozen=True)
class Stage:
    """How the balloons of a stage are simulated."""

    coarsening: float = 1.0  # of the mesh
    smoothing: float = 1.0  # of the corrections, in units of the usual one
    newton: NewtonSettings | None = None  # when the film is at rest; None: as usual
    following: Stage | None = None  # takes over when the drawing is near; None: this one goes on to its end


FINE = Stage()
AT_REST = Stage(newton=NewtonSettings(tolerance=1e-6))
BROAD = 2.0  # smoothing far from the drawing
COARSENING = 1.8


def first_stage(holes: bool, coarse: bool, smoothing: float = BROAD) -> Stage:
    """Where the correction of a drawing with or without holes begins; coarse: a coarse mesh saves time."""
    broad = Stage(smoothing=smoothing, following=AT_REST if holes else FINE)
    return Stage(COARSENING, smoothing, following=broad) if coarse else broad


@dataclass(frozen=True)
class Limits:
    """When a correction ends."""

    iterates: int = 24
    newton_steps: int = 450  # on the wanted mesh, some twenty-five cold inflations: then the best is shown
    stalled: int = 3  # iterates in a row that bring nothing
    enough: float = 5e-4  # mean error, of the breadth, at which nothing more is gained
    good: float = 7e-4  # and at which an iterate that brings nothing is the last one
    welds: float = NEAR  # mean error of a weld, of the balloon's larger dimension


LIMITS = Limits()


@dataclass
class History:
    """What has come out so far."""

    iterates: int = 0
    meshes: int = 0
    proofs: int = 0  # times that a pattern was blown up anew
    balloons: int = 0  # of iterates and proofs
    newton_steps: int = 0  # on the wanted mesh
    stalled: int = 0  # iterates in a row that brought nothing
    error: float = float("inf")  # mean, of the last balloon, of the drawing's larger dimension
    best_error: float = float("inf")  # mean, of the best balloon, of the drawing's breadth
    weld_error: float = 0.0  # of the best balloon, of its larger dimension


def finished(stage: Stage, history: History, limits: Limits = LIMITS) -> bool:
    """Whether no further correction is worth its balloon."""
    if history.iterates >= limits.iterates or history.newton_steps >= limits.newton_steps:
        return True
    if history.stalled > limits.stalled:
        return True
    enough = limits.good if history.stalled and stage.following is None else limits.enough
    good = history.best_error <= enough and history.weld_error <= limits.welds
    return good and stage.coarsening == 1.0


def hands_over(stage: Stage, history: History) -> bool:
    """Whether the following stage takes over."""
    return stage.following is not None and (history.error <= NEAR or history.stalled > 0)
