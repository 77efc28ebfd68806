# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a shape: before its design, or on the balloon that was simulated.

The rules ask a gauge how thick and tight the balloon is where: in one coarse inflation of the first pattern,
or in the finished balloon; the rules are the same. Whether a balloon with holes stays in its plane, and its
outline where it was drawn, show coarse inflations of its pattern (rings.py).
"""

from __future__ import annotations

from collections.abc import Iterator

from BalloonWorkbench.core.advice import shape_rules, thin_rules
from BalloonWorkbench.core.advice.findings import Advice, Finding
from BalloonWorkbench.core.advice.gauge import Gauge
from BalloonWorkbench.core.advice.rings import PRESSURE
from BalloonWorkbench.core.advice.subject import Subject
from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.draft import inflate_drawing
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.solver.inflation import Inflation

_USUAL = PatternOptions()
#: Tension round a notch with the corrected pattern over that with the first one, whose notches are rounder:
#: the middle of 103 notches of the validation study is 1.29; with 1.2 its hints are right most often.
CORRECTED_PEAKS = 1.2
_VERTICES = 400  # of the mesh for advice before the design
_RULES = (
    thin_rules.necks,
    thin_rules.arms,
    shape_rules.sharp_notches,
    thin_rules.tips,
    shape_rules.rings,
    shape_rules.creases,
    shape_rules.roundness,
    shape_rules.intake,
)


@memoized(most=8)
def advise(outline: Outline, film: Film, *, fitted: bool = True, options: PatternOptions = _USUAL) -> Advice:
    """Advice before the design, from one coarse inflation, within a fraction of a second.

    fitted  the pattern will be corrected until the balloon looks like the outline; else the outline is the
            pattern
    options  how the pattern will be made

    Raises OutlineError for an outline that is not valid, MeshError where it is too thin to be meshed.
    """
    outline = check(outline)
    panel = triangulate(outline, size_for(outline, _VERTICES))
    checkpoint()
    look = inflate_drawing(outline, panel, film, PRESSURE, corrected=fitted)
    tighter = CORRECTED_PEAKS if fitted else 1.0
    gauge = Gauge(look.inflation, panel.rest_positions, look.pattern, tighter)
    return _advice(Subject(outline, film, gauge, fitted, outline, options), inflated=False)


@memoized(most=8)  # report and document ask for it
def advise_design(design: Design, film: Film, *, options: PatternOptions = _USUAL) -> Advice:
    """Advice from a finished design, in the frame of its drawing; arguments as for `advise`."""
    fitted = design.passes > 0
    gauge = _measured(design.inflation, design.pattern, fitted)
    subject = Subject(design.target, film, gauge, fitted, faired_seam(design.pattern), options)
    return _advice(subject, inflated=True)


@memoized(most=8)
def intake_findings(
    outline: Outline, film: Film, inflation: Inflation, seam: Outline, fitted: bool, options: PatternOptions
) -> list[Finding]:
    """What there is to say about the intake of a finished balloon alone; seam: of its pattern."""
    gauge = _measured(inflation, seam, fitted)
    return list(shape_rules.intake(Subject(outline, film, gauge, fitted, faired_seam(seam), options)))


def _measured(inflation: Inflation, pattern: Outline, fitted: bool) -> Gauge:
    """Of a finished balloon. fitted: it lies on its drawing; else its flat film does."""
    panel = inflation.panel
    drawn = inflation.positions[:, :2] if fitted else panel.rest_positions
    return Gauge(inflation, drawn, pattern)


def _advice(subject: Subject, inflated: bool) -> Advice:
    findings = sorted(_findings(subject), key=lambda finding: -finding.severity.rank)
    gauge = subject.gauge
    return Advice(gauge.relative_volume, tuple(findings), gauge.map, inflated)


def _findings(subject: Subject) -> Iterator[Finding]:
    for rule in _RULES:
        checkpoint()
        yield from rule(subject)
