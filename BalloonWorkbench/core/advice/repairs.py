# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs: edits of an outline that a finding proposes, from outline to outline."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.findings import Finding, Repair, RepairKind
from BalloonWorkbench.core.advice.places import whole
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import place_text

_ARC = 48  # segments of a quarter circle
#: Radius at the root of what was widened, in half its width.
_ROOT = 0.7


def repaired(outline: Outline, repair: Repair) -> Outline:
    """The outline after a repair; a moved intake leaves it as it is.

    Raises OutlineError where the outline has changed so that the repair no longer fits, or where parts of it
    would meet.
    """
    if repair.kind.is_of_intake:
        return outline
    return check(_rounded(outline, repair) if repair.kind is RepairKind.ROUND else _widened(outline, repair))


def scaled(repair: Repair, factor: float) -> Repair:
    """The same repair on an outline that was scaled about the origin."""
    length = 1.0 if repair.kind.is_of_intake else factor
    return Repair(repair.kind, repair.points * factor, repair.size * length, repair.was * factor)


def finding_scaled(finding: Finding, factor: float) -> Finding:
    """The same finding, in place and repair, on an outline that was scaled about the origin."""
    return replace(
        finding,
        place=tuple(factor * value for value in finding.place),
        extent=tuple(line * factor for line in finding.extent),
        repair=None if finding.repair is None else scaled(finding.repair, factor),
    )


def _rounded(outline: Outline, repair: Repair) -> Outline:
    """A corner or notch rounded by opening and closing the area with a disc, where it lies and only there."""
    package = shapely()
    area, radius = whole(outline), repair.size
    corner = package.Point(repair.points[0])
    closed = area.buffer(radius, quad_segs=_ARC).buffer(-radius, quad_segs=_ARC)
    opened = area.buffer(-radius, quad_segs=_ARC).buffer(radius, quad_segs=_ARC)
    near = 0.25 * radius
    for pieces, change in ((closed.difference(area), area.union), (area.difference(opened), area.difference)):
        touched = [piece for piece in _solid(pieces, radius) if piece.distance(corner) < near]
        if touched:
            return _outline(change(min(touched, key=corner.distance).buffer(1e-6 * radius)), outline)
    raise OutlineError(_no_longer(repair, "there is no such corner"))


def _widened(outline: Outline, repair: Repair) -> Outline:
    """The area with a disc of the wanted width drawn along the middle line of a part, its root rounded."""
    package = shapely()
    area, half = whole(outline), 0.5 * repair.size
    line = package.LineString(repair.points)
    if not area.buffer(0.1 * repair.was).covers(line):
        raise OutlineError(_no_longer(repair, "there is no such part"))
    band = line.buffer(half, quad_segs=_ARC)
    wide = area.union(band)
    if (_across(wide, line) > 1.1 * np.maximum(_across(area, line), repair.size)).any():
        raise OutlineError(_no_longer(repair, "it would grow together with another part"))
    closed = wide.buffer(_ROOT * half, quad_segs=_ARC).buffer(-_ROOT * half, quad_segs=_ARC)
    roots = [piece for piece in _solid(closed.difference(wide), half) if piece.distance(band) < 1e-3 * half]
    rounded = package.union_all([wide, *(piece.buffer(1e-6 * half) for piece in roots)])
    holes = len(outline.loops) - 1
    return _outline(rounded if len(getattr(rounded, "interiors", ())) == holes else wide, outline)


def _solid(pieces: Any, radius: float) -> list[Any]:
    """What discs of a radius add or take off, without slivers along the sides."""
    package = shapely()
    slight = 1e-3 * radius
    solid = [piece for piece in package.get_parts(pieces.buffer(-slight)) if not piece.is_empty]
    return [pieces.intersection(piece.buffer(0.1 * radius)) for piece in solid]


def _across(area: Any, line: Any) -> Floats:
    """Widths (9,) of an area square to a line, along its middle part."""
    package = shapely()
    at = np.linspace(0.2, 0.8, 9)
    places = package.get_coordinates(package.line_interpolate_point(line, at, normalized=True))
    ahead = package.get_coordinates(package.line_interpolate_point(line, at + 0.05, normalized=True)) - places
    side = np.hypot(*np.ptp(package.get_coordinates(area.envelope), axis=0)) * unit(perpendicular(ahead))
    cuts = package.intersection(package.linestrings(np.stack([places - side, places + side], axis=1)), area)
    widths = [
        min(package.get_parts(cut), key=package.Point(place).distance).length
        for cut, place in zip(cuts, places, strict=True)
    ]
    return np.array(widths)


def _outline(area: Any, before: Outline) -> Outline:
    """An outline like one before, bounded by the largest polygon of an area."""
    largest = parts(area)[0]
    rings = [np.asarray(ring.coords, dtype=np.float64)[:-1] for ring in largest.interiors]
    if len(rings) != len(before.loops) - 1:
        raise OutlineError("A hole would open or close: draw that part anew.")
    # each hole is the one that lies nearest to where it was
    loops = [np.asarray(largest.exterior.coords, dtype=np.float64)[:-1]]
    for hole in before.loops[1:]:
        away = [float(np.linalg.norm(ring.mean(axis=0) - hole.mean(axis=0))) for ring in rings]
        loops.append(rings.pop(int(np.argmin(away))))
    return _with(before, loops)


def _with(outline: Outline, loops: list[Floats]) -> Outline:
    return replace(outline.with_loops(loops, outline.welds), notes=outline.notes)


def _no_longer(repair: Repair, why: str) -> str:
    return (
        f"The repair at {place_text(repair.points[len(repair.points) // 2])} no longer fits, {why}:"
        " take it back or draw that part anew."
    )
