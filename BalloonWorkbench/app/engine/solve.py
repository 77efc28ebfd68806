# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon object asks of the engine, and what there is to tell about the answer; free of the document,
so that it may be solved in another thread."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass, replace

import numpy as np

from BalloonWorkbench.core.advice.advise import advise_design
from BalloonWorkbench.core.advice.as_data import advice_report
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.job import Settings, design_outline
from BalloonWorkbench.core.making.weight import weighing
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.core.options.option import options_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.reports import report
from BalloonWorkbench.core.reports.report import Source
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Progress, no_progress


@dataclass(frozen=True)
class Request:
    """One balloon to be designed: the drawing with its origin, and how it is made."""

    source: Source
    settings: Settings

    def key(self) -> str:
        """The same for the same balloon: what a result is labelled with.

        Numbers that went through a file or another unit differ in their last digits; those are left out.
        """
        settings, film, outline = self.settings, self.settings.film, self.source.outline
        numbers = [
            film.young_modulus,
            film.poisson_ratio,
            film.thickness,
            film.seal_width,
            settings.pressure,
            settings.mesh_size or 0.0,
        ]
        values = [
            *(f"{number:.9g}" for number in numbers),
            settings.backend,
            settings.correct,
            [len(loop) for loop in outline.loops],
            *self._unusual(),
        ]
        digest = hashlib.sha256(json.dumps(values).encode())
        for line in (*outline.loops, *outline.welds):
            digest.update((np.round(line, 9) + 0.0).tobytes())  # + 0.0: no negative zeros
        if outline.welds or outline.spots:
            digest.update(json.dumps([len(outline.spots), *map(len, outline.welds)]).encode())
        return digest.hexdigest()

    def _unusual(self) -> list[str]:
        """Options that differ from the usual ones; none in the key of a balloon without."""
        settings, film = self.settings, self.settings.film
        default = asdict(Model())
        options = {name: value for name, value in asdict(settings.model).items() if value != default[name]}
        if settings.volume is not None:
            options["volume"] = settings.volume
        if film.young_modulus_across is not None:
            options |= {"across": film.young_modulus_across, "grain": film.grain_angle}
        if film.weld_rigidity != Film.weld_rigidity:
            options["weld rigidity"] = film.weld_rigidity
        if settings.goal is not None:
            options |= {
                f"goal {name}": value for name, value in asdict(settings.goal).items() if value is not None
            }
            options |= {
                "lightness": settings.filling.lightness(settings.pressure),
                "weight": film.areal_density,
            }
        texts = {name: value if isinstance(value, str) else f"{value:.9g}" for name, value in options.items()}
        return [f"{name}={value}" for name, value in texts.items()] + self._unusual_pattern()

    def _unusual_pattern(self) -> list[str]:
        """What weighs in a pattern that differs from the usual one, where the weight decides the size."""
        if self.settings.goal is None or self.settings.goal.lift is None:
            return []
        own, default = (asdict(weighing(options)) for options in (self.settings.pattern, PatternOptions()))
        return [f"{name}={value}" for name, value in own.items() if value != default[name]]

    def design(self, progress: Progress = no_progress) -> Design:
        """The balloon and its seam; BalloonError when there is none, Cancelled when progress says stop."""
        outline = self.source.outline
        design = _design(replace(outline, notes=()), _of_balloon(self.settings), progress)
        return design.of_drawing(outline)

    def solve(self, progress: Progress = no_progress) -> tuple[Design, dict]:
        """The design, and what `describe` says about it; raises as `design` does."""
        design = self.design(progress)
        return design, self.describe(design)

    def describe(self, design: Design) -> dict:
        """What there is to tell about a design, as plain data; touches no document."""
        return describe(self, design)


def _of_balloon(settings: Settings) -> Settings:
    """Settings without how the drawing was read: that is in the outline."""
    return replace(settings, **{option.name: option.default for option in options_of(ReadingOptions)})


@memoized(most=8)
def _design(outline: Outline, settings: Settings, progress: Progress) -> Design:
    return design_outline(outline, settings, progress)


def describe(request: Request, design: Design) -> dict:
    """What there is to tell about a design, as plain data; touches no document."""
    settings, source = request.settings, request.source
    if settings.goal is not None:
        source = replace(source, outline=design.target)
    of_design = report.build(source, settings.film, design, volume=settings.volume, goal=settings.goal)
    return of_design | advice_report(advise_design(design, settings.film, options=settings.pattern))
