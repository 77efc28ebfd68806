# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice as plain data, for reports and documents: lengths in mm, angles in degrees."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.findings import Advice, Finding, Repair, RepairKind, Severity
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, number_text, to_mm

_DIGITS = 4  # of a mm


def advice_report(advice: Advice) -> dict[str, Any]:
    """What a report tells: the score, and the findings, the worst first."""
    return {
        "puffiness": advice.relative_volume,
        "advice": [finding_data(finding) for finding in advice.findings],
    }


def finding_data(finding: Finding) -> dict[str, Any]:
    """One finding as plain numbers, strings, lists and dicts."""
    return {
        "rule": finding.rule,
        "severity": finding.severity.value,
        "text": finding.text,
        "at_mm": _points(np.array(finding.place)),
        "extent_mm": [_points(line) for line in finding.extent],
        "repair": None if finding.repair is None else repair_data(finding.repair),
    }


def finding_from(data: dict[str, Any]) -> Finding:
    """The finding again, without what it was measured by."""
    at = from_mm(np.array(data["at_mm"], dtype=np.float64))
    return Finding(
        str(data["rule"]),
        Severity(data["severity"]),
        str(data["text"]),
        tuple(at.tolist()),
        tuple(_from_points(line) for line in data["extent_mm"]),
        np.nan,
        np.nan,
        None if data["repair"] is None else repair_from(data["repair"]),
    )


def repair_data(repair: Repair) -> dict[str, Any]:
    """One repair as plain numbers, strings, lists and dicts."""
    data: dict[str, Any] = {"kind": repair.kind.value, "points_mm": _points(repair.points)}
    if repair.kind is RepairKind.MOVE_INTAKE:
        return {**data, "angle_deg": round(float(np.degrees(repair.size)), _DIGITS)}
    if repair.kind is RepairKind.LOWER_INTAKE:
        return data
    return {**data, "size_mm": _mm(repair.size), "was_mm": _mm(repair.was)}


def repair_from(data: dict[str, Any]) -> Repair:
    """The repair again."""
    kind, points = RepairKind(data["kind"]), _from_points(data["points_mm"])
    if kind is RepairKind.MOVE_INTAKE:
        return Repair(kind, points, float(np.radians(data["angle_deg"])))
    if kind is RepairKind.LOWER_INTAKE:
        return Repair(kind, points, 0.0)
    return Repair(kind, points, from_mm(float(data["size_mm"])), from_mm(float(data["was_mm"])))


def repair_text(repair: Repair) -> str:
    """What a repair does, for a button."""
    if repair.kind is RepairKind.MOVE_INTAKE:
        return f"Move the intake to {number_text(float(np.degrees(repair.size)))}°"
    if repair.kind is RepairKind.LOWER_INTAKE:
        return "Put the intake low"
    what = "Round with a radius of" if repair.kind is RepairKind.ROUND else "Widen to"
    return f"{what} {length_text(repair.size, 2)}"


def _mm(length: float) -> float:
    return round(to_mm(length), _DIGITS)


def _points(points: Floats) -> Any:
    return np.round(to_mm(points), _DIGITS).tolist()


def _from_points(points: Any) -> Floats:
    return from_mm(np.array(points, dtype=np.float64).reshape(-1, 2))
