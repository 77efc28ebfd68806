# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules about the rim and the shape as a whole: notches, rings, roundness, the place of the intake."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.findings import Finding, Repair, RepairKind
from BalloonWorkbench.core.advice.places import NOTCH_REACH, bodies, notches, whole
from BalloonWorkbench.core.advice.rings import CREASED, creased_outlines, seam_height
from BalloonWorkbench.core.advice.rules import rules
from BalloonWorkbench.core.advice.subject import Subject
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.options.pattern import FARTHEST, LOW
from BalloonWorkbench.core.outline.chambers import chambers
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, number_text, percent_text

#: Tension is averaged over this part of the size round a notch: nearer it grows without end.
PEAK_REACH = 2.0 * NOTCH_REACH
_LARGEST_RADIUS = 0.06  # of the size, for rounding
#: Of how far the outline moves, what may remain with a wider weld for that to be worth it.
_WORTHWHILE = 0.7
#: How much of the balloon, of its size, holds the intake.
_HELD_BY = 0.15
_ANGLES = np.radians(np.arange(0.0, 360.0, 5.0))


def sharp_notches(subject: Subject) -> Iterator[Finding]:
    """Notches round which the film is much tighter than elsewhere."""
    reach = PEAK_REACH * subject.size
    limit = rules()["notch"].first(subject.scales)
    for notch in notches(subject.outline):
        measured = subject.gauge.peak(notch.place, reach)
        target_radius = min(reach * measured / limit, _LARGEST_RADIUS * subject.size)
        finding = subject.finding(
            "notch",
            measured,
            notch.place,
            (notch.extent,),
            Repair(RepairKind.ROUND, notch.place[None], target_radius)
            if target_radius > 1.2 * notch.radius
            else None,
            measured=f"{number_text(measured, 2)} times",
            wanted=length_text(target_radius, 2),
        )
        if finding is not None:
            yield finding


def rings(subject: Subject) -> Iterator[Finding]:
    """A balloon with holes that warps; spots keep their film, and with it their shape."""
    if not subject.outline.holes:
        return
    hole = min(subject.outline.holes, key=signed_area)  # the largest: they run clockwise
    height = seam_height(subject.gauge.pattern, subject.film)
    finding = subject.finding(
        "warping_ring",
        height / subject.size,
        hole.mean(axis=0),
        (hole,),
        None,
        length=length_text(height, 1),
    )
    if finding is not None:
        yield finding


def creases(subject: Subject) -> Iterator[Finding]:
    """A balloon with holes that moves where its weld creases, and much less with a weld twice as wide."""
    if not (subject.outline.holes and min(subject.seal_width, subject.film.seal_width) > 0.0):
        return
    widths = (subject.seal_width, 2.0 * subject.seal_width)
    present, wider = creased_outlines(subject.gauge.pattern, subject.film, widths)
    moved, less = present.residual.max, wider.residual.max
    if less > _WORTHWHILE * moved:
        return
    hole = min(subject.outline.holes, key=signed_area)
    finding = subject.finding(
        "creasing_ring",
        moved / subject.size,
        hole.mean(axis=0),
        (hole,),
        None,
        percent=percent_text(CREASED),
        length=length_text(moved, 2),
        wanted=length_text(widths[1], 2),
        less=length_text(less, 2),
    )
    if finding is not None:
        yield finding


def roundness(subject: Subject) -> Iterator[Finding]:
    """A shape that holds little air for its film."""
    score = subject.gauge.relative_volume
    centre = np.asarray(whole(subject.outline).representative_point().coords[0])
    finding = subject.finding(
        "flat_shape", score, centre, (subject.outline.outer,), None, percent=percent_text(score)
    )
    if finding is not None:
        yield finding


def intake(subject: Subject) -> Iterator[Finding]:
    """Intakes that open into a side part; else one that the pattern has put on a thin part."""
    if not subject.options.intake:
        return
    places = subject.intakes(subject.wish)
    hidden = [finding for at in places for finding in _hidden(subject, at, len(places) == 1)]
    yield from hidden
    if not hidden and subject.wish.is_automatic and subject.wish.place == FARTHEST:
        for at in places[:1]:
            yield from _delicate(subject, at)


def _hidden(subject: Subject, at: Floats, alone: bool) -> Iterator[Finding]:
    """An intake that opens into a side part, of its chamber where it is not alone."""
    point = shapely().Point(at)
    area = whole(subject.outline) if alone else min(chambers(subject.outline), key=point.distance)
    rooms = bodies(area, subject.intake_width / subject.growth)
    if len(rooms) < 2:
        return
    entered = min(rooms, key=point.distance)
    largest = max(rooms, key=lambda room: float(room.area))
    if entered is largest:
        return
    share = float(entered.area / area.area)
    finding = subject.finding(
        "hidden_intake",
        share,
        at,
        (at[None],),
        _moved(subject, area, rooms, largest, at) if alone else None,
        percent=percent_text(share),
    )
    if finding is not None:
        yield finding


def _moved(subject: Subject, area: Any, rooms: list[Any], largest: Any, at: Floats) -> Repair | None:
    """The direction nearest to the present one in which the intake opens into the largest part."""
    package = shapely()
    centre = np.asarray(area.centroid.coords[0])
    present = float(np.arctan2(*(at - centre)[::-1]))
    turned = np.abs(np.angle(np.exp(1j * (_ANGLES - present))))
    for angle in _ANGLES[np.argsort(turned, kind="stable")]:
        for place in subject.intakes(replace(subject.wish, angle=float(angle), along=None)):
            point = package.Point(place)
            near = point.distance(largest) < 0.25 * subject.intake_width
            if near and min(rooms, key=point.distance) is largest:
                return Repair(RepairKind.MOVE_INTAKE, place[None], float(angle))
    return None


def _delicate(subject: Subject, at: Floats) -> Iterator[Finding]:
    """An intake at the farthest point where that is a thin part: the balloon would hang from it."""
    rule, measured = rules()["delicate_intake"], _thickness_round(subject, at)
    if rule.judge(measured, subject.scales) is None:
        return
    better = [
        place
        for place in subject.intakes(replace(subject.wish, place=LOW))
        if rule.judge(_thickness_round(subject, place), subject.scales) is None
    ]
    finding = subject.finding(
        "delicate_intake",
        measured,
        at,
        (at[None],),
        Repair(RepairKind.LOWER_INTAKE, better[0][None], 0.0) if better else None,
        measured=percent_text(measured),
    )
    if finding is not None:
        yield finding


def _thickness_round(subject: Subject, at: Floats) -> float:
    """Greatest thickness within reach of a place, over that of the balloon."""
    away, turn = np.meshgrid(np.linspace(0.0, _HELD_BY, 13), _ANGLES)
    points = at + subject.size * (away[..., None] * direction(turn)).reshape(-1, 2)
    inside = points[np.asarray(shapely().contains_xy(whole(subject.outline), points[:, 0], points[:, 1]))]
    return float(subject.gauge.thickness(inside).max() / subject.gauge.thickest) if len(inside) else 0.0
