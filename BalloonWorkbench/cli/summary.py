# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command line tells of a finished job, in the words of the window's panels."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.safety import WELD
from BalloonWorkbench.core.types import Say
from BalloonWorkbench.core.units import (
    area_text,
    from_mm,
    length_text,
    number_text,
    percent_text,
    place_text,
    pressure_text,
    size_text,
    volume_text,
)


def summary(report: dict[str, Any], film: Film, corrected: bool, say: Say) -> list[str]:
    """Lines about the balloons, notes and advice; none where there is no report.

    corrected: the pattern was, so that it says something how far the balloon is off the drawing
    """
    lines = []
    for part in report.get("parts", ()):
        lines += _balloon(part, report, corrected, say)
        lines += _making(part["maker"], film, say)
    lines += [say(f"Note: {warning}") for warning in report.get("warnings", ())]
    return lines + [_advice(finding, say) for part in report.get("parts", ()) for finding in part["advice"]]


def _balloon(part: dict[str, Any], report: dict[str, Any], corrected: bool, say: Say) -> list[str]:
    """How large it is, and how well it was met."""
    inflated, error = part["inflated"], part["design"]["silhouette_error_mm"]
    size = size_text(*(from_mm(inflated[key]) for key in ("width_mm", "height_mm", "thickness_mm")))
    lines = [say(f"Balloon: {size}, {volume_text(inflated['volume_m3'])}, solver {report['backend']}")]
    if report["load"]["kind"] == "volume":
        lines.append(say(f"Pressure: {pressure_text(part['pressure_Pa'])}"))
    if corrected:
        mean, largest = (length_text(from_mm(error[key]), 2) for key in ("mean", "max"))
        lines.append(say(f"Off the drawing: {mean} on average, at most {largest}"))
    creased = part["design"]["weld_range"]
    if creased is not None:
        mean, largest = (
            length_text(from_mm(creased["silhouette_error_mm"][key]), 2) for key in ("mean", "max")
        )
        lines.append(say(f"If the weld creases: {mean} on average, at most {largest}"))
    return lines


def bag_summary(report: dict[str, Any], film: Film, corrected: bool, say: Say) -> list[str]:
    """The same about balloons of many panels."""
    lines = []
    for part in report.get("parts", ()):
        lines += _bag(part, report, corrected, say)
        if part["maker"] is not None:
            lines += _making(part["maker"], film, say)
    warnings = report.get("warnings", ())
    lines += [say(f"Note: {warning}") for warning in warnings]
    advice = [finding for part in report.get("parts", ()) for finding in part["advice"]]
    return lines + [_advice(finding, say) for finding in advice if finding["text"] not in warnings]


def _bag(part: dict[str, Any], report: dict[str, Any], corrected: bool, say: Say) -> list[str]:
    """How large it is, how well it was met, and of how many panels it is."""
    inflated, design = part["inflated"], part["design"]
    size = size_text(*(from_mm(inflated[key]) for key in ("width_mm", "height_mm", "thickness_mm")))
    lines = [say(f"Balloon: {size}, {volume_text(inflated['volume_m3'])}, solver {report['backend']}")]
    if report["load"]["kind"] == "volume":
        lines.append(say(f"Pressure: {pressure_text(part['pressure_Pa'])}"))
    if corrected and design["error_mm"] is not None:
        error = design["error_mm"]
        mean, most, largest = (
            f"{length_text(from_mm(error[key]), 2)} ({percent_text(error[key] / design['size_mm'])})"
            for key in ("mean", "p95", "max")
        )
        whose = {"profile": "profile", "body": "body"}.get(part["target"]["kind"], "drawing")
        lines.append(say(f"Off the {whose}: {mean} on average, 95 % below {most}, at most {largest}"))
    if design["apart_mm"] > 0.0:
        apart = length_text(from_mm(design["apart_mm"]), 2)
        lines.append(say(f"Seams and middles of gores: {apart} apart at most"))
    cut = [panel for panel in part["panels"] if panel["cut"]]
    kinds = sum(panel["same_as"] is None for panel in cut)
    lines.append(say(f"Panels: {len(cut)}, of different shapes: {kinds}"))
    lines += [] if part["body"] is None else _body(part, say)
    made = [seam for seam in part["seams"] if seam["made"]]
    turned = sum(not seam["flat"] for seam in made)
    return [*lines, say(f"Seams: {len(made)}, where an edge must turn: {turned}")]


def _body(part: dict[str, Any], say: Say) -> list[str]:
    """How a balloon does the body that it was made for."""
    body, volume = part["body"], part["target"]["volume_m3"]
    least, most = (length_text(from_mm(body["clearance_mm"][key]), 3) for key in ("least", "most"))
    strain = body["flattening_strain"]
    mean, largest = (percent_text(strain[key]) for key in ("mean", "largest"))
    slack, wrinkled = percent_text(body["slack_share"]), percent_text(body["wrinkled_share"])
    hidden = percent_text(body["hidden_by_wrinkles"])
    share = percent_text(part["inflated"]["volume_m3"] / volume)
    return [
        say(f"Volume of the body: {volume_text(volume)}, the balloon has {share} of it"),
        say(f"The film lies from {least} to {most} outside of the body"),
        say(f"Panels laid flat: strained by {mean} on average, at most {largest}"),
        say(f"Loose film: {slack}, wrinkled: {wrinkled}; wrinkles hide {hidden} of it"),
    ]


def _making(maker: dict[str, Any], film: Film, say: Say) -> list[str]:
    """What it takes, whether it floats, and how much pressure it bears."""
    needed = area_text(maker["film_area_m2"])
    if maker["roll_length_mm"] is None:
        needed = say(f"{needed}; wider than the usual roll")
    else:
        length, width = (from_mm(maker[key]) for key in ("roll_length_mm", "roll_width_mm"))
        needed = say(f"{length_text(length, 3)} of a roll {length_text(width)} wide")
    seam = length_text(from_mm(maker["seam_length_mm"]), 3)
    return [
        say(f"Film: {film.title or film.name}"),
        say(f"Film needed: {needed}"),
        say(f"Seam length: {seam}"),
        *filter(None, [film.first_weld(say)]),
        *([say(f"Welding: {maker['welding']['sentence']}")] if "welding" in maker else []),
        say(f"Will it float? {maker['will_it_float']}"),
        *_strength(maker["strength"], film.seam, say),
    ]


def _strength(strong: dict[str, Any], seam: str, say: Say) -> list[str]:
    """Nothing where no strength is known."""
    safe, pressure = strong["safe_pressure_Pa"], strong["pressure_Pa"]
    if safe is None:
        return []
    weakest = seam if strong["weakest"] == WELD else strong["weakest"]
    safely = f"{pressure_text(safe)} ({weakest}, margin {number_text(strong['margin'])})"
    lines = [say(f"Safe pressure: {safely}")]
    if safe < pressure:
        lines = [say(f"Safe pressure: {safely}, less than its {pressure_text(pressure)}")]
    place = place_text(from_mm(np.array(strong["weakest_at_mm"][:2])))
    if strong["at_rest"]:
        return [*lines, say(f"Weakest place: {weakest} at {place}")]
    return [*lines, say(f"Weakest place: {weakest} at {place}, estimated: the film did not come to rest")]


def _advice(finding: dict[str, Any], say: Say) -> str:
    at = place_text(from_mm(np.array(finding["at_mm"])))
    return say(f"Advice ({finding['severity']}), at {at}: {finding['text']}")
