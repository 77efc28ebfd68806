# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a pattern correction came to: the design, and sentences about what is not as drawn."""

from __future__ import annotations

from BalloonWorkbench.core.correction.iterate import Iterate
from BalloonWorkbench.core.design.compare import far_stretches
from BalloonWorkbench.core.design.design import Design, FarStretch
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.units import length_text, place_text

REACHED = 1e-2
NOT_AT_REST = (
    "The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh."
)
MOST_SENTENCES = 3  # about single stretches that are not reached


def summary(target: Outline, best: Iterate, passes: int, meshes: int, seconds: float) -> Design:
    """The design of the best pass, with what is to be said about it."""
    size = max(target.size)
    error = best.misfit.residual
    warnings = []
    if not best.inflation.report.converged:
        warnings.append(NOT_AT_REST)
    reached = error.mean <= REACHED * size
    unreached = far_stretches(target, best.misfit) if passes else ()
    folds = any(stretch.loop for stretch in unreached)
    if passes and not reached and folds:
        warnings.append(
            f"The inflated outline stays {length_text(error.mean)} from the drawing on average: the balloon"
            " folds across a hole or a spot."
        )
    elif passes and not reached:
        warnings.append(
            f"The inflated outline stays {length_text(error.mean)} from the drawing on average:"
            " film cannot follow this shape everywhere. Round off notches and widen thin parts."
        )
    warnings += [far_sentence(stretch, folds) for stretch in unreached[:MOST_SENTENCES]]
    return Design(
        target,
        best.seam_map.outline,
        best.inflation,
        best.silhouette,
        error,
        passes,
        meshes,
        seconds,
        reached,
        (*target.notes, *warnings),
        unreached,
    )


def far_sentence(stretch: FarStretch, folds: bool) -> str:
    """About one stretch; folds: a hole or spot is not reached, so that the balloon folds across it."""
    place, away = place_text(stretch.place), length_text(stretch.max, 3)
    length = length_text(stretch.end - stretch.start, 3)
    if folds:
        return (
            f"Near {place} the inflated outline stays up to {away} from the drawing, over a length of"
            f" {length}: the balloon folds across a hole or a spot. Make that larger, or leave it out."
        )
    return (
        f"Near {place} the inflated outline stays up to {away} from the drawing, over a length of"
        f" {length}: film cannot follow it there. Round it off or widen it."
    )
