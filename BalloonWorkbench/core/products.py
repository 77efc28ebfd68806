# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a finished job gives beyond its pattern: prints, a layout on film, an assembly sheet.

1. pictures carried to the patterns, front and back      artwork/
2. panels on a roll or sheets of film                    nesting/
3. one page for the bench                                assembly/
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.artwork.border import BLEED, bordered
from BalloonWorkbench.core.artwork.carry import VisibleFilm
from BalloonWorkbench.core.artwork.files import artwork_files, sheet_files
from BalloonWorkbench.core.artwork.picture import Picture, Pixels, covering, mirrored, of_drawing
from BalloonWorkbench.core.artwork.sheet import DPI, Print, Sheet, artwork_sheets, one_sheet
from BalloonWorkbench.core.artwork.wrap import faces_away, wrapped
from BalloonWorkbench.core.assembly_sheet.bag_pages import BagSubject, bag_assembly_pdf
from BalloonWorkbench.core.assembly_sheet.page import SheetSubject, assembly_pdf
from BalloonWorkbench.core.assembly_sheet.work_settings import WorkSettings, work_settings
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_job import BagPart, FinishedBags
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import bounds, signed_area
from BalloonWorkbench.core.job import Balloon, Part
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.machines.marks.style import CROSSES, Marks
from BalloonWorkbench.core.making.bag_numbers import bag_pieces
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.nesting.layout import Layout, Piece, Stock
from BalloonWorkbench.core.nesting.nest import nest
from BalloonWorkbench.core.nesting.remnant import Remnant
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.layout import beside, in_rows
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
    dpi    resolution; bleed past the cut [m]; drawn_as, tracing: how a traced picture was read
    marks  by which a machine finds the print again
    """

    front: Pixels
    traced: bool = False
    back: Pixels | None = None
    dpi: float = DPI
    bleed: float = BLEED
    drawn_as: str = AUTO
    marks: Marks = CROSSES
    tracing: TracingOptions = USUAL_TRACING


def printed(
    designs: Sequence[Design], patterns: Sequence[Pattern], drawing: tuple[Floats, Floats], artwork: Artwork
) -> tuple[Sheet, Sheet]:
    """Front and back of balloons; drawing: lower left corner (2,) and size (2,) of all that was drawn [m].

    Raises what artwork_sheets, of_drawing and marked raise.
    """
    front, behind = pictures_of(drawing, artwork)
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
    return artwork_sheets(prints, marked(whole, artwork.marks), artwork.dpi, artwork.marks)


def pictures_of(drawing: tuple[Floats, Floats], artwork: Artwork) -> tuple[Picture, Picture | None]:
    """What is printed on the front, and on the back as seen through it; None for the same.

    drawing, errors  as for `printed`
    """
    low, size = drawing
    front = (
        of_drawing(artwork.front, low, size, artwork.drawn_as, artwork.tracing)
        if artwork.traced
        else covering(artwork.front, low, size)
    )
    return front, None if artwork.back is None else mirrored(covering(artwork.back, low, size))


def box_of(balloon: Balloon) -> tuple[Floats, Floats]:
    """Lower left corner (2,) and size (2,) of all that was drawn [m]."""
    low, high = bounds(np.concatenate([part.outer for part in balloon.drawing.parts]))
    return low, high - low


def print_files(
    balloon: Balloon, artwork: Artwork, machines: Sequence[Machine] = ()
) -> tuple[dict[str, bytes], tuple[str, ...], Sheet, Sheet]:
    """Contents of the files to print by name, remarks, and both sheets: their patterns are what is cut.

    machines  as for `artwork_files`. Raises what `printed` raises.
    """
    front, back = printed(balloon.designs, balloon.patterns, box_of(balloon), artwork)
    return (*artwork_files(front, back, machines), front, back)


def bag_print(
    bags: FinishedBags, artwork: Artwork, machines: Sequence[Machine] = ()
) -> tuple[dict[str, bytes], tuple[str, ...], Sheet]:
    """Contents of the files to print by name, remarks, and the sheet, whose pattern is what is cut.

    The picture is wrapped round each balloon, see artwork/wrap.py; that of the back is on what faces away.
    machines  as for `artwork_files`. Raises what one_sheet and marked raise.
    """
    own, whole = panels_to_print(bags.parts, artwork.bleed, artwork.marks)
    laid = iter(own)
    prints, films = [], []
    for part in bags.parts:
        for film, picture in pictures_on(bags, artwork, part.design, part.patterns.panels):
            pattern, shift = next(laid)
            prints.append(Print(part.design.inflation, pattern, shift, picture))
            films.append(film)
    sheet = one_sheet(prints, films, whole, artwork.dpi)
    return (*sheet_files({"artwork": sheet}, machines), sheet)


def pictures_on(
    bags: FinishedBags, artwork: Artwork, design: BagDesign, panels: Sequence[int]
) -> list[tuple[VisibleFilm, Picture]]:
    """Of each of the panels of a balloon, by its number in the bag, where its film is in which picture."""
    seen, low, size = wrapped(design, panels)
    front, behind = _pictures(bags, artwork, low, size)
    away = faces_away(design, panels)
    return [(film, behind if back else front) for film, back in zip(seen, away, strict=True)]


def panels_to_print(
    parts: Sequence[BagPart], bleed: float, marks: Marks = CROSSES
) -> tuple[list[tuple[Pattern, Floats]], Pattern]:
    """The panels of balloons side by side with the border of their print, each with its shift (2,) m, and all
    of them as one pattern with marks. Raises what marked raises.
    """
    own = [bordered(pattern, bleed) for part in parts for pattern in _flat(part.patterns)]
    shifts = in_rows([pattern.bounds for pattern in own])
    laid = [(pattern.moved(shift), shift) for pattern, shift in zip(own, shifts, strict=True)]
    whole = replace(
        laid[0][0],
        contours=tuple(contour for pattern, _ in laid for contour in pattern.contours),
        intake=None,
        seam_length=sum(part.patterns.seam_length for part in parts),
    )
    return laid, marked(whole, marks)


def _pictures(bags: FinishedBags, artwork: Artwork, low: Floats, size: Floats) -> tuple[Picture, Picture]:
    """The picture of what faces the viewer and of what faces away; low, size (2,) m: box of the balloon.

    Those of a drawing lie where it has its shapes.
    """
    outlines = [source.outer for source in bags.sources if isinstance(source, Outline)]
    if outlines:
        low, high = bounds(np.concatenate(outlines))
        size = high - low
    traced = artwork.traced and bool(outlines)
    front = (
        of_drawing(artwork.front, low, size, artwork.drawn_as, artwork.tracing)
        if traced
        else covering(artwork.front, low, size)
    )
    return front, front if artwork.back is None else mirrored(covering(artwork.back, low, size))


def _flat(patterns: BagPatterns) -> list[Pattern]:
    """The patterns of panels in the panels' own frames."""
    return [pattern.moved(-shift) for pattern, shift in zip(patterns.patterns, patterns.shifts, strict=True)]


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
    balloon: Balloon | FinishedBags,
    stock: Stock,
    copies: int,
    progress: Progress = no_progress,
    remnants: Sequence[Remnant] = (),
    only_remnants: bool = False,
) -> dict[str, tuple[tuple[Layout, ...], list[Piece], tuple[str, ...]]]:
    """For each film, the balloon's first: layouts of so many balloons, their pieces, and remarks.

    Raises what `nest` raises, and InputError for a remnant of film that nothing is cut from.
    """
    laid, films = {}, by_stock(_all_pieces(balloon, copies))
    insist_on_films(remnants, films)
    for name, parted in films.items():
        own = [each for each in remnants if each.stock == name]
        layouts, remarks = nest(parted, stock, progress, own, only_remnants)
        laid[name] = layouts, parted, remarks
    return laid


