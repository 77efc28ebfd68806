# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet as a PDF of one page: pattern to scale, balloon, sizes, material, numbers, steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, BAND, INK, RULE, SOFT, Pen
from BalloonWorkbench.core.assembly_sheet.steps import steps
from BalloonWorkbench.core.assembly_sheet.texts import figures, material
from BalloonWorkbench.core.assembly_sheet.valve_figure import draw_valve, has_valve
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.packages import matplotlib_pdf
from BalloonWorkbench.core.pages.fonts import drawable, fonts_for, readable
from BalloonWorkbench.core.pages.pdf import pdf, picture
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pictures.render import balloon_picture
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Say, in_english
from BalloonWorkbench.core.units import from_mm, length_text, number_text, size_text, to_mm, volume_text

#: Pages by name, upright [mm].
PAGES = {"A4": (210.0, 297.0), "Letter": (215.9, 279.4)}
_MARGIN = 13.0
#: Scales of the drawing: 1 to so many.
_SCALES = (*np.arange(1.0, 8.0, 0.5), *range(8, 12), 12, 15, 20, 25, 30, 40, 50, 75, 100)
_BAR = 50.0
_NAMES = {
    Role.CUT: "cut",
    Role.CUT_INNER: "cut inside",
    Role.NOTCH: "notch",
    Role.FOLD: "fold",
    Role.PEN: "drawn mark",
}
#: Height of a line of the lists [mm], least width of their names, dots of the balloon's picture per mm.
_LINE, _NAME, _DOTS = 4.2, 20.0, 6.0
#: Between two columns, and where the text of a step begins [mm].
_GUTTER, _INDENT = 6.0, 7.0

#: A column of steps: numbers and lines.
_Column = list[tuple[int, list[str]]]


@dataclass(frozen=True)
class SheetSubject:
    """What the sheet is about: a name, what it is made of, how it inflates, its panel and its numbers."""

    title: str
    film: Film
    inflation: Inflation
    pattern: Pattern
    numbers: Numbers


def assembly_pdf(subject: SheetSubject, paper: str = "A4", say: Say = in_english) -> bytes:
    """The page; the same bytes for the same subject.

    say  gives the engine's texts in the reader's language; English stays where no font has its letters
    ExportError for other paper than "A4" and "Letter", MissingPackageError without matplotlib.
    """
    size = PAGES.get("A4" if paper.upper() == "A4" else paper.capitalize())
    if size is None:
        raise ExportError(f'There is no paper "{paper}" for the assembly sheet: choose A4 or Letter.')
    matplotlib_pdf()
    say = readable(say, "Assembly sheet")
    film = replace(subject.film, title=drawable(subject.film.title), name=drawable(subject.film.name))
    subject = replace(subject, title=drawable(subject.title), film=film)
    fonts = fonts_for(say("Assembly sheet"), subject.title + say(film.title))
    title = f"{subject.title}: {say('Assembly sheet')}"
    return pdf(title, fonts, [(size, lambda axes: _fill(Pen(axes, say, fonts), subject, size))])


def _fill(pen: Pen, subject: SheetSubject, size: tuple[float, float]) -> None:
    say, (width, height) = pen.say, size
    right, top = width - _MARGIN, height - _MARGIN
    column = 0.5 * (right - _MARGIN - _GUTTER)
    second = _MARGIN + column + _GUTTER
    _head(pen, subject, right, top)
    work = _wrapped(pen, steps(subject.pattern, subject.film, subject.numbers, say), column - _INDENT)
    foot = _MARGIN + 6.0
    steps_top = foot + 10.0 + max(map(_tall, work))
    pen.axes.plot([_MARGIN, right], [steps_top + 4.5, steps_top + 4.5], color=RULE, lw=0.8)
    pen.heading(_MARGIN, steps_top - 1.6, say("Steps"))
    for items, x in zip(work, (_MARGIN, second)):
        _steps(pen, items, x, steps_top)
    rows = (
        _rows(pen, material(subject.film, subject.pattern, subject.numbers, say), column),
        _rows(pen, figures(subject.film, subject.numbers, say), column),
    )
    lists_top = steps_top + 12.0 + _LINE * max(sum(len(lines) for _, lines in each) for each in rows)
    for title, each, x in zip((say("Material"), say("Numbers")), rows, (_MARGIN, second)):
        _list(pen, title, each, x, lists_top)
    split = _MARGIN + 0.6 * (right - _MARGIN)
    scale = _pattern(pen, subject, (_MARGIN, lists_top + 6.0, split - 4.0, top - 17.0))
    low = lists_top + 6.0
    if has_valve(subject.pattern):
        half = low + 0.5 * (top - 17.0 - low)
        draw_valve(pen, subject.pattern, (split + 4.0, low, right, half))
        low = half + 2.0
    _balloon(pen, subject, (split + 4.0, low, right, top - 17.0))
    _foot(pen, scale, foot, right)


