# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly: the panels of a balloon and the seams that join them to a closed surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.panels.surface import Surface, checked_surface
from BalloonWorkbench.core.types import Ints


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
        loops = [np.append(loop, loop[:1]) for loop in panel.loops]
        return Assembly((panel, panel), _with_itself(loops), _with_itself(panel.welds))

    @property
    def size(self) -> float:
        """The larger side of the largest panel [m]."""
        return max((panel.size for panel in self.panels), default=0.0)

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
    def is_pair(self) -> bool:
        """Whether it is what in_full gives: two equal panels, sealed vertex by vertex."""
        return (
            len(self.panels) == 2
            and _equal(*self.panels)
            and all(map(_is_over_itself, self.seams + self.welds))
        )


def _equal(one: Panel, other: Panel) -> bool:
    same = np.array_equal(one.rest_positions, other.rest_positions)
    return one is other or (same and np.array_equal(one.triangles, other.triangles))


def _is_over_itself(seam: Seam) -> bool:
    first, second = seam.runs
    return first.panel != second.panel and np.array_equal(first.vertices, second.vertices)


def _with_itself(lines: Sequence[Ints]) -> tuple[Seam, ...]:
    return tuple(Seam(Run(0, line), Run(1, line)) for line in lines)
