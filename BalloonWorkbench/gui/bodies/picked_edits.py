# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse has done to the seams of a body, as the edits that are kept."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.seam_edits.edit import CUT, MERGE, MOVE, SeamEdit, no_direction
from BalloonWorkbench.core.seam_edits.operations import names_at
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm
from BalloonWorkbench.gui.bags.target_display import middle_of


def merge_edit(made: Division, seam: int) -> SeamEdit:
    """The panels beside a seam become one."""
    return _edit(made, MERGE, [middle_of(made, seam)], names_at(made, made.seams[seam]))


def cut_edit(made: Division, places: Sequence[Floats]) -> SeamEdit:
    """A seam through places (3,) mm on the body."""
    return _edit(made, CUT, [from_mm(place) for place in places])


def move_edit(made: Division, seam: int, start: Floats | None, end: Floats) -> SeamEdit:
    """A seam is dragged from a place (3,) mm on it, None for its middle, to another one."""
    held = middle_of(made, seam) if start is None else from_mm(start)
    return _edit(made, MOVE, [held, from_mm(end)], names_at(made, made.seams[seam]))


def _edit(made: Division, kind: str, places: Sequence[Floats], panels: Sequence[str] = ()) -> SeamEdit:
    x, y, z = np.ptp(made.target.points, axis=0).tolist()
    return SeamEdit(kind, np.array(places), no_direction(), tuple(panels), (x, y, z))
