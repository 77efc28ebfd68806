# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as PDF in its real size: on one page of its own, or on several of paper, to be glued together."""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on, ring
from BalloonWorkbench.core.language.fonts import readable
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import BAR, Drawing
from BalloonWorkbench.core.machines.writers.pdf_text import write
from BalloonWorkbench.core.packages import reportlab_canvas
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import from_mm, number_text, size_text

PAPERS = {"A4": (210.0, 297.0), "A3": (297.0, 420.0), "LETTER": (215.9, 279.4)}  # mm
#: Their names as people write them.
TILES = ("A4", "A3", "Letter")
_POINT = 72.0 / 25.4  # points per mm
#: Margin that a home printer leaves white, and how much of the drawing two neighbouring pages share [mm].
_MARGIN = 12.0
_OVERLAP = 10.0
_MARK = 5.0
_LINE = 0.25
_CHORD = 0.005
_TITLE = "Pattern on several pages"
#: More pages than that are a mistake.
_MOST_PAGES = 400


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


def drawing_pdf(drawing: Drawing, machine: Machine, say: Say = in_english) -> bytes:
    """One page of the drawing's size with a margin; the same bytes for the same drawing.

    MissingPackageError without reportlab.
    """
    size = (drawing.width + 2.0 * _MARGIN, drawing.height + 2.0 * _MARGIN)
    stream, canvas = _new(size, say)
    _show(canvas, drawing, machine, (_MARGIN, _MARGIN))
    canvas.showPage()
    canvas.save()
    return stream.getvalue()


def tiled_pdf(drawing: Drawing, machine: Machine, paper: str, say: Say = in_english) -> bytes:
    """A map of the pages, then the pages of "A4", "A3" or "Letter" with overlap, crop marks and their place.

    say  gives the texts in the reader's language; English stays where no font has its letters
    ExportError for other paper and for far too many pages; MissingPackageError without reportlab.
    """
    tiles = divide(drawing, paper)
    say = readable(say, _TITLE)
    stream, canvas = _new(tiles.paper, say)
    _map(canvas, drawing, machine, tiles, say)
    canvas.showPage()
    for number, (column, row) in enumerate(tiles.pages, 1):
        canvas.setPageSize((tiles.paper[0] * _POINT, tiles.paper[1] * _POINT))
        _page(canvas, drawing, machine, tiles, (column, row))
        place = say(f"Page {number} of {len(tiles.pages)}: column {column + 1}, row {tiles.rows - row}")
        write(canvas, (_MARGIN + 10.0, 5.0), place, 9.0, tiles.usable[0] - 20.0)
        canvas.showPage()
    canvas.save()
    return stream.getvalue()


def divide(drawing: Drawing, paper: str) -> Tiles:
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
        pages = tuple(place for place in every if _has_lines(drawing, empty, *place))
        choices.append(Tiles(sheet, usable, columns, rows, pages))
    return min(choices, key=lambda tiles: len(tiles.pages))


def _has_lines(drawing: Drawing, tiles: Tiles, column: int, row: int) -> bool:
    low = np.array(tiles.corner(column, row))
    high = low + tiles.usable
    for path in drawing.paths:
        points = ring(path.curve.flattened(_CHORD), path.curve.closed)
        along = line_lengths(points)
        x, y = point_on(points, along, np.linspace(0.0, along[-1], int(along[-1]) + 2)).T  # 1 mm
        if ((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1])).any():
            return True
    return False


def _new(size: tuple[float, float], say: Say) -> tuple[io.BytesIO, Any]:
    stream = io.BytesIO()
    # invariant: no date and no identifier that changes
    canvas = reportlab_canvas()(stream, pagesize=(size[0] * _POINT, size[1] * _POINT), invariant=1)
    canvas.setTitle(say("Balloon pattern"))
    canvas.setAuthor("")
    canvas.setViewerPreference("PrintScaling", "None")  # printers must not fit the page
    return stream, canvas


