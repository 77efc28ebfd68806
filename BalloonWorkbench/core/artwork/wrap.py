# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the film of a balloon of many panels is in a picture that is wrapped round it.

A body of gores is unrolled: right in the picture is round the axis, up is along it. Of any other balloon the
panels that face the viewer and those that face away have the picture as it is seen along z; what lies
edge-on in between takes the colours at the picture's edge.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.artwork.carry import VisibleFilm
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bodies.gores import gores_of
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Bools, Floats

_ON_AXIS = 1e-2  # of the radius


def wrapped(design: BagDesign, panels: Sequence[int]) -> tuple[list[VisibleFilm], Floats, Floats]:
    """The film of panels, flat and in the picture, and the box of the picture: low (2,) and size (2,) m.

    panels  their numbers in the bag
    """
    places = np.split(design.inflation.positions, design.inflation.assembly.offsets[1:-1])
    own = [design.inflation.assembly.panels[number] for number in panels]
    if not isinstance(design.source, Profile):
        low, high = bounds(design.inflation.positions[:, :2])
        seen = [places[number][:, :2] for number in panels]
        films = [
            VisibleFilm(panel.rest_positions, at, panel.triangles, panel.loops)
            for panel, at in zip(own, seen)
        ]
        return films, low, high - low
    radius = float(np.linalg.norm(design.inflation.positions[:, :2], axis=1).max())
    heights = design.inflation.positions[:, 2]
    bottom, up = float(heights.min()), float(np.ptp(heights))
    # the picture begins at a seam: the first gore lies in the direction of x
    begin = -np.pi / gores_of(design.bag, design.source)
    films = [_unrolled(panel, places[number], radius, begin) for panel, number in zip(own, panels)]
    return films, np.array([0.0, bottom]), np.array([2.0 * np.pi * radius, up])


def faces_away(design: BagDesign, panels: Sequence[int]) -> Bools:
    """Whether the film of each panel is mostly seen from behind: (k,)."""
    places = np.split(design.inflation.positions, design.inflation.assembly.offsets[1:-1])
    away = []
    for number in panels:
        a, b, c = (places[number][design.inflation.assembly.panels[number].triangles[:, k]] for k in range(3))
        away.append(float(np.cross(b - a, c - a)[:, 2].sum()) < 0.0)
    return np.array(away)


def _unrolled(panel: Panel, places: Floats, radius: float, begin: float) -> VisibleFilm:
    """A panel by angle and height, each triangle by itself: round the axis the angle begins anew."""
    corners = panel.triangles.ravel()
    middle = places[panel.triangles].mean(axis=1)
    centre = np.mod(np.arctan2(middle[:, 1], middle[:, 0]) - begin, 2.0 * np.pi)
    angle = np.arctan2(places[:, 1], places[:, 0]) - begin
    centre = np.repeat(centre, 3)
    # a point on the axis has no angle of its own
    apart = np.linalg.norm(places[:, :2], axis=1) > _ON_AXIS * radius
    around = centre + np.where(apart[corners], _turn(angle[corners] - centre), 0.0)
    whole = places.mean(axis=0)
    about = np.mod(np.arctan2(whole[1], whole[0]) - begin, 2.0 * np.pi)
    rim = about + np.where(apart, _turn(angle - about), 0.0)
    flat = np.concatenate([panel.rest_positions[corners], panel.rest_positions])
    seen = np.column_stack(
        [radius * np.concatenate([around, rim]), np.concatenate([places[corners, 2], places[:, 2]])]
    )
    triangles = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    loops = tuple((loop + len(corners)).astype(np.int32) for loop in panel.loops)
    return VisibleFilm(flat, seen, triangles, loops)


def _turn(angle: Floats) -> Floats:
    """Angles from -pi to pi."""
    return np.asarray(np.mod(angle + np.pi, 2.0 * np.pi) - np.pi)
