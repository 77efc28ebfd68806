# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut for a balloon of many panels, and how it is put together."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from BalloonWorkbench.core.bag_pattern.copies import PanelCopies
from BalloonWorkbench.core.bag_pattern.order import JoinStep
from BalloonWorkbench.core.bag_pattern.seams import SeamMark
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pattern.sheet import repeated
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class BagPatterns:
    """The patterns of all panels, side by side on one sheet.

    panels    numbers of the panels that are cut, from 0
    names     of these panels, as people read them
    patterns  one for each of them; shifts (2,) m from the panel's own frame to its place on the sheet
    pieces    what else is cut for one balloon: caps for the points where many panels meet, an intake's own
    caps      how many of the pieces are caps; they are the first ones
    copies    the panels by their shape
    seams     all seams of the bag
    order     the seams that are made, in the order of the work
    balloons  how many of it are cut from the sheet
    warnings  one sentence each, for the user
    """

    panels: tuple[int, ...]
    names: tuple[str, ...]
    patterns: tuple[Pattern, ...]
    shifts: tuple[Floats, ...]
    pieces: tuple[Pattern, ...]
    caps: int
    copies: tuple[PanelCopies, ...]
    seams: tuple[SeamMark, ...]
    order: tuple[JoinStep, ...]
    balloons: int = 1
    warnings: tuple[str, ...] = ()

    @property
    def seal_width(self) -> float:
        """[m]."""
        return self.patterns[0].seal_width

    @property
    def piece_names(self) -> tuple[str, ...]:
        """Of the panels and of the pieces beside them, as people read them."""
        others = len(self.pieces) - self.caps
        return (
            *self.names,
            *(f"cap {number}" for number in range(1, self.caps + 1)),
            *(f"intake piece {number}" for number in range(1, others + 1)),
        )

    @property
    def film_area(self) -> float:
        """Film of one balloon's panels and caps [m2]."""
        own = (*self.patterns, *self.pieces[: self.caps])
        return sum(pattern.film_area for pattern in own)

    @property
    def seam_length(self) -> float:
        """Length of all seams that are made, openings included [m]."""
        return sum(0.5 * (seam.length_a + seam.length_b) for seam in self.seams if seam.made)

    def pattern_of(self, panel: int) -> Pattern | None:
        """The pattern of a panel by its number in the bag; None where it is not cut."""
        return self.patterns[self.panels.index(panel)] if panel in self.panels else None

    @cached_property
    def sheet(self) -> Pattern:
        """All that is cut, as often as it is wanted, as one pattern."""
        laid = (*self.patterns, *self.pieces)
        intakes = [pattern.intake for pattern in self.patterns if pattern.intake is not None]
        one = Pattern(
            tuple(contour for pattern in laid for contour in pattern.contours),
            intakes[0] if intakes else None,
            self.seal_width,
            self.seam_length,
            self.warnings,
        )
        return repeated(one, self.balloons) if self.balloons > 1 else one
