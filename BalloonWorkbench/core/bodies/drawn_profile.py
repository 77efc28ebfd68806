# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile in the lines of a drawing: half an outline beside its axis, closed by the axis or not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.bodies.check_profile import checked_profile
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import extent, length
from BalloonWorkbench.core.options.body import AUTOMATIC
from BalloonWorkbench.core.readers.chains import NEAR_END, SAME_END, join
from BalloonWorkbench.core.types import Floats

#: What counts as upright, and as on the axis, in parts of the drawing's size.
_STRAIGHT = 1e-4
_DRAW = "Draw half of the outline, and its axis as a straight upright line on its left."


def profile_of_lines(
    lines: Sequence[Floats],
    lower: str = AUTOMATIC,
    upper: str = AUTOMATIC,
    *,
    axis: float | None = None,
    notes: tuple[str, ...] = (),
) -> Profile:
    """The profile in lines (n, 2) m of a drawing, closed ones with their first point repeated.

    The axis is the upright straight side of a closed outline on its left; of an open one the upright line on
    its left or, where there is none, the given place in x, and without that the leftmost point.
    Raises InputError.
    """
    loops, rest = join([line for line in lines if len(line) > 1], SAME_END)
    more, rest = join(rest, NEAR_END)
    loops += more
    points = np.concatenate([*loops, *rest]) if loops or rest else np.zeros((0, 2))
    if not len(points):
        raise InputError(f"The drawing has no line. {_DRAW}")
    near = _STRAIGHT * extent(points)
    upright = [line for line in rest if np.ptp(line[:, 0]) <= near]
    left = min(upright, key=lambda line: float(line[:, 0].min()), default=None)
    if left is not None and left[:, 0].min() <= points[:, 0].min() + near and len(loops) + len(rest) > 1:
        axis, rest = float(left[:, 0].mean()), [line for line in rest if line is not left]
    if len(loops) + len(rest) != 1:
        raise InputError(f"The drawing has {len(loops) + len(rest)} lines beside the axis, not one. {_DRAW}")
    if loops:
        line, axis = _without_axis(loops[0], near)
    else:
        line = rest[0]
        axis = float(line[:, 0].min()) if axis is None or line[:, 0].min() < axis - near else axis
    radii = line[:, 0] - axis
    return checked_profile(
        np.column_stack([np.where(np.abs(radii) <= near, 0.0, radii), line[:, 1]]), lower, upper, notes
    )


def _without_axis(loop: Floats, near: float) -> tuple[Floats, float]:
    """What a closed outline has beside its axis, as an open line, and where the axis is."""
    axis = float(loop[:, 0].min())
    on_axis = loop[:, 0] <= axis + near
    side = on_axis & np.roll(on_axis, -1)  # edges along the axis, from each point to the next
    if not side.any() or on_axis.all():
        raise InputError(
            f"The outline has no straight upright side on its left, so its axis is missing. {_DRAW}"
        )
    start = int(np.flatnonzero(side & ~np.roll(side, -1))[0]) + 1  # where the outline leaves the axis
    turned = np.roll(loop, -start, axis=0)
    count = len(loop) - int(side.sum())
    line = turned[: count + 1]
    if int((~side & np.roll(side, 1)).sum()) > 1 or length(line) <= near:
        raise InputError(f"The outline comes to its axis more than once. {_DRAW}")
    return line, axis
