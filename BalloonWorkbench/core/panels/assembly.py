# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly: the panels of a balloon and the seams that join them to a closed surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.panels.surface import Surface, checked_surface
from BalloonWorkbench.core.types import Floats, Ints


@dataclass(frozen=True)
class Assembly:
    """Panels and the seams between them.

    panels  seen from the outside of the balloon, or all of those that hang together from its inside
    seams   along the boundaries: each piece of boundary is one side of one of them
    welds   along lines inside, where films are sealed together as well
    mirror  there is one panel, and it is sealed to its own mirror image along all boundaries and welds
    """

    panels: tuple[Panel, ...]
    seams: tuple[Seam, ...] = ()
    welds: tuple[Seam, ...] = ()
    mirror: bool = False

    @classmethod
    def mirrored(cls, panel: Panel) -> Assembly:
        """Two equal panels sealed along their boundaries and welds, of which one is computed."""
        return cls((panel,), mirror=True)

    def in_full(self) -> Assembly:
        """The same with both panels where one stood for its mirror image, too."""
        if not self.mirror:
            return self
        (panel,) = self.panels
        loops = [np.append(loop, loop[:1]) for loop in panel.seams]
        return Assembly((panel, panel), _with_itself(loops), _with_itself(panel.welds))

    @property
    def size(self) -> float:
        """The larger side of the largest panel [m]."""
        return max(panel.size for panel in self.panels)

    @cached_property
    def offsets(self) -> Ints:
        """Where the vertices of each panel begin when all are in one row: (p + 1,)."""
        counts = [len(panel.rest_positions) for panel in self.panels]
        return np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)

    @cached_property
    def surface(self) -> Surface:
        """The panels side by side and what is glued to what. Raises AssemblyError where they do not fit."""
        return checked_surface(self.panels, self.seams, self.welds, self.mirror)

    @property
    def stacked(self) -> bool:
        """Whether the panels lie on one another, each seam over itself, as two equal ones do."""
        return all(
            np.array_equal(self._places(seam.first), self._places(seam.second))
            for seam in (*self.seams, *self.welds)
        )

    def _places(self, run: Run) -> Floats:
        return self.panels[run.panel].rest_positions[run.vertices]

    def with_panels(self, panels: Sequence[Panel]) -> Assembly:
        """The same seams between other panels of the same boundaries."""
        return replace(self, panels=tuple(panels))


def _with_itself(lines: Sequence[Ints]) -> tuple[Seam, ...]:
    return tuple(Seam(Run(0, line), Run(1, line)) for line in lines)