def _head(pen: Pen, subject: SheetSubject, right: float, top: float) -> None:
    low, high = bounds(subject.inflation.positions)
    across, up, _ = map(float, high - low)
    size = size_text(across, up, 2.0 * float(high[2]))
    pen.text(_MARGIN, top - 6.5, subject.title, 20.0, right - _MARGIN, bold=True)
    subtitle = pen.say(f"inflated {size}, {volume_text(subject.numbers.volume)}")
    pen.text(
        _MARGIN, top - 12.0, f"{pen.say('Assembly sheet')}  ·  {subtitle}", 9.0, right - _MARGIN, color=SOFT
    )
    pen.axes.plot([_MARGIN, right], [top - 14.6, top - 14.6], color=ACCENT, lw=1.6, solid_capstyle="butt")


def _pattern(pen: Pen, subject: SheetSubject, box: tuple[float, float, float, float]) -> float:
    """The panel with its dimensions; returns the scale it is drawn in."""
    pattern = subject.pattern
    axes, (left, bottom, right, top) = pen.axes, box
    pen.heading(left, top - 3.4, pen.say("Pattern, cut two (one mirrored)"), right - left)
    inside = (left + 10.0, bottom + 17.0, right, top - 7.0)
    low, high = (to_mm(corner) for corner in pattern.bounds)
    room = np.array([inside[2] - inside[0], inside[3] - inside[1]])
    need = float(np.max((high - low) / room))
    scale = next((scale for scale in _SCALES if scale >= need), need)
    middle = np.array([0.5 * (inside[0] + inside[2]), 0.5 * (inside[1] + inside[3])])

    def place(points: Floats) -> Floats:
        return np.asarray((points - 0.5 * (low + high)) / scale + middle)

    for contour in sorted(pattern.contours, key=lambda each: each.role is not Role.CUT):
        points = place(to_mm(contour.line))
        if contour.role is Role.CUT:
            axes.fill(*points.T, color=BAND, lw=0.0)
        elif contour.role is Role.CUT_INNER:
            axes.fill(*points.T, color="#ffffff", lw=0.0)
        dashed = contour.role in (Role.SEAL, Role.WELD)
        style = {"ls": (0, (4.0, 2.0))} if dashed else {}
        thin = 0.25 if contour.role is Role.ENGRAVE else 0.9
        axes.plot(*points.T, color=LAYERS[contour.role].rgb, lw=thin, solid_joinstyle="round", **style)
    (x0, y0), (x1, y1) = place(low), place(high)
    width, height = high - low
    _dimension(axes, (x0, y0 - 5.0), (x1, y0 - 5.0), length_text(from_mm(float(width))))
    _dimension(axes, (x0 - 5.0, y0), (x0 - 5.0, y1), length_text(from_mm(float(height))), 90.0)
    for x in (x0, x1):
        axes.plot([x, x], [y0 - 6.5, y0 - 1.0], color=SOFT, lw=0.4)
    for y in (y0, y1):
        axes.plot([x0 - 6.5, x0 - 1.0], [y, y], color=SOFT, lw=0.4)
    _legend(pen, subject, (left + 10.0, bottom + 3.0), right)
    return float(scale)


def _legend(pen: Pen, subject: SheetSubject, start: tuple[float, float], right: float) -> None:
    """What the lines are; in a second row below what has no room in the first."""
    x, y = start
    seam = subject.film.seam
    names = {**_NAMES, Role.SEAL: seam, Role.WELD: f"{seam} inside"}
    for role in subject.pattern.roles:
        if role not in names:
            continue
        name = pen.say(names[role])
        wide = pen.width(name, 7.0)
        if x + 8.5 + wide > right:
            x, y = start[0], y - 4.0
        style = {"ls": (0, (3.0, 1.5))} if role in (Role.SEAL, Role.WELD) else {}
        pen.axes.plot([x, x + 7.0], [y, y], color=LAYERS[role].rgb, lw=1.2, **style)
        pen.text(x + 8.5, y, name, 7.0, color=SOFT, va="center")
        x += 13.5 + wide


