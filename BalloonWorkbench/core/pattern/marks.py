# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a pattern gets besides weld and cut: notches to align both films, a tab to tie the balloon to."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, point_at
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular, unit
from BalloonWorkbench.core.options.pattern import MOST_NOTCHES
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake.kinds import FILM, intake_kind
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop, polygon
from BalloonWorkbench.core.units import from_mm, length_text, number_text

#: Notches keep that far from the intake's mouth and from each other [m].
_CLEAR = from_mm(5.0)
#: Radius of the tab's hole, and of the film round it [m].
_HOLE, _TAB = from_mm(2.0), from_mm(6.0)


def with_notches(pattern: Pattern, count: int, depth: float) -> Pattern:
    """The pattern with short cuts from the edge inward, evenly along each outer cut.

    count  for each cut; the first is where the cut begins
    depth  [m], at most the allowance, so that none touches the weld
    Raises InputError where they would be closer than 5 mm or touch the weld.
    """
    if count == 0:
        return pattern
    if not (0 <= count <= MOST_NOTCHES and depth > 0.0):
        raise InputError(f"There can be 0 to {MOST_NOTCHES} notches, not {count}, with a depth above 0.")
    marks = [mark for cut in pattern.of(Role.CUT) for mark in _notches(cut, pattern, count, depth)]
    seals = _seals(pattern)
    package = shapely()
    welded = 0.5 * pattern.seal_width
    if any(package.LineString(mark.points).distance(seals) < welded - from_mm(0.02) for mark in marks):
        room = min(package.Point(mark.points[0]).distance(seals) for mark in marks) - welded
        raise InputError(
            f"Notches of {length_text(depth)} do not end before the weld: the allowance is"
            f" {length_text(room)}."
        )
    return replace(pattern, contours=(*marks, *pattern.contours))


def _notches(cut: Contour, pattern: Pattern, count: int, depth: float) -> list[Contour]:
    along = arc_lengths(cut.points)
    if along[-1] / count < _CLEAR:
        raise InputError(f"{count} notches are closer than {length_text(_CLEAR)}: take fewer.")
    places = np.arange(count) * along[-1] / count
    edges = np.searchsorted(along, places, side="right") - 1
    at = point_at(cut.points, along, places)
    inward = perpendicular(unit(edge_vectors(cut.points)[edges]))  # outer cuts run counter-clockwise
    free = np.ones(count, dtype=bool)
    for intake in pattern.intakes:
        if intake_kind(intake.kind).place == FILM:
            continue
        axis = direction(intake.angle)
        beyond = (at - intake.at) @ axis
        aside = np.abs((at - intake.at) @ perpendicular(axis))
        wide = 0.5 * intake.width + 2.0 * pattern.seal_width + _CLEAR
        free &= (beyond < 0.0) | (aside > wide)
    lines = np.stack([at, at + depth * inward], axis=1)[free]
    return [Contour(Role.NOTCH, line, False) for line in lines]


def with_tie_tab(pattern: Pattern, angle: float | None = None) -> Pattern:
    """The pattern with a tab that has a hole of 4 mm, outside the weld.

    angle  direction from the middle of the pattern in which it sits [rad]; by default away from the intake,
           upward without one
    Raises InputError where the tab would run into another part of the balloon.
    """
    package = shapely()
    if angle is None:
        angle = 0.5 * np.pi if pattern.intake is None else pattern.intake.angle + np.pi
    elsewhere = InputError(
        f"The tie tab at {number_text(float(np.degrees(angle)))} degrees would run into another part:"
        " choose another angle."
    )
    if not np.isfinite(angle):
        raise elsewhere
    ahead = direction(angle)
    largest = max(pattern.of(Role.CUT), key=lambda cut: float(polygon(cut.points).area))
    film = polygon(largest.points)
    centre = np.asarray(film.centroid.coords[0])
    reach = float(np.hypot(*np.ptp(largest.points, axis=0)))
    met = package.get_coordinates(
        package.LineString([centre, centre + 2.0 * reach * ahead]).intersection(film.exterior)
    )
    if not len(met):
        raise elsewhere
    edge = met[np.argmax((met - centre) @ ahead)]
    hole_at = edge + (_HOLE + from_mm(2.0)) * ahead
    tab = package.LineString([edge - _TAB * ahead, hole_at]).buffer(_TAB, quad_segs=32)
    joined = film.union(tab)
    seals = _seals(pattern)
    hole = package.Point(hole_at).buffer(_HOLE, quad_segs=32)
    others = [polygon(cut.points) for cut in pattern.of(Role.CUT) if cut is not largest]
    if (
        joined.geom_type != "Polygon"
        or len(joined.interiors)
        or hole.distance(seals) < 0.5 * pattern.seal_width
        or any(tab.intersects(other) for other in others)
    ):
        raise elsewhere
    cut = Contour(Role.CUT, closed_loop(joined.exterior, True), True)
    round_hole = Contour(Role.CUT_INNER, closed_loop(hole.exterior, False), True)
    contours = tuple(cut if contour is largest else contour for contour in pattern.contours)
    return replace(pattern, contours=(round_hole, *contours))


def _seals(pattern: Pattern) -> Any:
    """The middles of all welds round the film, as lines of shapely."""
    return shapely().MultiLineString([seal.line for seal in pattern.of(Role.SEAL)])