def _show(canvas: Any, drawing: Drawing, machine: Machine, at: tuple[float, float]) -> None:
    """The lines with the drawing's origin at a place of the page [mm]."""
    canvas.saveState()
    canvas.translate(at[0] * _POINT, at[1] * _POINT)
    canvas.setLineWidth(_LINE * _POINT)
    canvas.setLineJoin(1)
    for path in drawing.paths:
        line = machine.layers[path.role]
        canvas.setStrokeColor(line.rgb)
        canvas.setDash([4.0 * _POINT, 2.0 * _POINT] if line.line == "DASHED" else [])
        course = canvas.beginPath()
        points = (path.curve.flattened(_CHORD) * _POINT).tolist()
        course.moveTo(*points[0])
        for point in points[1:]:
            course.lineTo(*point)
        if path.curve.closed:
            course.close()
        canvas.drawPath(course, stroke=1, fill=0)
    canvas.restoreState()


def _page(canvas: Any, drawing: Drawing, machine: Machine, tiles: Tiles, place: tuple[int, int]) -> None:
    """One page: its part of the drawing, and the marks along which it is cut."""
    left, bottom = tiles.corner(*place)
    canvas.saveState()
    window = canvas.beginPath()
    window.rect(*(value * _POINT for value in (_MARGIN, _MARGIN, *tiles.usable)))
    canvas.clipPath(window, stroke=0, fill=0)
    _show(canvas, drawing, machine, (_MARGIN - left, _MARGIN - bottom))
    canvas.restoreState()
    canvas.setStrokeColor("#000000")
    canvas.setLineWidth(0.1 * _POINT)
    # cut along the marks on two sides and lay the edge on the marks of the neighbour
    for x in (_MARGIN, _MARGIN + tiles.usable[0] - _OVERLAP):
        for y in (_MARGIN, _MARGIN + tiles.usable[1] - _OVERLAP):
            canvas.line((x - _MARK) * _POINT, y * _POINT, (x + _MARK) * _POINT, y * _POINT)
            canvas.line(x * _POINT, (y - _MARK) * _POINT, x * _POINT, (y + _MARK) * _POINT)


def _map(canvas: Any, drawing: Drawing, machine: Machine, tiles: Tiles, say: Say) -> None:
    """The first page: what goes where, how to join it, and a bar to measure."""
    width, height = tiles.paper
    write(canvas, (_MARGIN, height - 18.0), say(_TITLE), 14.0, tiles.usable[0], bold=True)
    for k, text in enumerate(
        (
            f"Pattern {size_text(from_mm(drawing.width), from_mm(drawing.height), digits=4)}"
            f" ({number_text(drawing.width / 25.4, 4)} x {number_text(drawing.height / 25.4, 4)} in),"
            f" pages: {len(tiles.pages)}.",
            'Print at 100 % ("actual size"). The bar below must be 100 mm long.',
            "Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.",
        )
    ):
        write(canvas, (_MARGIN, height - 25.0 - 5.0 * k), say(text), 9.0, tiles.usable[0])
    canvas.setLineWidth(_LINE * _POINT)
    left, y = _MARGIN, height - 48.0
    for a, b in (((left, y), (left + BAR, y)), *(((x, y - 2), (x, y + 2)) for x in (left, left + BAR))):
        canvas.line(a[0] * _POINT, a[1] * _POINT, b[0] * _POINT, b[1] * _POINT)
    scale = min((width - 2.0 * _MARGIN) / _reach(tiles, 0), (height - 70.0) / _reach(tiles, 1))
    canvas.saveState()
    canvas.translate(_MARGIN * _POINT, _MARGIN * _POINT)
    canvas.scale(scale, scale)
    _show(canvas, drawing, machine, (0.0, 0.0))
    canvas.restoreState()
    canvas.setDash([])
    for number, (column, row) in enumerate(tiles.pages, 1):
        x, y = (_MARGIN + scale * value for value in tiles.corner(column, row))
        w, h = (scale * value for value in tiles.usable)
        canvas.setStrokeColor("#808080")
        canvas.rect(x * _POINT, y * _POINT, w * _POINT, h * _POINT, stroke=1, fill=0)
        canvas.setFont("Helvetica", 12)
        canvas.drawCentredString((x + 0.5 * w) * _POINT, (y + 0.5 * h) * _POINT - 4.0, str(number))


def _reach(tiles: Tiles, axis: int) -> float:
    """Width or height of all pages together [mm]."""
    count = (tiles.columns, tiles.rows)[axis]
    return count * (tiles.usable[axis] - _OVERLAP) + _OVERLAP
