# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules about the rim and the shape as a whole: notches, rings, roundness, the place of the intake."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from BalloonWorkbench.core.coach.findings import Finding, Repair, RepairKind
from BalloonWorkbench.core.coach.places import NOTCH_REACH, bodies, notches, whole
from BalloonWorkbench.core.coach.rules import rules
from BalloonWorkbench.core.coach.subject import Subject, mm, percent
from BalloonWorkbench.core.outline.outline import Outline, signed_area
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

#: Tension is averaged over this part of the size round a notch: nearer it grows without end.
PEAK_REACH = 2.0 * NOTCH_REACH
_LARGEST_RADIUS = 0.06  # of the size, for rounding
_ANGLES = np.radians(np.arange(0.0, 360.0, 5.0))


def sharp_notches(subject: Subject) -> Iterator[Finding]:
    """Notches round which the film is much tighter than elsewhere."""
    reach = PEAK_REACH * subject.size
    limit = rules()["notch"].first(subject.scales)
    for notch in notches(subject.outline):
        measured = subject.gauge.peak(notch.place, reach, notch.radius)
        wanted = min(reach * measured / limit, _LARGEST_RADIUS * subject.size)
        found = subject.finding(
            "notch",
            measured,
            notch.place,
            (notch.extent,),
            Repair(RepairKind.ROUND, notch.place[None], wanted) if wanted > 1.2 * notch.radius else None,
            measured=f"{measured:.1f} times",
            wanted=mm(wanted),
        )
        if found is not None:
            yield found


def rings(subject: Subject) -> Iterator[Finding]:
    """Holes round which the balloon warps; spots keep their film, and with it their shape."""
    for hole in subject.outline.holes:
        warp = predicted_warp(subject.outline, hole)
        found = subject.finding(
            "warping_ring", warp, hole.mean(axis=0), (hole,), None, length=mm(warp * subject.size)
        )
        if found is not None:
            yield found


def predicted_warp(outline: Outline, hole: Floats) -> float:
    """Height by which the seam leaves its plane, relative to the size."""
    radius = np.sqrt(-signed_area(hole) / np.pi)
    return float(0.25 - 0.15 * 2.0 * radius / max(outline.size))


def roundness(subject: Subject) -> Iterator[Finding]:
    """A shape that holds little air for its film."""
    score = subject.gauge.puffiness
    centre = np.asarray(whole(subject.outline).representative_point().coords[0])
    found = subject.finding(
        "flat_shape", score, centre, (subject.outline.outer,), None, percent=percent(score)
    )
    if found is not None:
        yield found


def intake(subject: Subject, angle: float | None) -> Iterator[Finding]:
    """An intake, in a direction [rad] or at the farthest point, that opens into a side part."""
    area = whole(subject.outline)
    rooms = bodies(area, subject.intake_width / subject.growth)
    if len(rooms) < 2:
        return
    at = _farthest(area) if angle is None else _ray_hit(area, angle)
    if at is None:
        return
    point = shapely().Point(at)
    entered = min(rooms, key=point.distance)
    largest = max(rooms, key=lambda room: float(room.area))
    if entered is largest:
        return
    share = float(entered.area / area.area)
    found = subject.finding(
        "hidden_intake",
        share,
        at,
        (at[None],),
        _moved(area, rooms, largest, at, subject.intake_width),
        percent=percent(share),
    )
    if found is not None:
        yield found


def _moved(area: Any, rooms: list[Any], largest: Any, at: Floats, width: float) -> Repair | None:
    """The direction nearest to the present one in which the intake opens into the largest part."""
    package = shapely()
    centre = np.asarray(area.centroid.coords[0])
    present = float(np.arctan2(*(at - centre)[::-1]))
    turned = np.abs(np.angle(np.exp(1j * (_ANGLES - present))))
    for angle in _ANGLES[np.argsort(turned, kind="stable")]:
        place = _ray_hit(area, float(angle))
        if place is None:
            continue
        point = package.Point(place)
        if min(rooms, key=point.distance) is largest and point.distance(largest) < 0.25 * width:
            return Repair(RepairKind.MOVE_INTAKE, place[None], float(angle))
    return None


def _ray_hit(area: Any, angle: float) -> Floats | None:
    """Where the ray from the centre leaves the outline for good, as the intake is placed."""
    package = shapely()
    centre = np.asarray(area.centroid.coords[0])
    low_x, low_y, high_x, high_y = area.bounds
    direction = np.array([np.cos(angle), np.sin(angle)])
    ray = package.LineString([centre, centre + 2.0 * np.hypot(high_x - low_x, high_y - low_y) * direction])
    points = package.get_coordinates(ray.intersection(area.exterior))
    return points[np.argmax((points - centre) @ direction)] if len(points) else None


def _farthest(area: Any) -> Floats:
    """Where an intake sits by itself: the point of the outline farthest from the centre of the film."""
    rim = np.asarray(area.exterior.coords)
    return np.asarray(rim[np.argmax(np.linalg.norm(rim - np.asarray(area.centroid.coords[0]), axis=1))])
