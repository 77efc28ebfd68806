# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tool does to a line, made up for: a beam's kerf, a swivel knife's offset, a weld's start."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.vectors import direction, wrapped
from BalloonWorkbench.core.pattern.pattern import Contour, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop, offset, polygon
from BalloonWorkbench.core.types import Floats


def without_kerf(contour: Contour, kerf: float) -> tuple[Floats, ...]:
    """Loops (n, 2) m along which a beam of width kerf [m] leaves the piece at its nominal size.

    The outer cut moves outward by half the kerf, holes inward. A hole narrower than the kerf disappears.
    """
    if kerf == 0.0 or not contour.closed:
        return (contour.points,)
    outward = 1.0 if contour.role is Role.CUT else -1.0
    counter_clockwise = contour.role is Role.CUT
    areas = parts(offset(polygon(contour.points), outward * 0.5 * kerf))
    return tuple(closed_loop(area.exterior, counter_clockwise) for area in areas)


def trailing_knife(curve: Curve, behind: float) -> Curve:
    """The way of the axis of a knife whose tip trails by a distance, so that the tip follows the curve.

    The axis is ahead of the tip along the tangent: lines shift along themselves, arcs keep their centre and
    their turn, and at a corner the axis swings round the tip.
    """
    if behind == 0.0:
        return curve
    first, last = curve.headings
    corners = curve.corners
    joints, bulges = [], []
    for k, segment in enumerate(curve.segments):
        joints += [segment.start + behind * direction(first[k]), segment.end + behind * direction(last[k])]
        bulges.append(segment.bulge)
        after = (k + 1) % len(curve.joints)
        inside = curve.closed or k + 1 < len(curve)
        if not inside:
            break
        if corners[after]:
            swing = wrapped(first[after] - last[k])
            bulges.append(float(np.tan(0.25 * swing)))
        else:
            joints.pop()
    return Curve(np.array(joints), np.array(bulges), curve.closed)


def overrun(curve: Curve, length: float) -> Curve:
    """A closed curve that runs on past its start by a length: a weld overlaps itself, a cut parts."""
    if length == 0.0:
        return curve
    joints, bulges = [*curve.joints, curve.joints[0]], list(curve.bulges)
    rest = min(length, curve.length)
    for k, segment in enumerate(curve.segments):
        run = float(curve.lengths[k])
        if run < rest:
            joints.append(segment.end)
            bulges.append(segment.bulge)
            rest -= run
            continue
        part = curve.split(k, rest / run)
        joints.append(part.joints[k + 1])
        bulges.append(float(part.bulges[k]))
        break
    return Curve(np.array(joints), np.array(bulges), False)


def prolonged(curve: Curve, before: Floats | None, after: Floats | None) -> Curve:
    """A curve with a straight way from a point (2,) to its start, and one from its end to another point."""
    if before is None and after is None:
        return curve
    joints = [*curve.joints, curve.joints[0]] if curve.closed else [*curve.joints]
    bulges = [*curve.bulges]
    if before is not None:
        joints, bulges = [before, *joints], [0.0, *bulges]
    if after is not None:
        joints, bulges = [*joints, after], [*bulges, 0.0]
    return Curve(np.array(joints), np.array(bulges), False)
