# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice in a document: the findings about a balloon."""

from __future__ import annotations

import json

from BalloonWorkbench.app.balloon import asks_for_many_panels, request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.core.errors import InputError

#: What is said of the intake, which may change without the balloon.
_OF_INTAKE = ("hidden_intake", "delicate_intake")


def findings(parts) -> list:
    """The core's findings about a balloon, the worst first.

    Those of its simulation where that is up to date, else those predicted from its outline. Raises
    BalloonError where the outline is of no use. Of many panels they are measured on the balloon only.
    """
    from BalloonWorkbench.app.pattern import values

    outline, balloon, pattern = parts
    if not status.is_ready(outline):
        return []
    if asks_for_many_panels(balloon):
        return _of_many(parts)
    if not (status.is_ready(balloon) and is_solved(balloon)):
        return predicted(parts)
    merged = [finding for finding in stored(balloon) if finding.rule not in _OF_INTAKE]
    merged += _of_intake(balloon, values(pattern))
    return sorted(merged, key=lambda finding: -finding.severity.rank)


def _of_many(parts) -> list:
    """The findings about a balloon of many panels, with places on it."""
    from BalloonWorkbench.app.engine import bag_result
    from BalloonWorkbench.app.engine.maker import safety_of
    from BalloonWorkbench.app.pattern import bag_patterns
    from BalloonWorkbench.core.advice.many_panels.bag_advice import bag_advice, design_findings
    from BalloonWorkbench.core.options.body import ACCURACY

    balloon = parts.balloon
    if not (status.is_ready(balloon) and is_solved(balloon)):
        raise InputError("Advice on many panels is measured on the balloon: inflate it first.")
    accuracy = request(balloon).settings.body.accuracy or ACCURACY
    design, film = bag_result.stored(balloon)
    if not status.is_ready(parts.pattern):
        return design_findings(design, accuracy)
    return bag_advice(design, bag_patterns(parts.pattern), film, safety_of(balloon), accuracy)


def _of_intake(balloon, options) -> list:
    """The findings about the intake of a balloon that has a result, on the outline."""
    from BalloonWorkbench.app.engine import film_result
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.advice.advise import intake_findings

    inflation, film = film_result.stored(balloon)
    seam, drawn = part_shapes.stored(balloon, "Seam"), film_result.drawing(balloon)
    return _on_outline(balloon, intake_findings(drawn, film, inflation, seam, balloon.Passes > 0, options))


def is_solved(balloon) -> bool:
    """The result belongs to the present values."""

    return bool(balloon.Report) and balloon.SolvedFor == request(balloon).key()


def stored(balloon) -> list:
    """The findings kept with a result, on the outline; a goal may have made the balloon larger."""
    from BalloonWorkbench.core.advice.as_data import finding_from

    report = json.loads(balloon.Report)
    return _on_outline(balloon, [finding_from(data) for data in report.get("advice", [])])


def _on_outline(balloon, on_drawing: list) -> list:
    """Findings in the frame of the drawing, in that of the outline."""
    from BalloonWorkbench.core.advice.repairs import finding_scaled

    outline = balloon.Outline
    if not on_drawing or not outline.SizeX:
        return on_drawing
    factor = outline.SizeX.Value / json.loads(balloon.Report)["input"]["width_mm"]
    return [finding_scaled(finding, factor) for finding in on_drawing]


def predicted(parts) -> list:
    """The findings from the outline alone."""
    return list(advice_before(parts).findings)


def advice_before(parts):
    """The core's advice from the outline alone, with the map of the thickness to be expected.

    Raises InputError for many panels.
    """
    from BalloonWorkbench.app.pattern import values
    from BalloonWorkbench.core.advice.advise import advise

    if asks_for_many_panels(parts.balloon):
        raise InputError("There is advice about two equal panels only: of many, the warnings tell.")
    asked = request(parts.balloon)
    settings = asked.settings
    return advise(asked.source.outline, settings.film, fitted=settings.correct, options=values(parts.pattern))
