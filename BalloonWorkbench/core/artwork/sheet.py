# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet to print: pictures, bent so that they read right on the inflated balloons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.artwork.carry import GRID, VisibleFilm, back, front, seen_from
from BalloonWorkbench.core.artwork.picture import Picture, Pixels
from BalloonWorkbench.core.artwork.sample import sampled
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.crossings import crossed_at
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.core.machines.marks.place import marked_back
from BalloonWorkbench.core.machines.marks.style import CROSSES, Marks
from BalloonWorkbench.core.options.making import ArtworkOptions
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.placement import back_of
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import INCH, number_text

DPI = ArtworkOptions.dpi
_LEAST_DPI, _MOST_DPI = 20.0, 2400.0
#: More pixels than that are a mistake, or more than most programs open.
_MOST_PIXELS = 300_000_000
#: White paper round the outermost line of a pattern that has no page [m].
_BORDER = CROSSES.inset
_STRIP = 4_000_000  # pixels worked on in one go


@dataclass(frozen=True)
class Sheet:
    """One side, ready to print.

    pixels   (h, w, 4); transparent where nothing is printed
    dpi      pixels per inch
    pattern  the pattern with the print's border and marks; mirrored for the back
    origin   (2,) m, where the lower left corner of the picture is in the pattern
    """

    pixels: Pixels
    dpi: float
    pattern: Pattern
    origin: Floats

    @property
    def size(self) -> tuple[float, float]:
        """Width and height [m]."""
        height, width = self.pixels.shape[:2]
        return width * INCH / self.dpi, height * INCH / self.dpi


@dataclass(frozen=True)
class Print:
    """A balloon to be printed.

    pattern  its pattern with the print's border, where it is on the sheet
    shift    (2,) m, how far that is from where the panel of the inflation is
    picture  what is printed on the front
    behind   on the back, as seen through the front; None for the front's own picture
    """

    inflation: Inflation
    pattern: Pattern
    shift: Floats
    picture: Picture
    behind: Picture | None = None


def artwork_sheets(
    prints: Sequence[Print], pattern: Pattern, dpi: float = DPI, marks: Marks = CROSSES
) -> tuple[Sheet, Sheet]:
    """The front and the back of balloons whose patterns make one sheet.

    pattern  that sheet: all patterns of the prints, marked with these marks
    The back is mirrored: printed side up, it is cut from the mirrored pattern and laid on the front with its
    printed side down. A machine's marks stand there as on the front. InputError for a resolution that makes
    no sense, and for marks that do not fit on the back.
    """
    frame, other = _frame(pattern, dpi), marked_back(pattern, marks)
    faces = _side(frame, [(one, front(one.inflation), one.picture) for one in prints])
    if all(one.behind is None and one.inflation.lower is None for one in prints):
        behind = faces if marks.are_seen else faces.copy()
    else:
        behind = _side(frame, [(one, back(one.inflation), one.behind or one.picture) for one in prints])
    _draw_marks(faces, frame, pattern)
    if behind is not faces:
        _draw_marks(behind, frame, back_of(other))  # as they lie before the sheet is turned over
    low = frame.low
    right = low[0] + frame.width * frame.pixel
    return (
        Sheet(faces, dpi, pattern, low),
        Sheet(behind[:, ::-1], dpi, other, np.array([-right, low[1]])),
    )


def one_sheet(
    prints: Sequence[Print], films: Sequence[VisibleFilm], pattern: Pattern, dpi: float = DPI
) -> Sheet:
    """The sheet of panels that are seen from outside, each with its film where it is in its picture.

    pattern  as in `artwork_sheets`. InputError for a resolution that makes no sense.
    """
    frame = _frame(pattern, dpi)
    pixels = _side(frame, [(one, film, one.picture) for one, film in zip(prints, films, strict=True)])
    _draw_marks(pixels, frame, pattern)
    return Sheet(pixels, dpi, pattern, frame.low)


@dataclass(frozen=True)
class _SheetFrame:
    """Lower left corner (2,) m, size of a pixel [m], pixels across and up."""

    low: Floats
    pixel: float
    width: int
    height: int

    def columns(self, x: Floats) -> Floats:
        """Whole numbers at the middles of pixels."""
        return np.asarray((x - self.low[0]) / self.pixel - 0.5)

    def rows(self, y: Floats) -> Floats:
        """Counted from the upper edge."""
        return np.asarray(self.height - (y - self.low[1]) / self.pixel - 0.5)

    def x(self, columns: Ints) -> Floats:
        return np.asarray(self.low[0] + (columns + 0.5) * self.pixel)

    def y(self, rows: Ints) -> Floats:
        return np.asarray(self.low[1] + (self.height - rows - 0.5) * self.pixel)


def _frame(pattern: Pattern, dpi: float) -> _SheetFrame:
    """The pixels of a sheet. InputError for a resolution that makes no sense."""
    if not _LEAST_DPI <= dpi <= _MOST_DPI:
        raise InputError(
            f"{number_text(dpi)} dots per inch cannot be printed well: give {number_text(_LEAST_DPI)} to"
            f" {number_text(_MOST_DPI)}."
        )
    low, high = pattern.page or (pattern.bounds[0] - _BORDER, pattern.bounds[1] + _BORDER)
    # a page has a margin: what is left of it beyond the last whole pixel stays white
    whole = np.floor if pattern.page else np.ceil
    width, height = (int(whole(size * dpi / INCH)) for size in (high - low).tolist())
    if width * height > _MOST_PIXELS:
        raise InputError(
            f"At {number_text(dpi)} dots per inch the sheet would have {width} x {height} pixels: give a"
            " lower"
            " resolution."
        )
    return _SheetFrame(low, INCH / dpi, width, height)