def insist_on_films(remnants: Sequence[Remnant], films: Collection[str]) -> None:
    """Raises InputError for a remnant of film that nothing is cut from."""
    for each in remnants:
        if each.stock not in films:
            raise InputError(
                f"The remnant is of {each.stock or 'balloon'} film, and no piece here is cut from that."
            )


def _all_pieces(balloon: Balloon | FinishedBags, copies: int) -> list[Piece]:
    """All that is cut for so many of each balloon."""
    grain = balloon.settings.film.lies
    if isinstance(balloon, FinishedBags):
        return [piece for part in balloon.parts for piece in bag_pieces(part.patterns, copies, grain)]
    options = replace(balloon.settings.pattern, mirror=True, copies=1)
    return [
        piece
        for pattern in balloon.patterns
        for piece in pieces_of(pattern, sheet_of(pattern, options), copies, grain)
    ]


def assembly_files(
    balloon: Balloon | FinishedBags, title: str, paper: str, say: Say, machines: Sequence[Machine] = ()
) -> Mapping[str, bytes]:
    """Contents of the assembly sheets by name, one for each balloon whose numbers are known.

    machines  on which it is made: what their files say of their tools is told
    Raises what assembly_pdf raises.
    """
    parts: Sequence[Part | BagPart] = balloon.parts
    files = {}
    for number, part in enumerate(parts, 1):
        if part.numbers is not None:
            name = title if len(parts) == 1 else f"{title} {number}"
            file = "assembly.pdf" if number == 1 else f"assembly-{number}.pdf"
            about = name, balloon.settings.film, work_settings(machines, say)
            files[file] = _assembly(part, part.numbers, about, paper, say)
    return files


def _assembly(
    part: Part | BagPart, numbers: Numbers, about: tuple[str, Film, WorkSettings], paper: str, say: Say
) -> bytes:
    """The assembly sheet of one balloon; about: its name, film, and settings of machines."""
    name, film, settings = about
    if isinstance(part, BagPart):
        bag = BagSubject(name, film, part.design, part.patterns, numbers, settings)
        return bag_assembly_pdf(bag, paper, say)
    subject = SheetSubject(name, film, part.design.inflation, part.pattern, numbers, settings)
    return assembly_pdf(subject, paper, say)
