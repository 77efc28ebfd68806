# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a balloon of many panels: its panels, its seams with both lengths, how it is put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.order import JoinStep
from BalloonWorkbench.core.bag_pattern.seams import SeamMark
from BalloonWorkbench.core.bags.bag import Side
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import bounds, perimeter, signed_area
from BalloonWorkbench.core.making.bag_numbers import inner_film
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pictures.bag_picture import upright
from BalloonWorkbench.core.reports.report import (
    SCHEMA,
    goal_data,
    load_data,
    material_data,
    pattern_data,
    solve_data,
)
from BalloonWorkbench.core.results.body_figures import BodyFigures, body_figures
from BalloonWorkbench.core.results.panel_states import panel_states
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.units import to_mm

#: Kinds of sources.
PROFILE, BANDED, BODY, BAG = "profile", "outline", "body", "bag"
#: What the report tells of each balloon.
_OF_A_PART = (
    *("pressure_Pa", "mesh", "solve", "design", "target", "body", "inflated", "panels", "seams", "assembly"),
    *("surface", "pattern", "maker", "advice", "warnings"),
)


def build_bag(
    design: BagDesign,
    patterns: BagPatterns,
    film: Film,
    *,
    file: str,
    volume: float | None = None,
    goal: SizeGoal | None = None,
) -> dict[str, Any]:
    """The report of one balloon as plain numbers, strings, lists and dicts; keys carry their units.

    volume [m3]: what was asked for instead of a pressure; goal: what decided the size
    """
    solved = design.inflation.report
    angles = [float(min_angles(panel).min()) for panel in design.inflation.assembly.panels]
    offsets = design.inflation.assembly.offsets
    figures = body_figures(design, film)
    return {
        "schema": SCHEMA,
        "input": {"file": file, "kind": kind_of(design)},
        "material": material_data(film),
        "pressure_Pa": solved.pressure,
        "load": load_data(volume),
        "backend": solved.backend,
        "mesh": {
            "vertices": int(offsets[-1]),
            "triangles": sum(len(panel.triangles) for panel in design.inflation.assembly.panels),
            "min_angle_deg": float(np.degrees(min(angles))),
        },
        "solve": solve_data(solved),
        "design": _design(design),
        "target": _target(design),
        "body": None if figures is None else figures_data(figures, design),
        "inflated": _inflated(design),
        "goal": None if goal is None else goal_data(goal),
        "panels": _panels(design, patterns, film, figures),
        "seams": [_seam(design, mark) for mark in patterns.seams],
        "assembly": [_step(design, step) for step in patterns.order],
        "surface": _surface(design),
        "pattern": pattern_data(patterns.sheet),
        "warnings": list(dict.fromkeys([*design.warnings, *patterns.warnings])),
    }


def together_bags(parts: Sequence[dict[str, Any]], sheet: Pattern) -> dict[str, Any]:
    """The report of all balloons of a drawing; what is told of one balloon is that of the largest."""
    width, height = sheet.of_stock("").size
    return {
        **parts[0],
        "sheet": {
            "width_mm": to_mm(width),
            "height_mm": to_mm(height),
            "seam_length_mm": to_mm(sheet.seam_length),
        },
        "warnings": list(
            dict.fromkeys([*(text for part in parts for text in part["warnings"]), *sheet.warnings])
        ),
        "parts": [{key: part[key] for key in _OF_A_PART} for part in parts],
    }


def kind_of(design: BagDesign) -> str:
    """What the balloon was made from."""
    source = design.source
    kinds = {Profile: PROFILE, Outline: BANDED, Division: BODY}
    return kinds.get(type(source), BAG)


def _design(design: BagDesign) -> dict[str, Any]:
    return {
        "passes": design.passes,
        "seconds": design.seconds,
        "error_mm": None if design.residual is None else _error(design.residual),
        "relative_error": None if design.residual is None else design.residual.mean / design.size,
        "size_mm": to_mm(design.size),
        "apart_mm": to_mm(design.apart),
        "reached": design.reached,
    }


def _error(error: Residual) -> dict[str, float]:
    return {"mean": to_mm(error.mean), "p95": to_mm(error.p95), "max": to_mm(error.max)}


def _target(design: BagDesign) -> dict[str, Any] | None:
    """What the balloon is compared with."""
    if isinstance(design.source, Profile):
        source = design.source
        points, ends = source.points, {"lower": source.lower, "upper": source.upper}
        width = 2.0 * float(points[:, 0].max())
        return {
            "kind": PROFILE,
            "width_mm": to_mm(width),
            "height_mm": to_mm(float(np.ptp(points[:, 1]))),
            **ends,
            "points_mm": _rounded(points),
        }
    if isinstance(design.source, Outline):
        outline = design.source
        width, height = outline.size
        return {
            "kind": BANDED,
            "width_mm": to_mm(width),
            "height_mm": to_mm(height),
            "holes": len(outline.holes),
            "points_mm": _rounded(outline.outer),
        }
    if isinstance(design.source, Division):
        target = design.source.target
        across, deep, up = (float(size) for size in np.ptp(target.points, axis=0))
        return {
            "kind": BODY,
            "width_mm": to_mm(across),
            "height_mm": to_mm(up),
            "depth_mm": to_mm(deep),
            "volume_m3": target.volume,
        }
    return None


