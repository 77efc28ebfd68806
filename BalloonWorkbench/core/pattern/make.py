# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern with everything on it, and what is cut for it."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.intake.kinds import intake_kind
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.marks import with_notches, with_tie_tab
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pattern.sheet import on_sheet

_ONE_SEAM = (
    "Two equal panels have one seam: what is said of the seam or edge of the opening has no effect. Say the"
    " direction of the intake, or its place along the seam."
)


@memoized(most=8)
def make_pattern(seam: Outline, seal_width: float, options: PatternOptions) -> Pattern:
    """The pattern of one panel with everything on it; seal_width is the film's [m].

    Raises what build_pattern, with_tie_tab, with_label and with_notches raise.
    """
    pattern = build_pattern(seam, seal_width, options)
    if options.tie_tab:
        pattern = with_tie_tab(pattern, options.tie_tab_angle)
    pattern = with_label(pattern, options.label, options.label_height)
    pattern = with_notches(pattern, options.notches, options.notch_depth)
    if options.intake and (options.opening or options.opening_share is not None):
        return replace(pattern, warnings=(*pattern.warnings, _ONE_SEAM))
    return pattern


def sheet_of(pattern: Pattern, options: PatternOptions) -> Pattern:
    """What is cut for it: the panel with its pieces, the second panel and copies as the options say."""
    return on_sheet(pattern, options.mirror, options.copies)


def pieces_remarks(options: PatternOptions, film: Film) -> tuple[str, ...]:
    """What is to be said of the film of the intake's pieces, a sentence each.

    Raises InputError where it does not weld to the balloon's.
    """
    kind = intake_kind(options.intake_kind)
    if not options.intake or kind.stock is None:
        return ()
    own = film.title or film.name
    if film.sealing_side is None:
        return (
            f"Whether the {kind.stock.title} of the intake's pieces welds to {own} is not known: try it on a"
            " scrap first.",
        )
    if film.sealing_side != kind.stock.sealing_side:
        good = [each.title for each in films().values() if each.sealing_side == kind.stock.sealing_side]
        raise InputError(
            f'The pieces of the intake "{kind.title}" are of {kind.stock.title}, which does not weld to'
            f" {own}: choose another intake, or a film that it welds to: {'; '.join(good)}."
        )
    return ()
