# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a shape: from its outline alone, or from the balloon that was simulated.

The rules ask a gauge how thick and tight the balloon is where. Before a simulation the gauge predicts it,
afterwards it measures it; the rules are the same.
"""

from __future__ import annotations

from collections.abc import Iterator

from BalloonWorkbench.core.advice import shape_rules, thin_rules
from BalloonWorkbench.core.advice.findings import Advice, Finding
from BalloonWorkbench.core.advice.gauge import Measured, Predicted
from BalloonWorkbench.core.advice.subject import Subject
from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.pattern.fairing import faired_seam
from BalloonWorkbench.core.solver.inflation import Inflation

_USUAL = PatternOptions()
_RULES = (
    thin_rules.necks,
    thin_rules.arms,
    shape_rules.sharp_notches,
    thin_rules.tips,
    shape_rules.rings,
    shape_rules.roundness,
    shape_rules.intake,
)


@memoized(most=8)
def advise(outline: Outline, film: Film, *, fitted: bool = True, wanted: PatternOptions = _USUAL) -> Advice:
    """Advice from the outline alone, within a fraction of a second.

    fitted  the pattern will be corrected until the balloon looks like the outline; else the outline is the
            pattern
    wanted  how the pattern will be made

    Raises OutlineError for an outline that is not valid, MeshError where it is too thin to be meshed.
    """
    outline = check(outline)
    return _advice(Subject(outline, film, Predicted(outline, fitted), fitted, outline, wanted))


def advise_design(design: Design, film: Film, *, wanted: PatternOptions = _USUAL) -> Advice:
    """Advice from a finished design, in the frame of its drawing; arguments as for `advise`."""
    fitted = design.passes > 0
    gauge = Measured(design.inflation, fitted)
    return _advice(Subject(design.target, film, gauge, fitted, faired_seam(design.pattern), wanted))


@memoized(most=8)
def intake_findings(
    outline: Outline, film: Film, inflation: Inflation, seam: Outline, fitted: bool, wanted: PatternOptions
) -> list[Finding]:
    """What there is to say about the intake of a finished balloon alone; seam: of its pattern."""
    gauge = Measured(inflation, fitted)
    return list(shape_rules.intake(Subject(outline, film, gauge, fitted, faired_seam(seam), wanted)))


def _advice(subject: Subject) -> Advice:
    findings = sorted(_found(subject), key=lambda finding: -finding.severity.rank)
    gauge = subject.gauge
    return Advice(gauge.puffiness, tuple(findings), gauge.map, gauge.inflated)


def _found(subject: Subject) -> Iterator[Finding]:
    for rule in _RULES:
        checkpoint()
        yield from rule(subject)
