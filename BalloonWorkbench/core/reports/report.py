# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a job: the numbers that matter, by name and unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.design.design import Design, FarStretch, Residual, WeldRange
from BalloonWorkbench.core.design.size_goal import Buoyancy, SizeGoal, scaling_of
from BalloonWorkbench.core.film.filling import Filling
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.start_values import start_values_data
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.options.option import unusual
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.intake.kinds import intake_kind
from BalloonWorkbench.core.pattern.pattern import Intake, Pattern
from BalloonWorkbench.core.results.film_state import film_state, thickness
from BalloonWorkbench.core.solver.inflation import Inflation, SolveReport
from BalloonWorkbench.core.units import to_grams, to_mm

SCHEMA = 2
#: What the report tells of each shape of the drawing.
_OF_A_PART = (
    *("pressure_Pa", "mesh", "solve", "design", "inflated"),
    *("lift", "maker", "pattern", "puffiness", "advice", "warnings"),
)


@dataclass(frozen=True)
class Source:
    """Where a drawing came from: file name, kind ("picture", "svg", "dxf", "json" or "sketch"), outline."""

    file: str
    kind: str
    outline: Outline


def together(parts: Sequence[dict[str, Any]], drawing: Drawing, sheet: Pattern) -> dict[str, Any]:
    """The report of a whole drawing, from those of its shapes and the pattern sheet that all of them make.

    What is told of a single shape is that of the largest one; `parts` has it for all, the largest first.
    """
    corner = np.concatenate([part.outer for part in drawing.parts]).min(axis=0)
    return {
        **parts[0],
        "input": {
            **parts[0]["input"],
            **_size(drawing.size),
            **{key: sum(part["input"][key] for part in parts) for key in ("holes", "welds")},
            "shapes": len(drawing.parts),
        },
        "sheet": {
            **_size(sheet.of_stock("").size),
            "seam_length_mm": to_mm(sheet.seam_length),
        },
        "warnings": list(
            dict.fromkeys([*(text for part in parts for text in part["warnings"]), *sheet.warnings])
        ),
        "parts": [
            {
                "outline": {
                    "at_mm": to_mm(outline.outer.min(axis=0) - corner).tolist(),
                    **{key: part["input"][key] for key in ("width_mm", "height_mm", "holes", "welds")},
                },
                **{key: part[key] for key in _OF_A_PART},
            }
            for part, outline in zip(parts, drawing.parts, strict=True)
        ],
    }


def build(
    source: Source,
    film: Film,
    design: Design,
    pattern: Pattern | None = None,
    volume: float | None = None,
    filling: Filling | None = None,
    goal: SizeGoal | None = None,
    valve: float = 0.0,
) -> dict[str, Any]:
    """The report of one shape as plain numbers, strings, lists and dicts; keys carry their units.

    volume [m3]: what was asked for instead of a pressure; filling: what lifts, helium by default; goal: what
    decided the size, None for the drawing's own; valve: what its intake weighs besides the panels [kg].
    Without a pattern nothing is said of it and of what the balloon lifts.
    """
    return {
        "schema": SCHEMA,
        "input": _input(source),
        "material": material_data(film),
        "pressure_Pa": design.inflation.report.pressure,
        "load": load_data(volume),
        **_solved(design.inflation),
        "design": _design(design, max(source.outline.size)),
        "inflated": _inflated(design, film),
        "goal": None if goal is None else goal_data(goal),
        **({} if pattern is None else _cut(design, film, pattern, filling or Filling(), valve)),
        "warnings": [*design.warnings, *(() if pattern is None else pattern.warnings)],
    }


def _input(source: Source) -> dict[str, Any]:
    outline = source.outline
    return {
        "file": source.file,
        "kind": source.kind,
        **_size(outline.size),
        "holes": len(outline.holes),
        "welds": len(outline.welds) + len(outline.spots),
    }


def _size(size: tuple[float, float]) -> dict[str, Any]:
    return {"width_mm": to_mm(size[0]), "height_mm": to_mm(size[1])}


def material_data(film: Film) -> dict[str, Any]:
    """What the film is."""
    return {
        "name": film.name,
        "E_Pa": film.young_modulus,
        "nu": film.poisson_ratio,
        "thickness_m": film.thickness,
        "areal_density_kg_m2": film.areal_density,
        "weld_rigidity": film.weld_rigidity,
        "weld_rigidity_source": film.weld_rigidity_source,
        "start_values": start_values_data(film.start_values),
        "grain": None if film.young_modulus_across is None else _grain(film, film.young_modulus_across),
    }


def _solved(inflation: Inflation) -> dict[str, Any]:
    """By what, on which mesh, and how the balloon was simulated."""
    panel, solve = inflation.panel, inflation.report
    return {
        "backend": solve.backend,
        "mesh": {
            "vertices": len(panel.rest_positions),
            "triangles": len(panel.triangles),
            "min_angle_deg": float(np.degrees(min_angles(panel).min())),
        },
        "solve": solve_data(solve),
    }


