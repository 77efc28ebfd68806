# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse points at on a divided body: a place on its surface, the seam that is near."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.nearest import away_from_line
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import to_mm

_SAME = 1e-4  # of the diagonal: seams so near to each other are one
_PARALLEL = 1e-12  # a triangle that is seen from its edge, in parts of the squared lengths of its sides


@dataclass(frozen=True)
class BodySurface:
    """A divided body in the coordinates of its object.

    points     (n, 3) mm
    triangles  (m, 3)
    panels     (m,) panel of each triangle
    seams      vertices along each seam
    """

    points: Floats
    triangles: Ints
    panels: Ints
    seams: tuple[Ints, ...]

    @classmethod
    def of(cls, made: Division) -> BodySurface:
        """That of a division."""
        target = made.target
        seams = tuple(seam.vertices for seam in made.seams)
        return cls(to_mm(target.points), target.triangles, made.panels, seams)

    def line(self, seam: int) -> Floats:
        """Points (k, 3) mm along a seam."""
        return self.points[self.seams[seam]]

    def hit(self, start: Floats, ahead: Floats) -> Floats | None:
        """The place (3,) mm at which a line of sight from a point, in a direction, meets the body first."""
        a, b, c = (self.points[self.triangles[:, corner]] for corner in range(3))
        one, other, away = b - a, c - a, start - a
        across = np.cross(ahead, other)
        along = np.einsum("mi,mi->m", one, across)
        steep = along > _PARALLEL * np.einsum("mi,mi->m", one, one)  # those that face the eye
        scale = 1.0 / np.where(steep, along, 1.0)
        u = np.einsum("mi,mi->m", away, across) * scale
        turned = np.cross(away, one)
        v = turned @ ahead * scale
        inside = steep & (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)
        if not inside.any():
            return None
        far = np.einsum("mi,mi->m", turned, other) * scale
        return np.asarray(start + far[inside].min() * ahead)

    def seam_near(self, place: Floats, near: float) -> int | None:
        """The seam that is nearest to a place (3,) mm, within so many mm; None where none is."""
        away = [away_from_line(self.line(seam), place) for seam in range(len(self.seams))]
        if not away or min(away) > near:
            return None
        return int(np.argmin(away))

    def new_lines(self, after: BodySurface) -> list[Floats]:
        """The seams (k, 3) mm of another division of this body that are none yet."""
        near = _SAME * float(np.linalg.norm(np.ptp(self.points, axis=0)))
        lines = [after.line(seam) for seam in range(len(after.seams))]
        middles = [line[len(line) // 2] if len(line) > 2 else line.mean(axis=0) for line in lines]
        return [line for line, middle in zip(lines, middles) if self.seam_near(middle, near) is None]
