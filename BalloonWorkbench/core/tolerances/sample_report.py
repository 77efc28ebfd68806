# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a sample's balloon: in the form of a design's report, as far as it goes."""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.tolerances.made_balloon import Made
from BalloonWorkbench.core.units import to_grams, to_mm


def sample_report(made: Made) -> dict[str, Any]:
    """What was measured, as plain data; keys carry their units.

    seam_error_mm  by source: mean error along the seam, positive where there is more film
    """
    width, height = made.silhouette.size
    error = made.silhouette_error
    return {
        "pressure_Pa": made.pressure,
        "solve": {"converged": made.at_rest},
        "design": {
            "silhouette_error_mm": {
                "mean": to_mm(error.mean),
                "p95": to_mm(error.p95),
                "max": to_mm(error.max),
            }
        },
        "inflated": {
            "volume_m3": made.volume,
            "thickness_mm": to_mm(made.thickness),
            "width_mm": to_mm(width),
            "height_mm": to_mm(height),
        },
        "maker": {
            "weight_g": {"all": to_grams(made.weight)},
            "floating": [{"lift_g": to_grams(made.lift)}],
            "strength": {"safe_pressure_Pa": made.safe_pressure},
        },
        "seam_error_mm": {source.key: to_mm(error) for source, error in made.seam.errors.items()},
        "warnings": [] if made.at_rest else ["The film did not come to rest: its numbers are estimates."],
    }
