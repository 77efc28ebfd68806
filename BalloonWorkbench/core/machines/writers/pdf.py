# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as PDF in its real size: on one page of its own, or on several of paper, to be glued together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.geometry.polyline import bounds, line_lengths, point_on, ring
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import BAR, Toolpaths
from BalloonWorkbench.core.pages.fonts import Fonts, fonts_for, readable
from BalloonWorkbench.core.pages.pdf import POINT, draw_line, draw_spot, pdf, placed_picture, rgba, write
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.types import Floats, Say, in_english
from BalloonWorkbench.core.units import from_mm, number_text, size_text

PAPERS = {"A4": (210.0, 297.0), "A3": (297.0, 420.0), "LETTER": (215.9, 279.4)}  # mm
#: Their names as people write them.
TILES = ("A4", "A3", "Letter")
#: Margin that a home printer leaves white, and how much of the drawing two neighbouring pages share [mm].
_MARGIN = 12.0
_OVERLAP = 10.0
_MARK = 5.0
_LINE = 0.25
_CHORD = 0.005
_TITLE = "Pattern on several pages"
#: More pages than that are a mistake.
_MOST_PAGES = 400
_NO_SPOTS: Mapping[Role, str] = {}
_Line = tuple[Floats, bool, dict[str, Any]]


@dataclass(frozen=True)
class PrintedPicture:
    """A picture under the lines of a drawing.

    pixels   (h, w, 4), the first row is the upper one
    corners  (3, 2) mm, where its lower left, lower right and upper left ones are in the drawing
    """

    pixels: NDArray[np.uint8]
    corners: Floats


@dataclass(frozen=True)
class Tiles:
    """How a drawing is divided: paper and usable size [mm], columns, rows, and the pages that show anything.

    pages  (column, row) from the lower left, in the order of printing: row by row from the top
    """

    paper: tuple[float, float]
    usable: tuple[float, float]
    columns: int
    rows: int
    pages: tuple[tuple[int, int], ...]

    def corner(self, column: int, row: int) -> tuple[float, float]:
        """Lower left corner of what a page shows, in the drawing [mm]."""
        return column * (self.usable[0] - _OVERLAP), row * (self.usable[1] - _OVERLAP)


def drawing_pdf(drawing: Toolpaths, machine: Machine, say: Say = in_english) -> bytes:
    """One page of the drawing's size with a margin; the same bytes for the same drawing.

    MissingPackageError without matplotlib.
    """
    size = (drawing.width + 2.0 * _MARGIN, drawing.height + 2.0 * _MARGIN)
    title, at = say("Balloon pattern"), (_MARGIN, _MARGIN)
    return pdf(
        title, fonts_for(title, ""), [(size, lambda axes: show(axes, drawing, machine, at))], machine.spots
    )


def show(axes: Any, drawing: Toolpaths, machine: Machine, at: tuple[float, float] = (0.0, 0.0)) -> None:
    """A drawing in real size, its origin at a place of the page [mm]; in spot colours where its layers have
    any."""
    _show(axes, _lines(drawing, machine, {role: line.spot for role, line in machine.layers.items()}), at)


def tiled_pdf(
    drawing: Toolpaths,
    machine: Machine,
    paper: str,
    say: Say = in_english,
    pictures: Sequence[PrintedPicture] = (),
) -> bytes:
    """A map of the pages, then the pages of "A4", "A3" or "Letter" with overlap, crop marks and their place.

    pictures  under the lines
    say       gives the texts in the reader's language; English stays where no font has its letters
    ExportError for other paper and for far too many pages; MissingPackageError without matplotlib.
    """
    tiles = divide(drawing, paper, pictures)
    say = readable(say, _TITLE)
    fonts, lines = fonts_for(say(_TITLE), ""), _lines(drawing, machine)
    pictures = [PrintedPicture(rgba(each.pixels), each.corners) for each in pictures]

    def page(number: int, place: tuple[int, int], axes: Any) -> None:
        _page(axes, lines, pictures, tiles, place)
        column, row = place[0] + 1, tiles.rows - place[1]
        where = say(f"Page {number} of {len(tiles.pages)}: column {column}, row {row}")
        write(axes, fonts, (_MARGIN + 10.0, 5.0), where, 9.0, tiles.usable[0] - 20.0)

    pages = [partial(page, number, place) for number, place in enumerate(tiles.pages, 1)]
    first = partial(_map, fonts=fonts, drawing=drawing, lines=lines, pictures=pictures, tiles=tiles, say=say)
    return pdf(say("Balloon pattern"), fonts, [(tiles.paper, draw) for draw in (first, *pages)])


def divide(drawing: Toolpaths, paper: str, pictures: Sequence[PrintedPicture] = ()) -> Tiles:
    """Upright or across, whichever takes fewer pages."""
    size = PAPERS.get(paper.upper())
    if size is None:
        raise ExportError(f'There is no paper "{paper}": choose A4, A3 or Letter.')
    choices = []
    for sheet in (size, size[::-1]):
        usable = (sheet[0] - 2.0 * _MARGIN, sheet[1] - 2.0 * _MARGIN)
        columns, rows = (
            max(1, int(np.ceil((whole - _OVERLAP) / (part - _OVERLAP) - 1e-9)))
            for whole, part in zip((drawing.width, drawing.height), usable)
        )
        if columns * rows > _MOST_PAGES:
            raise ExportError(
                f"That would take {columns * rows} pages: choose larger paper or a smaller balloon."
            )
        empty = Tiles(sheet, usable, columns, rows, ())
        every = [(column, row) for row in reversed(range(rows)) for column in range(columns)]
        pages = tuple(
            place
            for place in every
            if _has_lines(drawing, empty, *place) or _has_picture(pictures, empty, *place)
        )
        choices.append(Tiles(sheet, usable, columns, rows, pages))
    return min(choices, key=lambda tiles: len(tiles.pages))


