# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings about a painting, in the painting's own pixels and words."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.advice.findings import RepairKind
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.paint.painting.lengths import short
from BalloonWorkbench.gui.paint.painting.widen import Widen
from BalloonWorkbench.gui.qt import translate

_QUESTIONS = {
    "thin_arm": QT_TRANSLATE_NOOP("BalloonWorkbench", "This arm is too thin to fill: {}. Make it {}?"),
    "choked_neck": QT_TRANSLATE_NOOP(
        "BalloonWorkbench", "This neck is too thin to let the air through: {}. Make it {}?"
    ),
}


@dataclass(frozen=True)
class Remark:
    """One finding.

    severity  "hint", "warning" or "serious"
    place     in parts of the picture, y up
    step      of the painting that would repair it; None where there is none, and no question
    """

    severity: str
    text: str
    place: tuple[float, float]
    step: Widen | None = None
    question: str = ""


def remarks(findings, frame, side: float) -> tuple[Remark, ...]:
    """The core's findings, the worst first; of two about one part the worse.

    frame  turns metres in the drawing into parts of the picture; side of the picture in px
    """
    marks: list[Remark] = []
    for finding in findings:
        x, y = frame.places([finding.place[:2]])[0].tolist()
        step, question = None, ""
        repair = finding.repair
        if repair is not None and repair.kind is RepairKind.WIDEN and finding.rule in _QUESTIONS:
            points = [(side * a, side * (1.0 - b)) for a, b in frame.places(repair.points).tolist()]
            step = Widen(points, side * frame.scale * repair.was, side * frame.scale * repair.size)
            question = translate(_QUESTIONS[finding.rule]).format(
                short(to_mm(repair.was)), short(to_mm(repair.size))
            )
            if any(known.step is not None and _same(known.step, step) for known in marks):
                continue
        marks.append(Remark(finding.severity.value, finding.text, (x, y), step, question))
    return tuple(marks)


def _same(one: Widen, other: Widen) -> bool:
    """Two repairs of one part: their middles are near each other."""
    middles = [step.points[len(step.points) // 2] for step in (one, other)]
    (a, b), (x, y) = middles
    return abs(a - x) + abs(b - y) < max(one.widened, other.widened)