def load_data(volume: float | None) -> dict[str, Any]:
    """What was asked for: a pressure, or a volume [m3] instead."""
    return {"kind": "pressure" if volume is None else "volume", "target_volume_m3": volume}


def solve_data(solve: SolveReport) -> dict[str, Any]:
    """How the balloon was simulated."""
    return {
        "integrator": "Newmark in time" if solve.backend == "newmark" else "quasi-static Newton",
        "options": unusual(solve.model),
        "newton_steps": solve.newton_steps,
        "factorisations": solve.factorisations,
        "seconds": solve.seconds,
        "converged": solve.converged,
        "stiffness_k": solve.stiffness_k,
        "flexural_rigidity_N_m": solve.flexural_rigidity,
        "bending_share": solve.bending_share,
    }


def _design(design: Design, size: float) -> dict[str, Any]:
    creased = design.weld_range
    return {
        "passes": design.passes,
        "meshes": design.meshes,
        "seconds": design.seconds,
        **_off(design.residual, size),
        "reached": design.reached,
        "unreached": [_stretch(stretch) for stretch in design.unreached],
        "weld_range": None if creased is None else _creased(creased, size),
    }


def _off(error: Residual, size: float) -> dict[str, Any]:
    return {
        "silhouette_error_mm": {
            "mean": to_mm(error.mean),
            "p95": to_mm(error.p95),
            "max": to_mm(error.max),
        },
        "relative_error": error.mean / size,
    }


def _creased(weld_range: WeldRange, size: float) -> dict[str, Any]:
    return {
        **_off(weld_range.residual, size),
        "creases": [_stretch(stretch) for stretch in weld_range.creases],
        "converged": weld_range.converged,
    }


def _inflated(design: Design, film: Film) -> dict[str, Any]:
    inflation = design.inflation
    state, panel = film_state(inflation, film), inflation.panel
    return {
        "volume_m3": inflation.volume,
        "thickness_mm": to_mm(float(thickness(inflation).max())),
        **_size(design.silhouette.size),
        "film_area_m2": 2.0 * float(signed_areas(panel.rest_positions, panel.triangles).sum()),
        "max_tension_N_per_m": float(inflation.tensions.max()),
        "max_strain": float(state.strains.max()),
        "area_shares": {kind.name.lower(): share for kind, share in state.shares().items()},
    }


def pattern_data(pattern: Pattern) -> dict[str, Any]:
    """How large it is, how long its seams are, where it is filled."""
    return {
        **_size(pattern.size),
        "seam_length_mm": to_mm(pattern.seam_length),
        "intake": None if pattern.intake is None else _intake(pattern.intake),
        "more_intakes": [_intake(intake) for intake in pattern.more_intakes],
    }


def goal_data(goal: SizeGoal) -> dict[str, Any]:
    """What decided the size."""
    return {"volume_m3": goal.volume, "lift_g": None if goal.lift is None else to_grams(goal.lift)}


def _cut(design: Design, film: Film, pattern: Pattern, filling: Filling, valve: float) -> dict[str, Any]:
    """What there is to tell about a pattern, and what the balloon made from it lifts."""
    return {"lift": _lift(design, film, pattern, filling, valve), "pattern": pattern_data(pattern)}


def _lift(design: Design, film: Film, pattern: Pattern, filling: Filling, valve: float) -> dict[str, Any]:
    """What the balloon weighs, what it carries, and from which width of the drawing on it floats."""
    lightness = filling.lightness(design.inflation.report.pressure)
    buoyancy = Buoyancy(lightness, film.areal_density, lambda seam: pattern.film_area, valve)
    scaling = scaling_of(design, buoyancy)
    lift, scale = scaling.lift_at(1.0, buoyancy), scaling.floating(buoyancy)
    return {
        "gas": filling.gas.name,
        "gas_temperature_K": filling.temperature,
        "air_temperature_K": filling.air_temperature,
        "altitude_m": filling.altitude,
        "weight_g": to_grams(scaling.weight_at(1.0, buoyancy)),
        "lift_g": to_grams(lift),
        "floats": lift > 0.0,
        "floats_from_width_mm": None if scale is None else to_mm(scale * design.target.size[0]),
    }


def _grain(film: Film, across: float) -> dict[str, Any]:
    return {"E_across_Pa": across, "angle_deg": float(np.degrees(film.grain_angle))}


def _stretch(stretch: FarStretch) -> dict[str, Any]:
    return {
        "loop": stretch.loop,
        "start_mm": to_mm(stretch.start),
        "end_mm": to_mm(stretch.end),
        "at_mm": [to_mm(float(value)) for value in stretch.place],
        "mean_mm": to_mm(stretch.mean),
        "max_mm": to_mm(stretch.max),
    }


def _intake(intake: Intake) -> dict[str, Any]:
    return {
        "kind": intake.kind,
        "how_to_fill": intake_kind(intake.kind).note,
        "width_mm": to_mm(intake.width),
        "length_mm": to_mm(intake.length),
        "angle_deg": float(np.degrees(intake.angle)),
        "at_mm": [to_mm(float(value)) for value in intake.at],
        "along_mm": to_mm(intake.along),
    }
