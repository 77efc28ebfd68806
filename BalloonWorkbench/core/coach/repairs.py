# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs: edits of an outline that a finding proposes, from outline to outline."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.coach.findings import Repair, RepairKind
from BalloonWorkbench.core.coach.places import whole
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.outline.loops import check
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import place_text

_ARC = 16  # segments of a quarter circle
#: The pushed rim lies at (d^n + h^n)^(1/n) from the middle line: h near it, its own distance d farther off.
_SHARP = 6.0


def repaired(outline: Outline, repair: Repair) -> Outline:
    """The outline after a repair; a moved intake leaves it as it is.

    Raises OutlineError where the outline has changed so that the repair no longer fits, or where parts of it
    would meet.
    """
    if repair.kind is RepairKind.MOVE_INTAKE:
        return outline
    return check(_rounded(outline, repair) if repair.kind is RepairKind.ROUND else _widened(outline, repair))


def scaled(repair: Repair, factor: float) -> Repair:
    """The same repair on an outline that was scaled about the origin."""
    length = 1.0 if repair.kind is RepairKind.MOVE_INTAKE else factor
    return Repair(repair.kind, repair.points * factor, repair.size * length, repair.was * factor)


def _rounded(outline: Outline, repair: Repair) -> Outline:
    """A corner or notch rounded by opening and closing the area with a disc, where it lies and only there."""
    package = shapely()
    area, radius = whole(outline), repair.size
    corner = package.Point(repair.points[0])
    closed = area.buffer(radius, quad_segs=_ARC).buffer(-radius, quad_segs=_ARC)
    opened = area.buffer(-radius, quad_segs=_ARC).buffer(radius, quad_segs=_ARC)
    near = 0.25 * radius
    for pieces, change in ((closed.difference(area), area.union), (area.difference(opened), area.difference)):
        # slivers along straight sides are the arcs of the buffers
        sizeable = [piece for piece in package.get_parts(pieces) if piece.area > 1e-3 * radius**2]
        touched = [piece for piece in sizeable if piece.distance(corner) < near]
        if touched:
            return _outline(change(min(touched, key=corner.distance).buffer(1e-6 * radius)), outline)
    raise OutlineError(_no_longer(repair, "there is no such corner"))


def _widened(outline: Outline, repair: Repair) -> Outline:
    """The rim pushed away from the middle line of a part where it is nearer than half the wanted width."""
    half = 0.5 * repair.size
    area = whole(outline)
    sight = area.buffer(0.02 * repair.was)
    shapely().prepare(sight)
    loops, moved = [], False
    for loop in outline.loops:
        dense = _dense(loop, repair.points, 0.2 * half, 4.0 * half)
        nearest = _nearest(dense, repair.points)
        away = dense - nearest
        far = np.maximum(np.linalg.norm(away, axis=1), 1e-6 * half)
        pushed = (far**_SHARP + half**_SHARP) ** (1.0 / _SHARP)
        seen = far < 3.0 * half
        seen[seen] = shapely().covers(
            sight, shapely().linestrings(np.stack([nearest[seen], dense[seen]], axis=1))
        )
        moved |= bool((seen & (far < half)).any())
        loops.append(nearest + away * np.where(seen, pushed / far, 1.0)[:, None])
    if not moved:
        raise OutlineError(_no_longer(repair, "there is no such part"))
    return _with(outline, loops)


def _dense(loop: Floats, line: Floats, spacing: float, reach: float) -> Floats:
    """The loop with further points, `spacing` apart, where it comes within `reach` of a line [m]."""
    ahead = np.roll(loop, -1, axis=0)
    package = shapely()
    near = package.distance(package.linestrings(np.stack([loop, ahead], axis=1)), package.LineString(line))
    counts = np.where(near < reach, np.ceil(np.linalg.norm(ahead - loop, axis=1) / spacing), 1.0)
    pieces = [
        start + (np.arange(count) / count)[:, None] * (end - start)
        for start, end, count in zip(loop, ahead, np.maximum(counts, 1.0), strict=True)
    ]
    return np.concatenate(pieces)


def _nearest(points: Floats, line: Floats) -> Floats:
    """The nearest points (k, 2) on an open line."""
    start, ahead = line[:-1], np.diff(line, axis=0)
    share = np.einsum("kmi,mi->km", points[:, None] - start[None], ahead)
    share = np.clip(share / np.maximum(np.einsum("mi,mi->m", ahead, ahead), 1e-300), 0.0, 1.0)
    feet = start[None] + share[:, :, None] * ahead[None]
    best = np.argmin(np.linalg.norm(points[:, None] - feet, axis=2), axis=1)
    return np.asarray(feet[np.arange(len(points)), best])


def _outline(area: Any, before: Outline) -> Outline:
    """An outline like one before, bounded by the largest polygon of an area."""
    package = shapely()
    largest = max(package.get_parts(area), key=lambda part: float(part.area))
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
