# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edit of a division, as it is kept: what is done, where, and what it was done to."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.types import Floats

#: Two panels become one; a seam is drawn along the surface; a seam goes through another place; seams in a
#: plane; those in all planes of symmetry; a line that is projected.
MERGE, CUT, MOVE, PLANE, SYMMETRY, LINE = "merge", "cut", "move", "plane", "symmetry", "line"
#: A line is projected onto both sides of the body, or onto the one nearer to it.
BOTH, NEAR = "both", "near"


@dataclass(frozen=True)
class SeamEdit:
    """One change of a division.

    kind       MERGE, CUT, MOVE, PLANE, SYMMETRY or LINE
    points     (k, 3) m in the body's own frame: a place on the seam that goes; places on the surface that a
               seam is drawn through; a place on a seam and where it shall be; a point of the plane; the line
    direction  (3,) normal of the plane, or the direction in which the line is projected; else 0
    panels     names of the panels that it was made for; none: whatever there is
    size       (3,) m of the box round the body that it was made on; 0: of that it is applied to
    side       BOTH or NEAR of a LINE
    mirrored   it is repeated on the other side where the panels are mirror images
    source     what it was drawn in, such as the name of a sketch; none: it is one of the user's list
    """

    kind: str
    points: Floats
    direction: Floats
    panels: tuple[str, ...] = ()
    size: tuple[float, float, float] = (0.0, 0.0, 0.0)
    side: str = BOTH
    mirrored: bool = True
    source: str = ""

    def on(self, box: Floats) -> SeamEdit:
        """The edit as it is on a body in a box (3,) m of another size."""
        own = np.array(self.size)
        scale = np.where(own > 0.0, box / np.where(own > 0.0, own, 1.0), 1.0)
        along = self.direction / scale if self.kind == PLANE else self.direction * scale
        return replace(self, points=self.points * scale, direction=along)

    def image(self, middle: Floats, normal: Floats) -> SeamEdit:
        """Its mirror image behind a plane: a point (3,) and the normal (3,); of any panels."""
        behind = self.points - 2.0 * ((self.points - middle) @ normal)[:, None] * normal
        turned = self.direction - 2.0 * (self.direction @ normal) * normal
        return replace(self, points=behind, direction=turned, panels=())


def no_direction() -> Floats:
    """The direction of an edit that has none."""
    return np.zeros(3)
