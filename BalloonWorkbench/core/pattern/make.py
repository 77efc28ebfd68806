# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that is wanted of a pattern, and the pattern made so."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.intake.kinds import STRAW, intake_kind
from BalloonWorkbench.core.pattern.intake.places import FARTHEST, Wish
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.marks import with_notches, with_tie_tab
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pattern.sheet import on_sheet


@dataclass(frozen=True)
class Wanted:
    """How a pattern is made; lengths [m], angles [rad], None where the pattern finds the value.

    seal_width  None takes the film's; the intake's values as in `build_pattern`, its place FARTHEST or LOW
    where neither angle nor along is given; corner_radius rounds corners of the cuts; mirror and copies as in
    `on_sheet`
    """

    seal_width: float | None = None
    allowance: float = 0.002
    intake: bool = True
    intake_kind: str = STRAW
    intake_width: float | None = None
    intake_length: float | None = None
    intake_angle: float | None = None
    intake_along: float | None = None
    intake_place: str = FARTHEST
    corner_radius: float = 0.0
    notches: int = 0
    notch_depth: float = 0.0015
    tie_tab: bool = False
    tie_tab_angle: float | None = None
    label: str = ""
    label_height: float = 0.006
    mirror: bool = False
    copies: int = 1


def intake_of(wanted: Wanted) -> Wish:
    """The intake as it is wanted; InputError for a kind that is not known."""
    kind = intake_kind(wanted.intake_kind)
    width = kind.width if wanted.intake_width is None else wanted.intake_width
    return Wish(
        kind, width, wanted.intake_length, wanted.intake_angle, wanted.intake_along, wanted.intake_place
    )


def make_pattern(seam: Outline, seal_width: float, wanted: Wanted) -> Pattern:
    """The pattern of one panel with everything on it; seal_width is the film's [m].

    Raises what build_pattern, with_tie_tab, with_label and with_notches raise.
    """
    pattern = plain_pattern(seam, seal_width, wanted)
    if wanted.tie_tab:
        pattern = with_tie_tab(pattern, wanted.tie_tab_angle)
    pattern = with_label(pattern, wanted.label, wanted.label_height)
    return with_notches(pattern, wanted.notches, wanted.notch_depth)


def plain_pattern(seam: Outline, seal_width: float, wanted: Wanted, fair: bool = True) -> Pattern:
    """The same without tie tab, label and notches; fair: as in build_pattern."""
    return build_pattern(
        seam,
        seal_width if wanted.seal_width is None else wanted.seal_width,
        allowance=wanted.allowance,
        intake=wanted.intake,
        intake_kind=wanted.intake_kind,
        intake_width=wanted.intake_width,
        intake_length=wanted.intake_length,
        intake_angle=wanted.intake_angle,
        intake_along=wanted.intake_along,
        intake_place=wanted.intake_place,
        corner_radius=wanted.corner_radius,
        fair=fair,
    )


def sheet_of(pattern: Pattern, wanted: Wanted) -> Pattern:
    """What is cut for it: the panel with its pieces, the second panel and copies as they are wanted."""
    return on_sheet(pattern, wanted.mirror, wanted.copies)


def pieces_remarks(wanted: Wanted, film: Film) -> tuple[str, ...]:
    """What is to be said of the film of the intake's pieces, a sentence each.

    Raises InputError where it does not weld to the balloon's.
    """
    kind = intake_kind(wanted.intake_kind)
    if not wanted.intake or kind.stock is None:
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
