# SPDX-License-Identifier: LGPL-2.1-or-later
"""The intake of a balloon of many panels: half a neck on each panel of the opening's seam, at one place; or a
nozzle on one panel.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.bag_pattern.seams import side_lines
from BalloonWorkbench.core.bags.bag import Bag, BagSeam, Opening, Side
from BalloonWorkbench.core.bags.opening import bag_with_opening
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.intake.kinds import FILM
from BalloonWorkbench.core.pattern.intake.neck import Neck, fitting_in_middle, place_neck
from BalloonWorkbench.core.pattern.intake.places import Wish, film_of, intake_of
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

#: Film beside a neck that other marks keep free [m].
_BESIDE = from_mm(5.0)


@dataclass(frozen=True)
class BagIntake:
    """Where a bag is filled.

    seam   number of the opening's seam, from 1; 0 in the middle of a panel
    share  place of the neck's middle on it, of its length
    free   what the neck takes of the seam on both sides of that, with its welds [m]
    necks  numbers of panels with the neck on each, the opening's first
    """

    seam: int
    share: float
    free: float
    necks: tuple[tuple[int, Neck], ...]


def opened_bag(bag: Bag, options: PatternOptions) -> Bag:
    """The bag with its opening where the options have it; raises InputError where that cannot be."""
    if not options.intake or not options.opening or _panel_of(bag, options) is not None:
        return bag
    return bag_with_opening(bag, options.opening)


def _panel_of(bag: Bag, options: PatternOptions) -> int | None:
    """The panel that is told alone as the opening, in whose middle a nozzle sits."""
    own = options.opening
    return next((number for number, panel in enumerate(bag.panels) if own and panel.name == own), None)


def bag_intake(bag: Bag, options: PatternOptions, seal_width: float) -> BagIntake | None:
    """The intake of an opened bag; None where none is wanted, or an end that stays open is its mouth.

    Raises InputError where the bag has no opening, or no room for the intake there.
    """
    if not options.intake:
        return None
    wish, alone = intake_of(options), _panel_of(bag, options)
    if alone is not None:
        return _in_the_middle(bag, alone, wish, options.allowance, seal_width)
    opening = bag.opening
    if opening is None:
        if all(panel.cut for panel in bag.panels):
            raise InputError(
                "The balloon has no opening: say at which edge it is filled, or choose no intake."
            )
        return None
    number = opening_seam(bag, opening)
    seam = bag.seams[number - 1]
    if not all(bag.panels[side.panel].cut for side in seam.sides):
        if options.opening:
            raise InputError(f"Seam {number} is at an end that stays open: say another one for the opening.")
        return None
    sides = [(side, line) for side, line in zip(seam.sides, side_lines(bag, seam))]
    sides.sort(key=lambda each: each[0].panel != opening.panel)
    if wish.kind.place == FILM:
        sides = sides[:1]
    way = float(line_lengths(sides[0][1])[-1])
    free = 0.5 * wish.width + 2.0 * seal_width
    _check(bag, [side for side, _ in sides], number, way, free)
    share = float(np.clip(_along(bag, seam, opening, options, way), free, way - free)) / way
    panels = [(side.panel, line) for side, line in sides]
    necks = [_neck(bag, panel, line, share, wish, options.allowance, seal_width) for panel, line in panels]
    longest = max(neck.intake.length for neck in necks)
    if any(neck.intake.length < longest for neck in necks):
        wish = replace(wish, length=longest)
        necks = [
            _neck(bag, panel, line, share, wish, options.allowance, seal_width) for panel, line in panels
        ]
    numbers = [panel for panel, _ in panels]
    return BagIntake(number, share, free + _BESIDE, tuple(zip(numbers, necks, strict=True)))


def _along(bag: Bag, seam: BagSeam, opening: Opening, options: PatternOptions, way: float) -> float:
    """Where on a seam of a length `way` [m] the intake is wanted, from its start [m]."""
    if options.opening_share is not None:
        if not 0.0 <= options.opening_share <= 1.0:
            raise InputError("How far along its seam the opening is must be from 0 to 1.")
        return options.opening_share * way
    if options.intake_along is not None:
        return options.intake_along
    if options.opening.strip().isdecimal():
        return 0.5 * way
    return _opened_at(bag, seam, opening) * way


def _in_the_middle(bag: Bag, number: int, wish: Wish, allowance: float, seal_width: float) -> BagIntake:
    """A nozzle in the middle of a panel. Raises InputError for other kinds, and where there is no room."""
    panel = bag.panels[number]
    if wish.kind.place != FILM:
        raise InputError(
            f"Panel {panel.name}: an intake of this kind leads through a seam. Say which one, or an edge of"
            f" the panel such as {panel.name}.0, or choose a nozzle."
        )
    if not panel.cut:
        raise InputError(f"Panel {panel.name} is not cut: say another one for the opening.")
    film = film_of(Outline(panel.outer, panel.holes))
    try:
        neck = fitting_in_middle(film, Rim(panel.outer), wish, seal_width, allowance)
    except InputError as error:
        raise InputError(f"Panel {panel.name}: {error}") from error
    return BagIntake(0, 0.5, 0.0, ((number, neck),))


def opening_seam(bag: Bag, opening: Opening) -> int:
    """Number of the seam with the opening's edge, from 1. InputError where there is none."""
    panel, at = opening.panel, opening.at
    for number, seam in enumerate(bag.seams, 1):
        for side, against in ((seam.a, False), (seam.b, True)):
            points = side.points(bag.panels, against=against).tolist()
            if side.panel == panel and side.loop == 0 and at in (points[1:] if against else points[:-1]):
                return number
    raise InputError(
        f"Panel {bag.panels[panel].name} has no edge {at} for the opening: say another one of its outer loop."
    )


def _check(bag: Bag, sides: list[Side], number: int, way: float, free: float) -> None:
    for side in sides:
        if side.loop:
            raise InputError(
                f"The intake cannot lead into a hole of panel {bag.panels[side.panel].name}: say another edge"
                " for the opening."
            )
    if way < 2.0 * free:
        names = " and ".join(bag.panels[side.panel].name for side in sides)
        raise InputError(
            f"Seam {number} of panels {names} is {length_text(way)} long, and the intake takes"
            f" {length_text(2.0 * free)} with its welds: make it narrower, or say another edge for the"
            " opening."
        )


def _opened_at(bag: Bag, seam: BagSeam, opening: Opening) -> float:
    """Middle of the opening's edge, as a share of the seam's length."""
    for side, against, line in zip(seam.sides, (False, True), side_lines(bag, seam)):
        points = side.points(bag.panels, against=against).tolist()
        starts = points[1:] if against else points[:-1]
        if side.panel == opening.panel and side.loop == 0 and opening.at in starts:
            lengths = line_lengths(line)
            edge = starts.index(opening.at)
            return 0.5 * float(lengths[edge] + lengths[edge + 1]) / float(lengths[-1])
    return 0.5


def _neck(
    bag: Bag, number: int, line: Floats, share: float, wish: Wish, allowance: float, seal_width: float
) -> Neck:
    """The intake on one panel, at a share of its side (k, 2) of the seam."""
    panel = bag.panels[number]
    lengths = line_lengths(line)
    rim = Rim(panel.outer)
    along = rim.nearest(point_on(line, lengths, np.array([share * lengths[-1]]))[0])
    film = film_of(Outline(panel.outer, panel.holes))
    try:
        return place_neck(film, film, rim, replace(wish, angle=None, along=along), seal_width, allowance)
    except InputError as error:
        raise InputError(f"Panel {panel.name}: {error}") from error