def _dimension(
    axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, rotation: float = 0.0
) -> None:
    arrow = {"arrowstyle": "<|-|>,head_width=0.12,head_length=0.3", "color": SOFT, "lw": 0.6}
    axes.annotate("", xy=end, xytext=start, arrowprops={**arrow, "shrinkA": 0.0, "shrinkB": 0.0})
    middle = 0.5 * (np.array(start) + np.array(end))
    box = {"fc": "white", "ec": "none", "pad": 1.2}
    axes.text(*middle, text, fontsize=8.0, color=INK, ha="center", va="center", rotation=rotation, bbox=box)


def _balloon(pen: Pen, subject: SheetSubject, box: tuple[float, float, float, float]) -> None:
    left, bottom, right, top = box
    pen.heading(left, top - 3.4, pen.say("Inflated"))
    wide, tall = right - left, top - 7.0 - bottom
    pixels = int(_DOTS * wide), int(_DOTS * tall)
    image = balloon_picture(
        [subject.inflation], subject.pattern.seal_width, *pixels, subject.film.look.colour
    )
    picture(pen.axes, image, (left, bottom, right, top - 7.0))


def _rows(pen: Pen, rows: Sequence[tuple[str, str]], column: float) -> list[tuple[str, list[str]]]:
    """Names, and their values in lines."""
    room = column - _name_width(pen, [name for name, _ in rows])
    return [(name, pen.lines(value, room)) for name, value in rows]


def _name_width(pen: Pen, names: Sequence[str]) -> float:
    return max(_NAME, *map(pen.width, names)) + 3.0


def _list(pen: Pen, title: str, rows: Sequence[tuple[str, list[str]]], x: float, top: float) -> None:
    """Figures with their names, from an upper edge downward."""
    pen.heading(x, top - 3.4, title)
    beside, y = x + _name_width(pen, [name for name, _ in rows]), top - 9.0
    for name, lines in rows:
        pen.text(x, y, name, color=SOFT)
        for line in lines:
            pen.text(beside, y, line)
            y -= _LINE


def _wrapped(pen: Pen, work: Sequence[str], room: float) -> tuple[_Column, _Column]:
    """The steps in two columns of equal height."""
    numbered = [(number, pen.lines(text, room)) for number, text in enumerate(work, 1)]
    half = min(
        range(len(numbered) + 1), key=lambda at: (abs(_tall(numbered[:at]) - _tall(numbered[at:])), -at)
    )
    return numbered[:half], numbered[half:]


def _tall(column: _Column) -> float:
    return sum(2.2 + 3.7 * len(lines) for _, lines in column)


def _steps(pen: Pen, column: _Column, x: float, top: float) -> None:
    y = top - 6.0
    look: dict[str, Any] = {"color": "white", "ha": "center", "va": "center", "bold": True}
    for count, lines in column:
        pen.axes.plot([x + 2.2], [y - 1.6], marker="o", ms=11.0, color=ACCENT, mew=0.0)
        pen.text(x + 2.2, y - 1.7, str(count), 7.0, **look)
        for line in lines:
            pen.text(x + _INDENT, y - 2.6, line)
            y -= 3.7
        y -= 2.2


def _foot(pen: Pen, scale: float, y: float, right: float) -> None:
    """A bar to check the print, and the same length of the balloon."""
    axes, say = pen.axes, pen.say
    axes.plot([_MARGIN, right], [y + 2.5, y + 2.5], color=RULE, lw=0.8)
    base = y - 4.5
    for k in range(5):
        x = _MARGIN + k * _BAR / 5.0
        colour = INK if k % 2 == 0 else "white"
        axes.fill([x, x + 10.0, x + 10.0, x], [base, base, base + 1.6, base + 1.6], fc=colour, ec=INK, lw=0.5)
    pen.text(
        _MARGIN + _BAR + 3.0,
        base,
        say(f"{number_text(_BAR)} mm on paper = {length_text(from_mm(_BAR * scale))} of film"),
        7.5,
    )
    pen.text(right, base, say(f"Pattern drawn 1 : {number_text(scale)}"), 7.5, color=SOFT, ha="right")
