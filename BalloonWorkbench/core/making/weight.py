# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the making adds to the weight of a balloon: welds, neck, and the pieces of a valve."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.option import options_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import default_pattern
from BalloonWorkbench.core.pattern.intake.places import intake_of
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.rounded import rounded


def weighing(options: PatternOptions) -> PatternOptions:
    """Those values of a pattern that its weight depends on, for one balloon; all others are the usual ones.

    Equal for patterns that weigh the same but for the last digits of their sizes.
    """
    return rounded(
        replace(
            options,
            **{option.name: option.default for option in options_of(PatternOptions) if not option.weighs},
            intake_width=intake_of(options).width,
            mirror=True,
            copies=1,
        )
    )


@memoized(most=8)
def film_and_valve(seam: Outline, film: Film, options: PatternOptions) -> tuple[float, float]:
    """Film of one panel with weld and intake [m2], and what the intake's own pieces weigh [kg].

    Where there is no room for what is wanted, the usual pattern's: the pattern itself will say what is wrong.
    """
    for each in (options, weighing(options)):  # as it is made, or at least without what weighs nothing
        try:
            pattern = make_pattern(seam, film.seal_width, each)
        except InputError:
            continue
        return pattern.film_area, valve_weight(pattern, sheet_of(pattern, weighing(options)))
    return default_pattern(seam, film, options.intake).film_area, 0.0


def valve_weight(pattern: Pattern, pieces: Pattern | None) -> float:
    """Weight of the pieces beside the panels [kg], whose cuts are no panel's; see `maker_numbers`."""
    if pieces is None:
        return 0.0
    panel = max(abs(signed_area(cut.points)) for cut in pattern.of(Role.CUT))
    areas = [abs(signed_area(cut.points)) for cut in pieces.of(Role.CUT)]
    return making().valve_film * sum(area for area in areas if area < 0.5 * panel)
