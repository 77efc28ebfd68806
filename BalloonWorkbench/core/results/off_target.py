# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the film of a balloon of many panels is from the profile or the drawing that it was made for."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_sections import beside_axis, off_profile
from BalloonWorkbench.core.bodies.gores import discs_of
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.geometry.crossings import winding
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.geometry.vectors import norm
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.target_design.off_target import TargetSurface
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats


def off_target(design: BagDesign) -> Floats | None:
    """Distances (n,) m of all vertices, positive outside; None of a bag as it is.

    Of gores from the body of revolution, of its discs from the flat ends of that, 0 where a disc is not made;
    of a body from its surface; of a letter that of the place of its silhouette which is nearest, from the
    drawing. MissingPackageError.
    """
    source = design.source
    if isinstance(source, Profile):
        return _off_body(design, source)
    if isinstance(source, Division):
        return TargetSurface(source.target).off(design.inflation.positions).distances
    return _off_drawing(design, source) if isinstance(source, Outline) else None


def _off_body(design: BagDesign, profile: Profile) -> Floats:
    positions, offsets = design.inflation.positions, design.meshed.assembly.offsets
    away, _ = off_profile(profile, beside_axis(positions))
    for number, end in discs_of(design.bag, profile):
        own = slice(offsets[number], offsets[number + 1])
        beyond = positions[own, 2] - profile.points[end, 1]
        away[own] = (beyond if end else -beyond) if design.bag.panels[number].cut else 0.0
    return away


def _off_drawing(design: BagDesign, drawing: Outline) -> Floats:
    positions, visible = design.inflation.positions[:, :2], silhouette(design.inflation)
    seen = nearest_places(visible.loops, positions)
    away = norm(nearest_places(drawing.loops, seen) - seen)
    lines = [ring(loop) for loop in drawing.loops]
    starts, ends = (
        np.concatenate([line[part] for line in lines]) for part in (slice(None, -1), slice(1, None))
    )
    return np.asarray(np.where(winding(starts, ends, seen) > 0, -away, away))
