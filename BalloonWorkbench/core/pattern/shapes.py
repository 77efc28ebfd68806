# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polygons of shapely from and to loops."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_lengths, oriented, point_at
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, place_text

#: Corners blunter than 60 degrees stay corners when a contour is offset; sharper ones are cut off there.
_MITRE = 2.0
#: How far simplifying may move a contour, and the shortest segment that is left [m].
TOLERANCE = from_mm(0.005)
SHORTEST = from_mm(0.05)
_CORNER = np.radians(25.0)


def polygon(loop: Floats) -> Any:
    """The area inside a loop (n, 2); OutlineError where the loop crosses itself."""
    package = shapely()
    area = package.Polygon(loop)
    if not area.is_valid:
        reason = package.is_valid_reason(area)
        where = reason[reason.find("[") + 1 : reason.find("]")].split()
        place = np.array(where, dtype=np.float64) if len(where) == 2 else loop[0]
        raise OutlineError(
            f"The pattern crosses itself near {place_text(place)}: simplify the drawing there."
        )
    return area


def offset(area: Any, distance: float) -> Any:
    """The area grown by a distance (shrunk by a negative one), corners kept."""
    return area.buffer(distance, join_style="mitre", mitre_limit=_MITRE)


def relieved(area: Any, weld: Any, half_width: float, radius: float) -> Any:
    """A cut with its corners rounded, so that film neither tears in them nor peels.

    weld  the middle of the weld beside it, as lines of shapely; half_width of it [m]
    Raises InputError where the rounding would take film from the weld.
    """
    if not (np.isfinite(radius) and radius >= 0.0):
        raise InputError("The radius of the corner relief must be 0 or above.")
    if radius == 0.0:
        return area
    steps = max(16, int(np.ceil(0.25 * np.pi / np.arccos(max(1.0 - TOLERANCE / radius, 0.5)))))
    opened = area.buffer(-radius, join_style="mitre").buffer(radius, quad_segs=steps)
    closed = opened.buffer(radius, join_style="mitre").buffer(-radius, quad_segs=steps)
    left = 0.0 if closed.is_empty else closed.boundary.distance(weld)
    if left < half_width - TOLERANCE or len(parts(closed)) != 1:
        raise InputError(
            f"A corner relief of {length_text(radius)} would cut into the weld: choose a smaller radius or a"
            " wider allowance."
        )
    return parts(closed)[0]


def closed_loop(ring: Any, counter_clockwise: bool) -> Floats:
    """Points (n, 2) of a ring without needless ones, started amid its longest smooth stretch."""
    points = _merged(np.asarray(ring.simplify(TOLERANCE).coords, dtype=np.float64)[:-1], closed=True)
    if not shapely().LinearRing(points).is_simple:  # the sides of a narrow tip have met
        points = np.asarray(ring.coords, dtype=np.float64)[:-1]
    return _begun_smoothly(oriented(points, counter_clockwise))


def open_line(line: Any) -> Floats:
    """Points (n, 2) of a line without needless ones."""
    return _merged(np.asarray(line.simplify(TOLERANCE).coords, dtype=np.float64), closed=False)


def _merged(points: Floats, closed: bool) -> Floats:
    """Without segments that are too short: their ends become one point between them."""
    while len(points) > 3:
        steps = edge_lengths(points)[: None if closed else -1]
        short = int(np.argmin(steps))
        if steps[short] >= SHORTEST:
            break
        following = (short + 1) % len(points)
        points = points.copy()
        if closed or 0 < short < len(points) - 2:
            points[short] = 0.5 * (points[short] + points[following])
        elif short:  # the ends of an open line stay
            points[short] = points[following]
        points = np.delete(points, following, axis=0)
    return points


def _begun_smoothly(points: Floats) -> Floats:
    """The loop started far from its corners, where a machine may begin a cut without leaving a mark."""
    along, sharp = arc_lengths(points), corners(points, _CORNER)
    if not len(sharp):
        return points
    stretches = np.diff(np.append(along[sharp], along[sharp[0]] + along[-1]))
    longest = int(np.argmax(np.round(stretches, 9)))
    middle = (along[sharp[longest]] + 0.5 * stretches[longest]) % along[-1]
    segment = int(np.searchsorted(along, middle, side="right")) - 1
    step = along[segment + 1] - along[segment]
    share = (middle - along[segment]) / step
    after = np.roll(points, -(segment + 1), axis=0)
    if min(share, 1.0 - share) * step < SHORTEST:
        return after if share > 0.5 else np.roll(points, -segment, axis=0)
    return np.concatenate([point_at(points, along, np.array([middle])), after])
