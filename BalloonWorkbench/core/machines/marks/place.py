# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registration marks round a sheet, by which a machine finds its print again.

They stand on a rectangle round the print: its corners are the middles of crosses, discs and squares, and the
middle of the lines at the bend of corners. A sheet is fed upward: squares are repeated along its sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import MarksError
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.machines.marks.style import (
    BY_EYE,
    CORNERS,
    CROSSES,
    DISCS,
    DOTS,
    NONE,
    SILHOUETTE,
    SQUARES,
    Marks,
)
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.placement import back_of
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, size_text

#: Radius of the circle of a cross, in parts of its size.
_CIRCLE = 0.25
#: From a square to the bar between squares [m]: Summa's own plug-in leaves as much.
_BAR_GAP = from_mm(10.0)
#: Where the fifth dot is, on the way from the lower right to the lower left one: unlike turned or mirrored.
_FIFTH = 0.25
_HAIR = 1e-9
#: Corners as signs of x and y.
_LOWER_LEFT, _LOWER_RIGHT, _UPPER_LEFT, _UPPER_RIGHT = (-1, -1), (1, -1), (-1, 1), (1, 1)
_ALL = (_LOWER_LEFT, _LOWER_RIGHT, _UPPER_LEFT, _UPPER_RIGHT)


@dataclass(frozen=True)
class _Frame:
    """The rectangle on which marks stand: lower left and upper right corner (2,) m."""

    low: Floats
    high: Floats

    def corner(self, signs: tuple[int, int]) -> Floats:
        return np.where(np.array(signs) > 0, self.high, self.low)

    def wider(self, by: float) -> _Frame:
        return _Frame(self.low - by, self.high + by)

    @property
    def size(self) -> Floats:
        return np.asarray(self.high - self.low)


def marked(sheet: Pattern, marks: Marks = CROSSES) -> Pattern:
    """The sheet with the marks (REGISTRATION) round it, in the place of any that it has, and its page.

    The page of three crosses is as large as what is on it. MarksError where they do not fit on the page.
    """
    own = replace(
        sheet,
        contours=tuple(contour for contour in sheet.contours if contour.role is not Role.REGISTRATION),
        page=None,
    )
    frame, page = _frame(own, marks)
    contours = tuple(_contours(frame, marks))
    _hold_clear(own, [*_areas(contours, marks.clear), *_kept_free(frame, marks)], marks)
    kept = marks.style == BY_EYE and marks.page is None
    return replace(own, contours=(*contours, *own.contours), page=None if kept else (page.low, page.high))


def marked_back(sheet: Pattern, marks: Marks = CROSSES) -> Pattern:
    """The back of a marked sheet: a machine's marks stand there as on the front, those for the eye mirrored.

    So film that is cut by eye is never taken for the other side. MarksError as for `marked`.
    """
    back = back_of(sheet)
    return back if marks.are_seen else marked(back, marks)


def _frame(sheet: Pattern, marks: Marks) -> tuple[_Frame, _Frame]:
    """Where the marks stand, and the page. MarksError where these are too small for the sheet."""
    print_ = _Frame(*sheet.bounds)
    beyond = marks.inset + _outside(marks)
    if marks.page is None:
        frame = print_.wider(marks.clear + _inside(marks))
        if marks.style == SILHOUETTE and _meets(sheet, _kept_free(frame, marks)):
            frame = print_.wider(marks.clear + marks.size)
        page = frame.wider(beyond)
    else:
        around = 2.0 * (beyond + marks.clear + _inside(marks))
        size, room = np.array(marks.page), np.array(marks.page) - around
        if (print_.size > room + _HAIR).any() and (print_.size <= room[::-1] + _HAIR).all():
            size, room = size[::-1], room[::-1]  # the paper lies across
        middle = 0.5 * (print_.low + print_.high)
        page = _Frame(middle - 0.5 * size, middle + 0.5 * size)
        frame = page.wider(-beyond)
        if (print_.size > room + _HAIR).any():
            raise MarksError(
                f"The print measures {size_text(*print_.size)}, and between the marks of {marks.owner[0]}"
                f" there are {size_text(*np.maximum(room, 0.0))} on paper of {size_text(*marks.page)}: make"
                " the balloon smaller, or give larger paper as page_mm of the marks in a file of your"
                " machine."
            )
    if marks.most is not None and (frame.size > np.array(marks.most) + _HAIR).any():
        measured, largest = size_text(*frame.size), size_text(*marks.most)
        raise MarksError(
            f"The print measures {measured}, and {marks.owner[0]} takes at most {largest}: make the balloon"
            " smaller, or print and cut it on another machine."
            if marks.style == NONE
            else f"The marks round the print span {measured}, and {marks.owner[0]} takes at most {largest}:"
            " make the balloon smaller, or print and cut it on another machine."
        )
    return frame, page


def _inside(marks: Marks) -> float:
    """How far marks reach from their frame toward the print [m]."""
    return 0.5 * (marks.line if marks.style in (CORNERS, SILHOUETTE) else marks.size)


def _outside(marks: Marks) -> float:
    """And away from it, as the page is measured: of corners that point inward from the middle of the line."""
    if marks.style in (CORNERS, SILHOUETTE):
        return marks.size if marks.outward else 0.0
    return 0.5 * marks.size


