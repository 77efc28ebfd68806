# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam: which run along one panel is sealed to which run along another, or along the same one."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.types import Ints


@dataclass(frozen=True)
class Run:
    """Vertices in a row along a line of a panel; a closed run ends with the vertex at which it begins.

    panel     its index in the assembly
    vertices  indices in that panel
    """

    panel: int
    vertices: Ints


@dataclass(frozen=True)
class Seam:
    """Vertex i of the first run is sealed to vertex i of the second, which says in what direction they meet.

    A part that stays open until the balloon is filled is a seam, too: there the film closes as elsewhere.

    ease  how much longer one side may be than the other, as a part of its length; what rounding leaves is
          allowed anyway
    """

    first: Run
    second: Run
    ease: float = 0.0

    @property
    def runs(self) -> tuple[Run, Run]:
        """Both sides."""
        return self.first, self.second
