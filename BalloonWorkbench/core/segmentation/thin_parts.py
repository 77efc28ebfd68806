# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a body that are too thin for a balloon: fins and sheets, which pressure makes round."""

from __future__ import annotations

from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.units import length_text, percent_text

#: A part is thin below this thickness, of the body size, and worth a sentence from this part of the area.
_THIN, _MUCH = 0.025, 0.02


def thin_share(target: Target) -> float:
    """Part of a body's surface below which, square to it, the body ends before it is no longer thin."""
    centres = target.points[target.triangles].mean(axis=1)
    below = centres - _THIN * target.diagonal * unit(target.area_vectors)
    outside = NearestSurface(target.points, target.triangles).query(below).distances > 0.0
    return float(target.areas @ outside / target.areas.sum())


def thin_notes(target: Target) -> tuple[str, ...]:
    """A sentence for the user about thin parts, where there are such."""
    share = thin_share(target)
    if share < _MUCH:
        return ()
    return (
        f"The body is thinner than {length_text(_THIN * target.diagonal, 2)} over {percent_text(share)} of"
        " its surface: film bulges there. Make such parts of two panels of their own, or thicker.",
    )
