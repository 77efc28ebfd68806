# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a sketch or wire to the profile of a body of revolution: half its outline, beside its axis."""

from __future__ import annotations

import FreeCAD as App
import numpy as np

from BalloonWorkbench.app.drawings.sketch import polyline, shape_of
from BalloonWorkbench.core.bodies.drawn_profile import profile_of_lines
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.options.body import AUTOMATIC
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.units import from_mm, to_mm

_ON_AXIS = 1e-4  # distance from the axis that counts as none, in parts of the profile's size
_NO_SIZE = 1e-4  # mm
#: An upright body has its axis along z, the plane of a sketch along y.
STANDING = App.Placement(App.Vector(), App.Rotation(App.Vector(1.0, 0.0, 0.0), -90.0))


def profile_of(
    source, elements: tuple[str, ...] = (), lower: str = AUTOMATIC, upper: str = AUTOMATIC
) -> tuple[Profile, App.Placement]:
    """The profile drawn in a source, and where the upright body of it lies.

    source        a document object with a shape: a sketch, or a wire in its own xy or xz plane
    elements      names of parts of its shape; none means the whole
    lower, upper  how its ends are closed

    The axis is the only construction line of a sketch, else the straight left side of a closed line, else the
    vertical axis of its plane, x = 0. Raises InputError where there is no half outline beside an axis.
    """
    shape = shape_of(source, elements)
    size = shape.BoundBox.DiagonalLength if shape.Edges else 0.0
    if size <= _NO_SIZE:
        raise OutlineError(f"{source.Label} is empty: draw half an outline in it, beside the vertical axis.")
    plane, along = _plane(shape, source)
    axis = _axis(source) if plane is STANDING else App.Placement()
    back = np.array(axis.inverse().Matrix.A).reshape(4, 4)
    budget, lines = Budget(), []
    for edge in shape.Edges:
        line = polyline(edge, size)[:, [0, along]]
        budget.spend_points(len(line))
        lines.append(from_mm(line @ back[:2, :2].T + back[:2, 3]))
    radii, near = np.concatenate(lines)[:, 0], _ON_AXIS * from_mm(size)
    if radii.max() > near and radii.min() < -near:
        raise OutlineError(
            f"{source.Label} lies on both sides of its axis: draw half the outline, on one side."
        )
    if radii.max() <= near:  # drawn on the left
        lines = [line * (-1.0, 1.0) for line in lines]
    profile = profile_of_lines(lines, lower, upper, axis=0.0)
    beside = np.concatenate(lines)[:, 0].max() - profile.points[:, 0].max()
    moved = App.Placement(App.Vector(to_mm(float(beside)), 0.0, 0.0), App.Rotation())
    return profile, source.getGlobalPlacement() * axis * moved * plane


def _plane(shape, source):
    """How a body stands whose profile lies so, and along which axis of space its height runs."""
    box, size = shape.BoundBox, shape.BoundBox.DiagonalLength
    if box.ZLength <= _ON_AXIS * size:
        return STANDING, 1
    if box.YLength <= _ON_AXIS * size:
        return App.Placement(), 2
    raise OutlineError(f"{source.Label} is not flat: draw half the outline in a sketch.")


def _axis(source) -> App.Placement:
    """Where the axis of a sketch lies in its plane, as the y axis of a placement."""
    import Part

    count = getattr(source, "GeometryCount", 0)
    lines = [source.Geometry[number] for number in range(count) if source.getConstruction(number)]
    lines = [line for line in lines if isinstance(line, Part.LineSegment)]
    if not lines:
        return App.Placement()
    if len(lines) > 1:
        raise OutlineError(
            f"{source.Label} has {len(lines)} construction lines: leave one of them, which is the axis."
        )
    way = lines[0].EndPoint - lines[0].StartPoint
    if way.y < 0.0 or (way.y == 0.0 and way.x < 0.0):
        way = -way
    return App.Placement(lines[0].StartPoint, App.Rotation(App.Vector(0.0, 1.0, 0.0), way))
