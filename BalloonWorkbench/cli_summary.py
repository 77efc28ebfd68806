# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command line tells of a finished job."""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.maker.safety import WELD


def summary(report: dict[str, Any], corrected: bool, seam: str) -> list[str]:
    """Lines about the balloons, notes and advice; none where there is no report.

    corrected: the pattern was, so that the silhouette tells how well; seam: what the film's seam is called
    """
    lines = []
    for part in report.get("parts", ()):
        inflated, error = part["inflated"], part["design"]["silhouette_error_mm"]
        size = f"{inflated['width_mm']:.0f} x {inflated['height_mm']:.0f} x {inflated['thickness_mm']:.0f} mm"
        lines.append(f"Balloon {size}, {1e3 * inflated['volume_m3']:.2f} l, solver {report['backend']}")
        if report["load"]["kind"] == "volume":
            lines.append(f"Pressure {part['pressure_Pa']:.4g} Pa")
        if corrected:
            lines.append(
                f"Silhouette {error['mean']:.2f} mm off the drawing on average, {error['max']:.1f} mm at most"
            )
        lines.append(_lift_line(part["lift"]))
        lines.append(_making_line(part["maker"], seam))
    lines += [f"Note: {warning}" for warning in report.get("warnings", ())]
    return lines + [_advice_line(finding) for part in report.get("parts", ()) for finding in part["advice"]]


def _lift_line(lift: dict[str, Any]) -> str:
    weight, gas_name = f"Weight {lift['weight_g']:.3g} g", lift["gas"]
    if lift["floats"]:
        return f"{weight}; filled with {gas_name} it carries {lift['lift_g']:.3g} g"
    if lift["floats_from_width_mm"] is None:
        return f"{weight}; it does not float with {gas_name}"
    return f"{weight}; filled with {gas_name} it floats from {lift['floats_from_width_mm']:.0f} mm width on"


def _making_line(maker: dict[str, Any], seam: str) -> str:
    """What it takes, and how much pressure it bears."""
    strong = maker["strength"]
    told = f"Film {1e4 * maker['film_area_m2']:.0f} cm2"
    if maker["roll_length_mm"] is not None:
        told += f" from {maker['roll_length_mm']:.0f} mm of a {maker['roll_width_mm']:.0f} mm roll"
    told += f", {seam} {maker['seam_length_mm']:.0f} mm"
    if strong["safe_pressure_Pa"] is None:
        return told
    weakest = seam if strong["weakest"] == WELD else strong["weakest"]
    x, y, _ = strong["weakest_at_mm"]
    told += f"; {weakest} at ({x:.0f}, {y:.0f}) mm safe to {1e-3 * strong['safe_pressure_Pa']:.2g} kPa"
    return told if strong["at_rest"] else told + ", estimated: the film did not come to rest"


def _advice_line(finding: dict[str, Any]) -> str:
    x, y = finding["at_mm"]
    return f"Advice, {finding['severity']}, at ({x:.0f}, {y:.0f}) mm: {finding['text']}"
