# SPDX-License-Identifier: LGPL-2.1-or-later
"""The patterns of a design of many panels, with everything on them, and which edges are sealed together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.caps import cap_pieces
from BalloonWorkbench.core.bag_pattern.copies import PanelCopies, panel_copies
from BalloonWorkbench.core.bag_pattern.intake import BagIntake, bag_intake, opened_bag, opening_seam
from BalloonWorkbench.core.bag_pattern.marks import MarkedSide
from BalloonWorkbench.core.bag_pattern.names import named
from BalloonWorkbench.core.bag_pattern.order import assembly_order
from BalloonWorkbench.core.bag_pattern.panel_pattern import panel_edges, seam_marks_on
from BalloonWorkbench.core.bag_pattern.seams import SeamMark, seam_marks, side_lines
from BalloonWorkbench.core.bag_pattern.tabs import tab_shares
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.pattern import FARTHEST, MOST_COPIES, PatternOptions
from BalloonWorkbench.core.pattern.layout import in_rows
from BalloonWorkbench.core.pattern.make import pieces_remarks
from BalloonWorkbench.core.pattern.marks import with_tie_tab
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern
from BalloonWorkbench.core.pattern.pieces import FlatPiece, PatternPieces, PieceEdge
from BalloonWorkbench.core.pattern.sheet import intake_pieces, of_other_film
from BalloonWorkbench.core.types import Floats


def make_bag_patterns(design: BagDesign, film: Film, options: PatternOptions) -> BagPatterns:
    """What is cut for a balloon of many panels. Raises InputError for what cannot be made."""
    return bag_patterns(design.bag, film, options)


@memoized(most=8)
def bag_patterns(bag: Bag, film: Film, options: PatternOptions) -> BagPatterns:
    """What is cut for a bag, as `make_bag_patterns`; notches 0 puts as many groups on a seam as it needs."""
    seal_width = film.seal_width if options.seal_width is None else options.seal_width
    _check(bag, options, seal_width)
    bag = opened_bag(bag, options)
    remarks = [*pieces_remarks(options, film)]
    intake = bag_intake(bag, options, seal_width)
    seams, tabs = _with_tabs(bag, seam_marks(bag), seal_width + options.allowance)
    copies = panel_copies(bag)
    cut = tuple(number for number, panel in enumerate(bag.panels) if panel.cut)
    patterns, names = [], []
    for place, number in enumerate(cut, 1):
        pattern = _panel_pattern(bag, number, seams, tabs, intake, options, seal_width)
        marks, left_out = _marks(bag, number, pattern, (seams, tabs, intake), options, film)
        remarks += _without_room(bag.panels[number].name, left_out)
        name = f"{bag.panels[number].name}{' mirrored' if _is_mirrored(copies, number) else ''}"
        names.append(name)
        marked = replace(pattern, contours=(*marks, *pattern.contours))
        patterns.append(named(marked, options.label, name, f"{place}/{len(cut)}", options.label_height))
    if options.tie_tab:
        patterns[0] = with_tie_tab(patterns[0], options.tie_tab_angle)
    caps = cap_pieces(bag, seal_width)
    pieces = [*caps, *(_piece(lines, seal_width) for pattern in patterns for lines in intake_pieces(pattern))]
    shifts = in_rows([pattern.bounds for pattern in (*patterns, *pieces)])
    laid = [each.moved(shift) for each, shift in zip((*patterns, *pieces), shifts, strict=True)]
    others = any(contour.stock for piece in pieces for contour in piece.contours)
    warnings = [warning for pattern in patterns for warning in pattern.warnings]
    warnings += [line for pattern in patterns if others for line in of_other_film(pattern)]
    opening = _filled_at(bag, intake)
    return BagPatterns(
        cut,
        tuple(names),
        tuple(laid[: len(cut)]),
        tuple(shifts[: len(cut)]),
        tuple(laid[len(cut) :]),
        len(caps),
        copies,
        seams,
        assembly_order(seams, opening),
        options.copies,
        tuple(dict.fromkeys((*warnings, *remarks, *_unused(options), *_turning(seams)))),
    )


@memoized(most=8)
def bag_pieces(bag: Bag, film: Film, options: PatternOptions) -> PatternPieces:
    """The pieces of one balloon and both edges of each seam; an edge beside a panel that is not cut has no
    partner. Raises what `bag_patterns` raises."""
    made = bag_patterns(bag, film, options)
    pieces = [FlatPiece(*each) for each in zip(made.piece_names, (*made.patterns, *made.pieces), strict=True)]
    edges = []
    for mark, seam in zip(made.seams, bag.seams, strict=True):
        for panel, line in zip(mark.panels, side_lines(bag, seam)):
            if panel in made.panels:
                place = made.panels.index(panel)
                edges.append(PieceEdge(place, line + made.shifts[place], mark.number))
    return PatternPieces(tuple(pieces), tuple(edges))


def _check(bag: Bag, options: PatternOptions, seal_width: float) -> None:
    if not (1e-5 <= seal_width <= 1.0 and 0.0 <= options.allowance <= 1.0):
        raise InputError("The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.")
    if not 1 <= options.copies <= MOST_COPIES:
        raise InputError(f"There can be 1 to {MOST_COPIES} copies, not {options.copies}.")
    if not any(panel.cut for panel in bag.panels):
        raise InputError("No panel of the balloon is cut: make at least one of film.")


def _with_tabs(
    bag: Bag, seams: Sequence[SeamMark], width: float
) -> tuple[tuple[SeamMark, ...], list[tuple[Floats, Floats]]]:
    """The seams with how many tabs each has, and at which shares of both sides they are parted."""
    none = np.zeros(0)
    tabs = [
        (none, none) if seam.flat or not seam.made else tab_shares(*side_lines(bag, each), width)
        for seam, each in zip(seams, bag.seams, strict=True)
    ]
    counted = (replace(seam, tabs=len(one) + len(other)) for seam, (one, other) in zip(seams, tabs))
    return tuple(counted), tabs


def _panel_pattern(
    bag: Bag,
    number: int,
    seams: Sequence[SeamMark],
    tabs: list[tuple[Floats, Floats]],
    intake: BagIntake | None,
    options: PatternOptions,
    seal_width: float,
) -> Pattern:
    """Weld and cut of one panel."""
    necks = [neck for panel, neck in (intake.necks if intake else ()) if panel == number]
    left_open = [
        line
        for seam, each in zip(seams, bag.seams, strict=True)
        for panel, line in zip(seam.panels, side_lines(bag, each))
        if not seam.made and panel == number
    ]
    pattern = panel_edges(bag.panels[number], necks, left_open, options, seal_width)
    own = intake is not None and intake.necks[0][0] == number
    return pattern if own else replace(pattern, intake=None)


def _marks(
    bag: Bag,
    number: int,
    pattern: Pattern,
    joined: tuple[Sequence[SeamMark], list[tuple[Floats, Floats]], BagIntake | None],
    options: PatternOptions,
    film: Film,
) -> tuple[list[Contour], list[int]]:
    """What is marked on one panel, and the numbers of the seams for which it has no room."""
    seams, tabs, intake = joined
    sides = []
    for seam, shares, each in zip(seams, tabs, bag.seams, strict=True):
        if not seam.made:
            continue
        here = intake if intake is not None and intake.seam == seam.number else None
        for side, line, own, forward in zip(each.sides, side_lines(bag, each), shares, (1.0, -1.0)):
            if side.panel != number:
                continue
            ends = (side.loop, side.start), (side.loop, side.end)
            mouth, free = (here.share, here.free) if here is not None else (None, 0.0)
            sides.append(MarkedSide(seam.number, line, forward, ends, own, mouth, free))
    return seam_marks_on(bag.panels[number], pattern, sides, options, film.lies)


def _without_room(name: str, seams: Sequence[int]) -> list[str]:
    """What is to be said of numbers that are not on a panel."""
    if not seams:
        return []
    numbers = ", ".join(map(str, seams))
    return [
        f"Panel {name} has no room for numbers and arrows of seams: {numbers}. Its notches tell them apart."
    ]


def _piece(lines: list[Contour], seal_width: float) -> Pattern:
    return Pattern(tuple(lines), None, seal_width, 0.0)


def _is_mirrored(copies: Sequence[PanelCopies], number: int) -> bool:
    return any(dict(zip(group.panels, group.mirrored)).get(number, False) for group in copies)


def _filled_at(bag: Bag, intake: BagIntake | None) -> int | None:
    """Number of the seam through which it is filled; None for none, and for a nozzle inside a panel."""
    if bag.opening is None or (intake is not None and intake.seam == 0):
        return None
    return opening_seam(bag, bag.opening)


def _unused(options: PatternOptions) -> list[str]:
    """What is to be said of options that are of two equal panels alone."""
    lines = []
    if options.mirror:
        lines.append("All panels are on the sheet once: none is drawn a second time, mirrored.")
    if options.intake and (options.intake_angle is not None or options.intake_place != FARTHEST):
        lines.append(
            "The intake's direction is of two equal panels: of many, say a seam and how far along it."
        )
    return lines


def _turning(seams: Sequence[SeamMark]) -> list[str]:
    """What is to be said of seams that are not sealed lying flat."""
    numbers = ", ".join(str(seam.number) for seam in seams if seam.made and not seam.flat)
    if not numbers:
        return []
    if any(seam.tabs for seam in seams):
        return [f"Seams that do not lie flat: {numbers}. Their allowance is cut into tabs that turn."]
    return [f"Seams that do not lie flat: {numbers}. Seal them bit by bit."]
