# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a shape: from its outline alone, or from the balloon that was simulated.

The rules ask a gauge how thick and tight the balloon is where. Before a simulation the gauge predicts it,
afterwards it measures it; the rules are the same.
"""

from __future__ import annotations

from collections.abc import Iterator

from BalloonWorkbench.core.coach import shape, thin
from BalloonWorkbench.core.coach.findings import Advice, Finding
from BalloonWorkbench.core.coach.gauge import Gauge, Measured, Predicted
from BalloonWorkbench.core.coach.subject import Subject
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.loops import check
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.units import from_mm

INTAKE_WIDTH = from_mm(10.0)


def advise(
    outline: Outline,
    film: Film,
    *,
    fitted: bool = True,
    intake_width: float = INTAKE_WIDTH,
    intake_angle: float | None = None,
) -> Advice:
    """Advice from the outline alone, within a fraction of a second.

    fitted        the pattern will be corrected until the balloon looks like the outline; else the outline is
                  the pattern
    intake_width  of the neck through which the balloon is filled [m]
    intake_angle  its direction from the centre of the film [rad]; None for the farthest point

    Raises OutlineError for an outline that is not valid, MeshError where it is too thin to be meshed.
    """
    outline = check(outline)
    return _advice(outline, film, Predicted(outline, fitted), fitted, intake_width, intake_angle)


def advise_design(
    design: Design,
    film: Film,
    *,
    intake_width: float = INTAKE_WIDTH,
    intake_angle: float | None = None,
) -> Advice:
    """Advice from a finished design, in the frame of its drawing; arguments as for `advise`."""
    fitted = design.passes > 0
    gauge = Measured(design.inflation, fitted)
    return _advice(design.target, film, gauge, fitted, intake_width, intake_angle)


def _advice(
    outline: Outline,
    film: Film,
    gauge: Gauge,
    fitted: bool,
    intake_width: float,
    intake_angle: float | None,
) -> Advice:
    subject = Subject(outline, film, gauge, fitted, intake_width)
    findings = sorted(_found(subject, intake_angle), key=lambda finding: -finding.severity.rank)
    return Advice(gauge.puffiness, tuple(findings), gauge.map, gauge.inflated)


def _found(subject: Subject, intake_angle: float | None) -> Iterator[Finding]:
    yield from thin.necks(subject)
    yield from thin.arms(subject)
    yield from shape.sharp_notches(subject)
    yield from thin.tips(subject)
    yield from shape.rings(subject)
    yield from shape.roundness(subject)
    yield from shape.intake(subject, intake_angle)