def figures_data(figures: BodyFigures, design: BagDesign) -> dict[str, Any]:
    """How a balloon does the body that it was made for; distances both ways, the larger of both."""
    error = design.residual
    assert error is not None
    return {
        "distance_mm": _error(error),
        "distance_of_diagonal": {name: value / design.size for name, value in asdict(error).items()},
        "film_from_body_mm": _error(figures.from_film),
        "body_from_film_mm": _error(figures.from_body),
        "diagonal_mm": to_mm(design.size),
        "clearance_mm": {"least": to_mm(figures.inmost), "most": to_mm(figures.outmost)},
        "flattening_strain": asdict(figures.flattening),
        "slack_share": figures.slack,
        "wrinkled_share": figures.wrinkled,
        "hidden_by_wrinkles": figures.hidden,
    }


def _rounded(points: Any) -> list[list[float]]:
    return [[round(float(value), 3) for value in to_mm(point)] for point in points]


def _inflated(design: BagDesign) -> dict[str, Any]:
    inflation = design.inflation
    across, up, high = (float(size) for size in np.ptp(upright(design)[design.film], axis=0))
    return {
        "volume_m3": inflation.volume,
        "width_mm": to_mm(across),
        "height_mm": to_mm(up),
        "thickness_mm": to_mm(high),
        "film_area_m2": inner_film(design),
        "max_tension_N_per_m": float(inflation.tensions.max()),
    }


def _panels(
    design: BagDesign, patterns: BagPatterns, film: Film, figures: BodyFigures | None
) -> list[dict[str, Any]]:
    """Each panel of the bag in its order, with the pattern that it is cut from."""
    cut_from = {
        number: (copies.panels[0], mirrored, len(copies.panels))
        for copies in patterns.copies
        for number, mirrored in zip(copies.panels, copies.mirrored)
    }
    states = panel_states(design.inflation, film)
    listed = []
    for number, (panel, state) in enumerate(zip(design.bag.panels, states, strict=True)):
        first, mirrored, copies = cut_from.get(number, (number, False, 0))
        low, high = bounds(panel.outer)
        width, height = to_mm(high - low)
        listed.append(
            {
                "name": panel.name,
                "cut": panel.cut,
                "copies": copies,
                "same_as": None if first == number else design.bag.panels[first].name,
                "mirrored": mirrored,
                "width_mm": float(width),
                "height_mm": float(height),
                "area_m2": sum(signed_area(loop) for loop in panel.loops),
                "edge_mm": to_mm(sum(map(perimeter, panel.loops))),
                "max_tension_N_per_m": state.largest_tension,
                "area_shares": {"slack": state.slack, "wrinkled": state.wrinkled, "taut": state.taut},
                "flattening_strain": None if figures is None else asdict(figures.of_panels[number]),
            }
        )
    return listed


def _seam(design: BagDesign, mark: SeamMark) -> dict[str, Any]:
    """A seam by its number on both edges; sides as in a bag's file: panel, first and last point, hole."""
    return {
        "number": mark.number,
        "panels": [design.bag.panels[panel].name for panel in mark.panels],
        **{name: _side(design, side) for name, side in zip("ab", mark.sides)},
        "length_a_mm": to_mm(mark.length_a),
        "length_b_mm": to_mm(mark.length_b),
        "flatness_rad": mark.flatness,
        "flat": mark.flat,
        "tabs": mark.tabs,
        "made": mark.made,
    }


def _side(design: BagDesign, side: Side) -> list[Any]:
    return [design.bag.panels[side.panel].name, side.start, side.end, *([side.loop] if side.loop else [])]


def _step(design: BagDesign, step: JoinStep) -> dict[str, Any]:
    return {
        "seam": step.seam,
        "panels": [design.bag.panels[panel].name for panel in step.panels],
        "kind": step.kind,
        "flat": step.flat,
        "opening": step.opening,
    }


def _surface(design: BagDesign) -> dict[str, Any]:
    """How the panels hang together: 2 is the Euler number of a ball, 0 that of a ring."""
    topology = Topology(design.bag)
    return {
        "bodies": topology.bodies,
        "euler_number": topology.euler_number,
        "poles": [
            [[design.bag.panels[panel].name, point] for panel, loop, point in pole if loop == 0]
            for pole in topology.poles
        ],
    }
