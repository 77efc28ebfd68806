# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the rules look at: a drawing, its film and a gauge."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.advice.findings import Finding, Repair
from BalloonWorkbench.core.advice.gauge import Gauge
from BalloonWorkbench.core.advice.places import ThinPart, simple_line, thin_parts
from BalloonWorkbench.core.advice.repairs import repaired
from BalloonWorkbench.core.advice.rules import rules
from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.intake.places import Places, Wish, intake_of
from BalloonWorkbench.core.types import Floats

#: Thickness of a tube of film over its flat width.
TUBE = 2.0 / np.pi
#: Width of the film over the drawn width of an arm, where the pattern is corrected: a round tube's.
ARM_GROWTH = np.pi / 2.0
#: Marks follow the outline to this part of the size.
_DETAIL = 1e-3


@dataclass(frozen=True)
class Subject:
    """A balloon to be judged; lengths in m.

    fitted  the pattern is corrected until the balloon looks like the outline; else the outline is the pattern
    seam    of the pattern, faired; the outline where it is not known yet
    options  how the pattern is made
    """

    outline: Outline
    film: Film
    gauge: Gauge
    fitted: bool
    seam: Outline
    options: PatternOptions

    @cached_property
    def wish(self) -> Wish:
        """The intake as it is wanted."""
        return intake_of(self.options)

    @property
    def intake_width(self) -> float:
        """Inner width of the intake [m]."""
        return self.wish.width

    @property
    def seal_width(self) -> float:
        """Of the pattern [m]."""
        return self.film.seal_width if self.options.seal_width is None else self.options.seal_width

    @cached_property
    def _places(self) -> Places:
        return Places(self.seam, self.seal_width + self.options.allowance)

    def intakes(self, wish: Wish) -> list[Floats]:
        """Where in the drawing the intakes sit (2,) [m]; none where the pattern refuses them."""
        try:
            places = self._places.of(wish)
        except (InputError, OutlineError):
            return []
        return places if self.seam is self.outline else [self.gauge.drawn(place) for place in places]

    @property
    def size(self) -> float:
        """Larger dimension [m]."""
        return max(self.outline.size)

    @property
    def growth(self) -> float:
        """Flat width of the film over drawn width, in narrow parts."""
        return ARM_GROWTH if self.fitted else 1.0

    @cached_property
    def scales(self) -> dict[str, float]:
        """Values of the names that limits are given in."""
        return {
            "one": 1.0,
            "seal width": self.film.seal_width,
            "intake width": self.intake_width,
            "balloon thickness": self.gauge.thickest,
        }

    def width_for(self, thickness: float) -> float:
        """Drawn width of a narrow part that becomes so thick."""
        return thickness / (TUBE * self.growth)

    def thin(self, width: float) -> list[ThinPart]:
        """The parts drawn narrower than a width."""
        return thin_parts(self.outline, width) if width > 0.0 else []

    def finding(
        self,
        rule: str,
        measured: float,
        place: Floats,
        extent: tuple[Floats, ...],
        repair: Repair | None = None,
        /,
        **words: str,
    ) -> Finding | None:
        """What a rule says about a measure; None where all is well.

        A repair that cannot be made is left out.
        """
        judged = rules()[rule].judge(measured, self.scales)
        if judged is None:
            return None
        limit, value = judged
        text = limit.sentence.format(**words)
        at = (float(place[0]), float(place[1]))
        lines = tuple(simple_line(line, _DETAIL * self.size) for line in extent)
        return Finding(rule, limit.severity, text, at, lines, measured, value, self._possible(repair))

    def _possible(self, repair: Repair | None) -> Repair | None:
        if repair is None:
            return None
        try:
            repaired(self.outline, repair)
        except OutlineError:
            return None
        return repair
