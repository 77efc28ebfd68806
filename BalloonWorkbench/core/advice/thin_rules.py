# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules about thin parts: arms too thin to fill, necks that choke the air path, tips that stay flat."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from BalloonWorkbench.core.advice.findings import Finding, Repair, RepairKind, Severity
from BalloonWorkbench.core.advice.places import PlaceKind, ThinPart, rim_near, simple_line
from BalloonWorkbench.core.advice.rules import rules
from BalloonWorkbench.core.advice.subject import Subject
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, percent_text

#: Parts are looked for up to this much wider than the limit: the prediction is not exact.
_MARGIN = 1.15
#: What is widened gets this much more than the limit asks for.
_ENOUGH = 1.2
#: From a tip, thickness is looked for in these directions off its middle, up to this part of the size.
_FAN = np.radians([-25.0, -10.0, 0.0, 10.0, 25.0])
_FARTHEST = 0.3
#: An arm is longer than this, in widths; less is a bulge of the rim.
_ARM = 1.0


def arms(subject: Subject) -> Iterator[Finding]:
    """Arms and strands too thin to fill."""
    rule = rules()["thin_arm"]
    for part in subject.thin(_MARGIN * subject.width_for(rule.first(subject.scales))):
        width = float(np.median(part.sections.widths))
        if part.kind is PlaceKind.TIP or part.length < _ARM * width:
            continue
        measured = float(np.median(subject.gauge.thickness(part.sections.middles)))
        judged = rule.judge(measured, subject.scales)
        if judged is None:
            continue
        target_width = _arm_width(subject, judged[0].severity)
        finding = subject.finding(
            "thin_arm",
            measured,
            part.middle[len(part.middle) // 2],
            rim_near(subject.outline, part.area, 0.02 * width),
            _widening(part, width, target_width),
            width=length_text(width, 2),
            measured=length_text(measured, 2),
            wanted=length_text(target_width, 2),
        )
        if finding is not None:
            yield finding


def _arm_width(subject: Subject, severity: Severity) -> float:
    """How wide an arm has to be [m] so that nothing as bad, or a warning at the worst, is said of it."""
    limits = [limit for limit in rules()["thin_arm"].limits if limit.severity.rank >= min(severity.rank, 1)]
    return _ENOUGH * subject.width_for(max(limit.times * subject.scales[limit.of] for limit in limits))


def necks(subject: Subject) -> Iterator[Finding]:
    """Necks through which a part of the balloon is filled."""
    rule = rules()["choked_neck"]
    for part in subject.thin(_MARGIN * rule.first(subject.scales) / subject.growth):
        if part.kind is not PlaceKind.NECK:
            continue
        start, end = part.narrowest
        width = float(np.linalg.norm(end - start))
        measured = subject.gauge.tube(start, end)
        judged = rule.judge(measured, subject.scales)
        if judged is None:
            continue
        worst = judged[0].severity is Severity.HINT
        target_width = (
            _ENOUGH * (rule.first(subject.scales) if worst else subject.intake_width) / subject.growth
        )
        if part.length >= _ARM * width:  # or the arm that it is would be too thin next
            target_width = max(target_width, _arm_width(subject, Severity.WARNING))
        target_width = max(target_width, 1.2 * width)
        finding = subject.finding(
            "choked_neck",
            measured,
            0.5 * (start + end),
            (np.stack([start, end]), *rim_near(subject.outline, part.area, 0.02 * width)),
            _widening(part, width, target_width),
            measured=length_text(measured, 2),
            intake=length_text(subject.intake_width, 2),
            behind=percent_text(part.behind),
            wanted=length_text(target_width, 2),
        )
        if finding is not None:
            yield finding


def tips(subject: Subject) -> Iterator[Finding]:
    """Pointed ends that stay flat."""
    enough = 2.0 * subject.film.seal_width
    width = subject.width_for(enough)
    for part in subject.thin(_MARGIN * width):
        if part.kind is not PlaceKind.TIP:
            continue
        flat = _flat_length(subject, part, enough)
        finding = subject.finding(
            "flat_tip",
            flat / subject.size,
            part.middle[0],
            rim_near(subject.outline, part.area, 0.02 * width),
            Repair(RepairKind.ROUND, part.middle[:1], 0.5 * width),
            length=length_text(flat, 2),
            wanted=length_text(0.5 * width, 2),
        )
        if finding is not None:
            yield finding


def _flat_length(subject: Subject, part: ThinPart, enough: float) -> float:
    """Distance [m] from the point of a tip to where the balloon is thick enough."""
    apex = part.middle[0]
    inward = part.middle.mean(axis=0) - apex
    directions = direction(np.arctan2(inward[1], inward[0]) + _FAN)
    away = np.linspace(0.0, _FARTHEST * subject.size, 76)
    thickness = subject.gauge.thickness((apex + away[:, None, None] * directions).reshape(-1, 2))
    thick = (thickness.reshape(len(away), -1) >= enough).any(axis=1)
    return float(away[np.argmax(thick)]) if thick.any() else part.length


def _widening(part: ThinPart, width: float, target_width: float) -> Repair:
    line: Floats = simple_line(part.middle, 0.03 * width)
    return Repair(RepairKind.WIDEN, line, target_width, width)
