# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison as numbers for programs and as lines for people."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from BalloonWorkbench.core.as_made.comparison import Comparison
from BalloonWorkbench.core.as_made.film_fit import FilmFit
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, number_text, percent_text, place_text, size_text, to_mm

_SCHEMA = 1


def comparison_bytes(comparison: Comparison, fit: FilmFit | None) -> bytes:
    """The content of compare.json; keys carry their units."""
    apart, placement = comparison.residual, comparison.placement
    data: dict[str, Any] = {
        "schema": _SCHEMA,
        "difference": {"mean_mm": to_mm(apart.mean), "p95_mm": to_mm(apart.p95), "max_mm": to_mm(apart.max)},
        "offset_mm": to_mm(comparison.offset),
        "expected": _size(comparison.expected_size),
        "seen": _size(comparison.size),
        "placement": {
            "turn_deg": float(np.degrees(placement.turn)),
            "size_factor": placement.size,
            "mirrored": placement.mirrored,
        },
        "stretches": [
            {
                "place_mm": _rounded(stretch.place),
                "length_mm": to_mm(stretch.end - stretch.start),
                "mean_mm": to_mm(stretch.mean),
                "max_mm": to_mm(stretch.max),
            }
            for stretch in comparison.stretches
        ],
        "outlines": {
            "expected_mm": [_rounded(loop) for loop in comparison.expected.outline.loops],
            "seen_mm": [_rounded(loop) for loop in comparison.seen.loops],
        },
        "film": None if fit is None else fit_data(fit),
        "remarks": list(comparison.remarks),
    }
    return (json.dumps(data, indent=2, allow_nan=False) + "\n").encode()


def fit_data(fit: FilmFit) -> dict[str, Any]:
    """What was fitted of a film, as its file has it too."""
    return {
        "stretch": fit.stretch,
        "stretch_error": fit.stretch_error,
        "weld_shrinkage_mm": to_mm(fit.shrinkage),
        "weld_shrinkage_error_mm": to_mm(fit.shrinkage_error),
        "told_apart": fit.apart,
        "left_mm": to_mm(fit.left),
    }


def _size(size: tuple[float, float]) -> dict[str, float]:
    return {"width_mm": to_mm(size[0]), "height_mm": to_mm(size[1])}


def _rounded(points: Floats) -> Any:
    return np.round(to_mm(points), 4).tolist()


def comparison_lines(comparison: Comparison, fit: FilmFit | None) -> list[str]:
    """What was seen, a sentence each."""
    apart = comparison.residual
    lines = [
        f"As made: {size_text(*comparison.size)}, expected: {size_text(*comparison.expected_size)}",
        f"Difference: {length_text(apart.mean, 2)} in the mean, {length_text(apart.p95, 2)} for 95 %,"
        f" {length_text(apart.max, 2)} at most",
    ]
    if comparison.stretches:
        lines.append(f"Farthest off near {place_text(comparison.stretches[0].place)}")
    if fit is not None:
        lines += _fit_lines(fit)
    return [*lines, *comparison.remarks]


def _fit_lines(fit: FilmFit) -> list[str]:
    stretch = f"{percent_text(fit.stretch)} with an error of {percent_text(fit.stretch_error)}"
    shrinkage = (
        f"{number_text(to_mm(fit.shrinkage), 2)} mm with an error of"
        f" {number_text(to_mm(fit.shrinkage_error), 2)} mm"
    )
    if fit.apart:
        return [f"Stretch of the film: {stretch}", f"The weld draws the seam inward by {shrinkage}"]
    return [
        "This shape does not tell a stretch of the film from a weld that draws the seam inward: it is either"
        f" a stretch of {stretch}, or a weld that draws it inward by {shrinkage}."
    ]
