# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a mesh: vertices evenly spaced along each loop, corners kept."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.mesh.sizing import SizeField
from BalloonWorkbench.core.outline.crossings import first_crossing
from BalloonWorkbench.core.outline.sampling import arc_lengths, corners, point_at
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

#: Turn within about an edge length that makes a corner [rad].
_CORNER = np.radians(30.0)


def seam_points(loops: tuple[Floats, ...], field: SizeField) -> tuple[tuple[Floats, ...], SizeField]:
    """Resampled loops (k, 2), in the order and sense given, and the field.

    Where the coarser loops would cross (a narrow slit) the field is refined. Raises MeshError when that does
    not help.
    """
    seams = tuple(_resampled(loop, field) for loop in loops)
    while (place := first_crossing(seams)) is not None:
        closer = 0.5 * float(field.at(place[None])[0])
        if closer < 0.02 * field.size:
            x, y = to_mm(place)
            raise MeshError(
                f"The outline crosses or nearly touches itself near ({x:.1f}, {y:.1f}) mm:"
                " separate the parts that meet there.",
                (float(place[0]), float(place[1])),
            )
        field = SizeField(field.size, (*field.groups, (closer, place[None])))
        seams = tuple(_resampled(loop, field) for loop in loops)
    return seams, field


def _resampled(loop: Floats, field: SizeField) -> Floats:
    lengths = arc_lengths(loop)
    around = float(lengths[-1])
    fixed = corners(loop, _CORNER, reach=min(0.6 * field.smallest, around / 8.0))
    stops = np.append(lengths[fixed], lengths[fixed[0]] + around) if len(fixed) else np.array([0.0, around])
    # Edges along the loop: the integral of 1 / size.
    fine = np.linspace(0.0, around, max(64, int(4.0 * around / field.smallest))) + stops[0]
    fine = np.union1d(fine, stops)
    density = 1.0 / field.at(point_at(loop, lengths, fine))
    count = np.append(0.0, np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(fine)))
    pieces = []
    for low, high in pairwise(np.interp(stops, fine, count)):
        edges = max(round(high - low), 1 if len(fixed) > 2 else 3)
        pieces.append(np.interp(np.linspace(low, high, edges + 1)[:-1], count, fine))
    return point_at(loop, lengths, np.concatenate(pieces))