def _has_lines(drawing: Toolpaths, tiles: Tiles, column: int, row: int) -> bool:
    low = np.array(tiles.corner(column, row))
    high = low + tiles.usable
    for path in drawing.paths:
        points = ring(path.curve.flattened(_CHORD), path.curve.closed)
        along = line_lengths(points)
        x, y = point_on(points, along, np.linspace(0.0, along[-1], int(along[-1]) + 2)).T  # 1 mm
        if ((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1])).any():
            return True
    return False


def _has_picture(pictures: Sequence[PrintedPicture], tiles: Tiles, column: int, row: int) -> bool:
    """Some of the box around one lies on a page."""
    low = np.array(tiles.corner(column, row))
    high = low + tiles.usable
    for each in pictures:
        first, right, up = each.corners
        least, most = bounds(np.array([first, right, up, right + up - first]))
        if (least < high).all() and (most > low).all():
            return True
    return False


def _lines(drawing: Toolpaths, machine: Machine, spots: Mapping[Role, str] = _NO_SPOTS) -> list[_Line]:
    """Points [mm] of the drawing's lines, whether they are closed, and their looks."""
    lines = []
    for path in drawing.paths:
        line = machine.layers[path.role]
        dashes = (0.0, (4.0 / _LINE, 2.0 / _LINE)) if line.line == "DASHED" else "solid"
        look = {"spot": spot} if (spot := spots.get(path.role)) else {"ec": line.rgb, "ls": dashes}
        lines.append((path.curve.flattened(_CHORD), path.curve.closed, look))
    return lines


def _show(
    axes: Any, lines: list[_Line], at: tuple[float, float], scale: float = 1.0, window: Any = None
) -> None:
    """The lines with the drawing's origin at a place of the page [mm], cut off at a window."""
    for points, closed, look in lines:
        if "spot" in look:
            draw_spot(axes, points + at, closed, look["spot"])
            continue
        drawn = draw_line(axes, scale * points + at, closed, lw=scale * _LINE / POINT, **look)
        if window is not None:
            drawn.set(clip_path=window, clip_on=True)


def _page(
    axes: Any,
    lines: list[_Line],
    pictures: Sequence[PrintedPicture],
    tiles: Tiles,
    place: tuple[int, int],
) -> None:
    """One page: its part of the drawing, and the marks along which it is cut."""
    from matplotlib.patches import Rectangle

    left, bottom = tiles.corner(*place)
    window = Rectangle((_MARGIN, _MARGIN), *tiles.usable, transform=axes.transData)
    at = (_MARGIN - left, _MARGIN - bottom)
    for each in pictures:
        placed_picture(axes, each.pixels, each.corners + at, window)
    _show(axes, lines, at, window=window)
    # cut along the marks on two sides and lay the edge on the marks of the neighbour
    for x in (_MARGIN, _MARGIN + tiles.usable[0] - _OVERLAP):
        for y in (_MARGIN, _MARGIN + tiles.usable[1] - _OVERLAP):
            for end in ((_MARK, 0.0), (0.0, _MARK)):
                draw_line(axes, np.array([(x, y), (x, y)]) + np.outer([-1, 1], end), False, lw=0.1 / POINT)


def _map(
    axes: Any,
    fonts: Fonts,
    drawing: Toolpaths,
    lines: list[_Line],
    pictures: Sequence[PrintedPicture],
    tiles: Tiles,
    say: Say,
) -> None:
    """The first page: what goes where, how to join it, and a bar to measure."""
    width, height = tiles.paper
    write(axes, fonts, (_MARGIN, height - 18.0), say(_TITLE), 14.0, tiles.usable[0], bold=True)
    for k, text in enumerate(
        (
            f"Pattern {size_text(from_mm(drawing.width), from_mm(drawing.height), digits=4)}"
            f" ({number_text(drawing.width / 25.4, 4)} x {number_text(drawing.height / 25.4, 4)} in),"
            f" pages: {len(tiles.pages)}.",
            'Print at 100 % ("actual size"). The bar below must be 100 mm long.',
            "Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.",
        )
    ):
        write(axes, fonts, (_MARGIN, height - 25.0 - 5.0 * k), say(text), 9.0, tiles.usable[0])
    left, y = _MARGIN, height - 48.0
    for a, b in (((left, y), (left + BAR, y)), *(((x, y - 2), (x, y + 2)) for x in (left, left + BAR))):
        draw_line(axes, np.array([a, b]), False, lw=_LINE / POINT, capstyle="butt")
    scale = min((width - 2.0 * _MARGIN) / _reach(tiles, 0), (height - 70.0) / _reach(tiles, 1))
    for each in pictures:
        placed_picture(axes, each.pixels, scale * each.corners + _MARGIN)
    _show(axes, lines, (_MARGIN, _MARGIN), scale)
    for number, place in enumerate(tiles.pages, 1):
        corner = _MARGIN + scale * np.array(tiles.corner(*place))
        box = scale * np.array(tiles.usable)
        draw_line(axes, corner + box * [(0, 0), (1, 0), (1, 1), (0, 1)], True, ec="#808080", lw=_LINE / POINT)
        middle = corner + 0.5 * box
        write(axes, fonts, (middle[0], middle[1]), str(number), 12.0, ha="center", va="center")


def _reach(tiles: Tiles, axis: int) -> float:
    """Width or height of all pages together [mm]."""
    count = (tiles.columns, tiles.rows)[axis]
    return count * (tiles.usable[axis] - _OVERLAP) + _OVERLAP
