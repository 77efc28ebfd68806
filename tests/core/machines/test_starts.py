# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a tool begins closed lines: on a straight, not at a corner or notch, whatever the machine.

Corners and straights are looked for on the contours' own points, without ours. All pictures with `make fuzz`.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from drawn_cuts import NAMES, made, pictured
from gcode_reader import KNIFE, LASER, ROOM, held
from test_export_cuts import COUNT
from test_sweeps import pattern as swept_pattern

from BalloonWorkbench.core.machines.machine import Machine, machine
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.pattern import Pattern

CORNER = np.radians(20.0)
#: A line that turns by less over five millimetres is a straight.
STRAIGHT = np.radians(2.0)
STEP = 0.5  # mm

#: With and without arcs, with kerf, with a knife that overcuts, of welds, on paper.
MACHINES = {
    "any": replace(machine("any-dxf"), control_bar=False),
    "beam": held("grbl", LASER, kerf=2e-4),
    "knife": held("linuxcnc", KNIFE, knife_offset=2.5e-4, arcs=True),
    "sealer": replace(machine("heat-sealer"), control_bar=False),
}


@cache
def sheet(name: str) -> Pattern:
    if name == "gored":
        return swept_pattern("ball")
    found = made(pictured(name), PatternOptions(notches=7, mirror=False, tie_tab=True))
    assert found is not None
    return found


def straights(points: np.ndarray, marks: shapely.Geometry) -> tuple[np.ndarray, bool]:
    """Corners (n, 2) of a ring [mm], and whether it goes straight on for 5 mm without marks."""
    before, after = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turns = np.arctan2(cross, (before * after).sum(axis=1))
    along = np.append(0.0, np.cumsum(np.hypot(*after.T)))
    ring = shapely.LinearRing(points)
    at = [ring.project(mark) for mark in marks.geoms if mark.distance(ring) < 0.5]
    places = np.concatenate([along[:-1], at])
    sizes = np.concatenate([np.abs(turns), np.full(len(at), np.pi)])
    for begin in np.arange(0.0, along[-1], STEP):
        within = (places - begin) % along[-1] <= 5.0
        if sizes[within].sum() < STRAIGHT:
            return points[np.abs(turns) > CORNER], True
    return points[np.abs(turns) > CORNER], False


@pytest.mark.parametrize("name", [*(NAMES if COUNT > 3 else ["star", "line-dog"]), "gored"])
def test_no_line_begins_at_a_corner_or_notch(name: str) -> None:
    pattern, tried = sheet(name), 0
    contours = [(each, 1e3 * each.points) for each in pattern.contours if each.closed]
    lines = [1e3 * each.points for each in pattern.contours if not each.closed]
    marks = shapely.MultiPoint(np.concatenate([line[[0, -1]] for line in lines]))
    known = [(each.role, shapely.LinearRing(points), *straights(points, marks)) for each, points in contours]
    for made_for in MACHINES.values():
        low = _corner(pattern, made_for)
        for path in draw(pattern, made_for).paths:
            start = path.curve.joints[0] + low
            if made_for.knife_offset:
                ahead = path.curve.joints[1] - path.curve.joints[0]
                start -= 1e3 * made_for.knife_offset * ahead / np.hypot(*ahead)
            own = [each.points[[0, -1]] for each in pattern.of(path.role) if not each.closed]
            if any(np.hypot(*(1e3 * ends - start).T).min() < 0.3 for ends in own):
                continue  # an open line, as at a neck
            for role, ring, corners, has_straight in known:
                if role is path.role and has_straight and ring.distance(shapely.Point(start)) < 0.15:
                    way = np.abs(shapely.line_locate_point(ring, shapely.points(corners)) - at(ring, start))
                    assert np.minimum(way, ring.length - way).min(initial=np.inf) > 1.9, (made_for.name, role)
                    assert marks.distance(shapely.Point(start)) > 1.9, (made_for.name, role)
                    tried += 1
    assert tried >= 3


def at(ring: shapely.LinearRing, start: np.ndarray) -> float:
    return float(ring.project(shapely.Point(start)))


def _corner(pattern: Pattern, made_for: Machine) -> np.ndarray:
    """Where the origin of the drawing is in the pattern [mm]."""
    if made_for.tool is not None:
        return 1e3 * pattern.bounds[0] - ROOM
    used = [each.points for each in pattern.contours if each.role in made_for.layers]
    return 1e3 * np.concatenate(used).min(axis=0)