def _contours(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    drawn = {
        BY_EYE: _crosses, SILHOUETTE: _silhouette, CORNERS: _corners, DISCS: _discs, SQUARES: _squares,
        DOTS: _discs,
    }  # fmt: skip
    if marks.style in drawn:
        yield from drawn[marks.style](frame, marks)


def _crosses(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    """Neither a turned nor a mirrored sheet fits three."""
    for signs in (_LOWER_LEFT, _LOWER_RIGHT, _UPPER_LEFT):
        at = frame.corner(signs)
        for arm in ((0.5 * marks.size, 0.0), (0.0, 0.5 * marks.size)):
            yield Contour(Role.REGISTRATION, np.array([at - arm, at + arm]), False)
        circle = at + _CIRCLE * marks.size * direction(2.0 * np.pi * np.arange(48) / 48)
        yield Contour(Role.REGISTRATION, circle, True)


def _silhouette(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    at = frame.corner(_UPPER_LEFT)
    yield _box(at + marks.square * np.array([0.0, -1.0]), at + marks.square * np.array([1.0, 0.0]))
    for signs in (_UPPER_RIGHT, _LOWER_LEFT):
        yield _bend(frame.corner(signs), signs, marks, False)


def _corners(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    for signs in _ALL:
        yield _bend(frame.corner(signs), signs, marks, marks.outward)


def _discs(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    places = [frame.corner(signs) for signs in _ALL]
    if marks.style == DOTS:
        places.append(frame.corner(_LOWER_RIGHT) - np.array([_FIFTH * frame.size[0], 0.0]))
    for at in places:
        points = at + 0.5 * marks.size * direction(2.0 * np.pi * np.arange(96) / 96)
        yield Contour(Role.REGISTRATION, points, True, filled=True)


def _bend(at: Floats, signs: tuple[int, int], marks: Marks, outward: bool) -> Contour:
    """Two lines at right angles whose middles meet at a corner, each so long from there."""
    along, half = (1.0 if outward else -1.0), 0.5 * marks.line
    bent = np.array(
        [(-half, -half), (marks.size, -half), (marks.size, half), (half, half), (half, marks.size),
         (-half, marks.size)]
    )  # fmt: skip
    points = at + along * np.array(signs) * bent
    return Contour(Role.REGISTRATION, points if signs[0] == signs[1] else points[::-1], True, filled=True)


def _box(low: Floats, high: Floats) -> Contour:
    points = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    return Contour(Role.REGISTRATION, points, True, filled=True)


def _squares(frame: _Frame, marks: Marks) -> Iterator[Contour]:
    """Both columns from below, at even steps, and the bar between the lower ones."""
    half = 0.5 * marks.size
    steps = 1 if marks.step is None else max(1, int(np.ceil(frame.size[1] / marks.step - _HAIR)))
    for y in np.linspace(frame.low[1], frame.high[1], steps + 1):
        for x in (frame.low[0], frame.high[0]):
            yield _box(np.array([x - half, y - half]), np.array([x + half, y + half]))
    if marks.bar:
        left, right = frame.low[0] + half + _BAR_GAP, frame.high[0] - half - _BAR_GAP
        if right - left < marks.bar:
            raise MarksError(
                f"The bar of {marks.owner[0]} does not fit between marks that are"
                f" {length_text(float(frame.size[0]))} apart: make the balloon larger, or print several"
                " beside each other."
            )
        y = float(frame.low[1])
        yield _box(np.array([left, y - 0.5 * marks.bar]), np.array([right, y + 0.5 * marks.bar]))


def _kept_free(frame: _Frame, marks: Marks) -> list[Any]:
    """Areas of shapely where Silhouette's machines look for marks: a square as large as an arm at each."""
    if marks.style != SILHOUETTE:
        return []
    ends = [
        (frame.corner(signs), frame.corner(signs) - marks.size * np.array(signs))
        for signs in (_UPPER_LEFT, _UPPER_RIGHT, _LOWER_LEFT)
    ]
    return [shapely().box(*np.concatenate(bounds(np.array(pair)))) for pair in ends]


def _meets(sheet: Pattern, areas: list[Any]) -> bool:
    """Whether print or pattern reaches into areas."""
    package = shapely()
    lines = [package.LineString(contour.line) for contour in sheet.contours]
    lines += [package.Polygon(contour.points) for contour in sheet.of(Role.CUT)]
    return bool(package.intersects(package.union_all(areas), np.array(lines, dtype=object)).any())


def _areas(contours: Sequence[Contour], clear: float) -> list[Any]:
    """Areas of shapely of marks with what stays white round them."""
    package = shapely()
    own = [
        package.Polygon(each.points) if each.closed else package.LineString(each.points) for each in contours
    ]
    return [mark.buffer(clear - _HAIR, join_style="mitre") for mark in own]


def _hold_clear(sheet: Pattern, areas: list[Any], marks: Marks) -> None:
    """MarksError where a mark has print or pattern beside it."""
    if areas and _meets(sheet, areas):
        raise MarksError(
            f"The print reaches into the marks of {marks.owner[0]}, or comes nearer than"
            f" {length_text(marks.clear)}: make the balloon smaller, or give larger paper as page_mm of the"
            " marks in a file of your machine."
        )