def _side(frame: _SheetFrame, parts: Sequence[tuple[Print, VisibleFilm, Picture]]) -> Pixels:
    """The prints of a side, without marks."""
    sheet = np.zeros((frame.height, frame.width, 4), dtype=np.uint8)
    for one, film, picture in parts:
        _print(sheet, frame, one, film, picture)
    return sheet


def _print(sheet: Pixels, frame: _SheetFrame, one: Print, film: VisibleFilm, picture: Picture) -> None:
    """Print one balloon on the sheet, within its border."""
    borders = one.pattern.of(Role.PRINT)
    points = np.concatenate([border.points for border in borders])
    low, high = bounds(points)
    left, right = (int(np.rint(frame.columns(value))) for value in (low[0], high[0]))
    top, bottom = (int(np.rint(frame.rows(value))) for value in (high[1], low[1]))
    left, top = max(left, 0), max(top, 0)
    right, bottom = min(right + 1, frame.width), min(bottom + 1, frame.height)
    printed = _inside(frame, borders, left, right, top, bottom)
    # the grid, in the panel's own place
    x, y = (
        np.arange(a - 2.0 * GRID, b + 3.0 * GRID, GRID) for a, b in zip(low - one.shift, high - one.shift)
    )
    columns, rows = frame.columns(x + one.shift[0]) - left, frame.rows(y + one.shift[1]) - top
    needed = printed[
        np.clip(np.rint(rows), 0, len(printed) - 1).astype(int)[:, None],
        np.clip(np.rint(columns), 0, right - left - 1).astype(int),
    ]
    seen = seen_from(film, x, y, _wider(needed))
    at = np.stack(picture.columns_rows(seen), axis=-1)
    across = (frame.x(np.arange(left, right)) - one.shift[0] - x[0]) / GRID
    strip = max(1, _STRIP // (right - left))
    for start in range(0, bottom - top, strip):
        inside = printed[start : start + strip]
        down = (frame.y(top + start + np.arange(len(inside))) - one.shift[1] - y[0]) / GRID
        place = np.nan_to_num(_between(at, across, down))
        colours = sampled(picture.pixels, place[..., 0], place[..., 1])
        sheet[top + start : top + start + len(inside), left:right][inside] = colours[inside]


def _wider(mask: Bools) -> Bools:
    """The mask and two cells round it: a place between grid points needs all four."""
    for _ in range(2):
        padded = np.pad(mask, 1)
        mask = (
            padded[1:-1, 1:-1] | padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]
        )
    return mask


def _between(grid: NDArray[np.float32], across: Floats, down: Floats) -> NDArray[np.float32]:
    """Values (rows, columns, 2) between those of a grid: along its rows first, then along its columns."""

    def pair(at: Floats, count: int) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
        first = np.clip(np.floor(at).astype(np.intp), 0, count - 2)
        return first, (at - first).astype(np.float32)

    row, share = pair(down, grid.shape[0])
    lines = grid[row] + share[:, None, None] * (grid[row + 1] - grid[row])
    column, share = pair(across, grid.shape[1])
    return np.asarray(lines[:, column] + share[None, :, None] * (lines[:, column + 1] - lines[:, column]))


def _inside(
    frame: _SheetFrame, borders: Sequence[Contour], left: int, right: int, top: int, bottom: int
) -> Bools:
    """The pixels of a window whose middles lie inside closed lines: in an odd number of them."""
    inside = np.zeros((bottom - top, right - left), dtype=np.bool_)
    middles = np.arange(left, right)
    for row, y in enumerate(frame.y(np.arange(top, bottom))):
        at = np.sort(frame.columns(np.concatenate([crossed_at(border.points, y) for border in borders])))
        inside[row] = np.searchsorted(at, middles) % 2 == 1
    return inside


def _draw_marks(sheet: Pixels, frame: _SheetFrame, pattern: Pattern) -> None:
    for contour in pattern.of(Role.REGISTRATION):
        (_fill if contour.filled else _draw)(sheet, frame, contour)


def _fill(sheet: Pixels, frame: _SheetFrame, contour: Contour) -> None:
    """Black inside a closed line."""
    low, high = bounds(contour.points)
    left, right = (int(np.rint(frame.columns(value))) for value in (low[0], high[0]))
    top, bottom = (int(np.rint(frame.rows(value))) for value in (high[1], low[1]))
    left, top = max(left, 0), max(top, 0)
    right, bottom = min(right + 1, frame.width), min(bottom + 1, frame.height)
    sheet[top:bottom, left:right][_inside(frame, [contour], left, right, top, bottom)] = (0, 0, 0, 255)


def _draw(sheet: Pixels, frame: _SheetFrame, contour: Contour) -> None:
    """A black line as wide as those of crosses."""
    half = max(0.5 * CROSSES.line, 0.5 * frame.pixel)
    for start, end in pairwise(contour.line):
        low, high = np.minimum(start, end) - half, np.maximum(start, end) + half
        left, right = (int(np.ceil(float(value))) for value in frame.columns(np.array([low[0], high[0]])))
        top, bottom = (int(np.ceil(float(value))) for value in frame.rows(np.array([high[1], low[1]])))
        left, top = max(left, 0), max(top, 0)
        x = frame.x(np.arange(left, min(right, frame.width)))
        y = frame.y(np.arange(top, min(bottom, frame.height)))
        _, away = foot(x - start[0], y[:, None] - start[1], *(end - start))
        near = away <= half
        sheet[top : top + len(y), left : left + len(x)][near] = (0, 0, 0, 255)
