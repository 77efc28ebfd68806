# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a finished job gives beyond its pattern: prints, a layout on film, an assembly sheet.

1. pictures carried to the patterns, front and back      artwork/
2. panels on a roll or sheets of film                    nesting/
3. one page for the bench                                assembly/
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.artwork.files import artwork_files
from BalloonWorkbench.core.artwork.marks import BLEED, bordered, marked
from BalloonWorkbench.core.artwork.picture import Pixels, covering, mirrored, of_drawing
from BalloonWorkbench.core.artwork.sheet import DPI, Print, Sheet, artwork_sheets
from BalloonWorkbench.core.assembly_sheet.page import SheetSubject, assembly_pdf
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.geometry.polyline import bounds, signed_area
from BalloonWorkbench.core.job import Balloon
from BalloonWorkbench.core.nesting.layout import Layout, Piece, Stock
from BalloonWorkbench.core.nesting.nest import nest
from BalloonWorkbench.core.pattern.layout import beside
from BalloonWorkbench.core.pattern.make import sheet_of
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.placement import split
from BalloonWorkbench.core.tracing.segment import AUTO
from BalloonWorkbench.core.types import Floats, Progress, Say, no_progress


@dataclass(frozen=True)
class Artwork:
    """What is printed.

    front  pixels (h, w, 4); traced: it is the picture that was drawn, and lies where its shapes are
    back   another picture for the back, as it is seen from there; None for the front's, seen through
    dpi    resolution; bleed past the cut [m]; drawn_as: how a traced picture was read
    """

    front: Pixels
    traced: bool = False
    back: Pixels | None = None
    dpi: float = DPI
    bleed: float = BLEED
    drawn_as: str = AUTO


def printed(
    designs: Sequence[Design], patterns: Sequence[Pattern], drawing: tuple[Floats, Floats], artwork: Artwork
) -> tuple[Sheet, Sheet]:
    """Front and back of balloons; drawing: lower left corner (2,) and size (2,) of all that was drawn [m].

    Raises what artwork_sheets and of_drawing raise.
    """
    low, size = drawing
    front = (
        of_drawing(artwork.front, low, size, artwork.drawn_as)
        if artwork.traced
        else covering(artwork.front, low, size)
    )
    behind = None if artwork.back is None else mirrored(covering(artwork.back, low, size))
    own = [bordered(pattern, artwork.bleed) for pattern in patterns]
    shifts = beside(own)
    moved = [pattern.moved(shift) for pattern, shift in zip(own, shifts, strict=True)]
    whole = replace(
        moved[0],
        contours=tuple(contour for pattern in moved for contour in pattern.contours),
        seam_length=sum(pattern.seam_length for pattern in moved),
    )
    prints = [
        Print(design.inflation, pattern, shift, front, behind)
        for design, pattern, shift in zip(designs, moved, shifts, strict=True)
    ]
    return artwork_sheets(prints, marked(whole), artwork.dpi)


def print_files(balloon: Balloon, artwork: Artwork) -> tuple[dict[str, bytes], tuple[str, ...], Sheet, Sheet]:
    """Contents of the files to print by name, remarks, and both sheets: their patterns are what is cut."""
    points = np.concatenate([part.outer for part in balloon.drawing.parts])
    low, high = bounds(points)
    front, back = printed(balloon.designs, balloon.patterns, (low, high - low), artwork)
    return (*artwork_files(front, back), front, back)


def pieces_of(panel: Pattern, one_balloon: Pattern, copies: int, grain: float | None) -> list[Piece]:
    """The pieces of balloons: panels and their mirror images, and what else is cut for each balloon.

    one_balloon  all that is cut for one, see `sheet_of` with mirror
    grain        direction of the film's grain in the panel [rad], None for a film without one
    """
    area = max(abs(signed_area(cut.points)) for cut in panel.of(Role.CUT))
    others = [
        piece
        for piece in split(one_balloon)
        if max(abs(signed_area(cut.points)) for cut in piece.of(Role.CUT)) < 0.5 * area
    ]
    upright = None if grain is None else 0.0
    return [Piece(panel, copies, copies, grain), *(Piece(piece, copies, 0, upright) for piece in others)]


def by_stock(pieces: Sequence[Piece]) -> dict[str, list[Piece]]:
    """Pieces by the film that they are cut from, the balloon's first: each film is a roll of its own."""
    parted: dict[str, list[Piece]] = {"": []}
    for piece in pieces:
        (stock,) = piece.pattern.stocks
        parted.setdefault(stock, []).append(piece)
    return parted


def nested(
    balloon: Balloon, stock: Stock, copies: int, progress: Progress = no_progress
) -> dict[str, tuple[tuple[Layout, ...], list[Piece], tuple[str, ...]]]:
    """For each film, the balloon's first: layouts of so many balloons, their pieces, and remarks.

    Raises what `nest` raises.
    """
    options = replace(balloon.settings.pattern, mirror=True, copies=1)
    pieces = [
        piece
        for pattern in balloon.patterns
        for piece in pieces_of(pattern, sheet_of(pattern, options), copies, balloon.settings.film.lies)
    ]
    laid = {}
    for name, parted in by_stock(pieces).items():
        layouts, remarks = nest(parted, stock, progress)
        laid[name] = layouts, parted, remarks
    return laid


def assembly_files(balloon: Balloon, title: str, paper: str, say: Say) -> Mapping[str, bytes]:
    """Contents of the assembly sheets by name, one for each shape whose numbers are known.

    Raises what assembly_pdf raises.
    """
    count = len(balloon.parts)
    files = {}
    for number, part in enumerate(balloon.parts, 1):
        if part.numbers is None:
            continue
        name = title if count == 1 else f"{title} {number}"
        subject = SheetSubject(name, balloon.settings.film, part.design.inflation, part.pattern, part.numbers)
        files["assembly.pdf" if number == 1 else f"assembly-{number}.pdf"] = assembly_pdf(subject, paper, say)
    return files
