# SPDX-License-Identifier: LGPL-2.1-or-later
"""The blocks that pages of an assembly sheet are made of: head, lists, numbered steps, dimensions, foot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, INK, RULE, SOFT, Pen
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import from_mm, length_text, number_text

MARGIN = 13.0
BAR = 50.0
_LINES = {
    Role.CUT: "cut",
    Role.CUT_INNER: "cut inside",
    Role.NOTCH: "notch",
    Role.FOLD: "fold",
    Role.PEN: "drawn mark",
}
#: Height of a line of the lists [mm], least width of their names.
LINE, _NAME = 4.2, 20.0
#: Between two columns, and where the text of a step begins [mm].
GUTTER, INDENT = 6.0, 7.0

#: A column of steps: numbers and lines.
Column = list[tuple[int, list[str]]]


def draw_head(pen: Pen, title: str, subtitle: str, right: float, top: float) -> None:
    """The title over a line, with what is said below it."""
    pen.text(MARGIN, top - 6.5, title, 20.0, right - MARGIN, bold=True)
    pen.text(
        MARGIN, top - 12.0, f"{pen.say('Assembly sheet')}  ·  {subtitle}", 9.0, right - MARGIN, color=SOFT
    )
    pen.axes.plot([MARGIN, right], [top - 14.6, top - 14.6], color=ACCENT, lw=1.6, solid_capstyle="butt")


def line_names(seam: str) -> dict[Role, str]:
    """What the lines of a pattern are called, by their role; seam: what the film's seam is called."""
    return {**_LINES, Role.SEAL: seam, Role.WELD: f"{seam} inside"}


def draw_legend(pen: Pen, roles: Sequence[Role], seam: str, start: tuple[float, float], right: float) -> None:
    """What the lines are; in a second row below what has no room in the first."""
    x, y = start
    names = line_names(seam)
    for role in roles:
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


def dimension(
    axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, rotation: float = 0.0
) -> None:
    """An arrow with two heads and its length."""
    arrow = {"arrowstyle": "<|-|>,head_width=0.12,head_length=0.3", "color": SOFT, "lw": 0.6}
    axes.annotate("", xy=end, xytext=start, arrowprops={**arrow, "shrinkA": 0.0, "shrinkB": 0.0})
    middle = 0.5 * (np.array(start) + np.array(end))
    box = {"fc": "white", "ec": "none", "pad": 1.2}
    axes.text(*middle, text, fontsize=8.0, color=INK, ha="center", va="center", rotation=rotation, bbox=box)


def rows_of(pen: Pen, rows: Sequence[tuple[str, str]], column: float) -> list[tuple[str, list[str]]]:
    """Names, and their values in lines."""
    room = column - _name_width(pen, [name for name, _ in rows])
    return [(name, pen.lines(value, room)) for name, value in rows]


def _name_width(pen: Pen, names: Sequence[str]) -> float:
    return max(_NAME, *map(pen.width, names)) + 3.0


def draw_list(pen: Pen, title: str, rows: Sequence[tuple[str, list[str]]], x: float, top: float) -> None:
    """Figures with their names, from an upper edge downward."""
    pen.heading(x, top - 3.4, title)
    beside, y = x + _name_width(pen, [name for name, _ in rows]), top - 9.0
    for name, lines in rows:
        pen.text(x, y, name, color=SOFT)
        for line in lines:
            pen.text(beside, y, line)
            y -= LINE


def in_two_columns(pen: Pen, work: Sequence[str], room: float) -> tuple[Column, Column]:
    """The steps in two columns of equal height."""
    numbered = [(number, pen.lines(text, room)) for number, text in enumerate(work, 1)]
    count = len(numbered)
    uneven = [abs(height_of(numbered[:at]) - height_of(numbered[at:])) for at in range(count + 1)]
    half = min(range(count + 1), key=lambda at: (uneven[at], -at))
    return numbered[:half], numbered[half:]


def height_of(column: Column) -> float:
    """Height of a column [mm]."""
    return sum(2.2 + 3.7 * len(lines) for _, lines in column)


def draw_steps(pen: Pen, column: Column, x: float, top: float) -> None:
    """Steps with their numbers, from an upper edge downward."""
    y = top - 6.0
    look: dict[str, Any] = {"color": "white", "ha": "center", "va": "center", "bold": True}
    for count, lines in column:
        pen.axes.plot([x + 2.2], [y - 1.6], marker="o", ms=11.0, color=ACCENT, mew=0.0)
        pen.text(x + 2.2, y - 1.7, str(count), 7.0, **look)
        for line in lines:
            pen.text(x + INDENT, y - 2.6, line)
            y -= 3.7
        y -= 2.2


def draw_foot(pen: Pen, scale: float, y: float, right: float) -> None:
    """A bar to check the print, and the same length of the balloon."""
    axes, say = pen.axes, pen.say
    axes.plot([MARGIN, right], [y + 2.5, y + 2.5], color=RULE, lw=0.8)
    base = y - 4.5
    for k in range(5):
        x = MARGIN + k * BAR / 5.0
        colour = INK if k % 2 == 0 else "white"
        axes.fill([x, x + 10.0, x + 10.0, x], [base, base, base + 1.6, base + 1.6], fc=colour, ec=INK, lw=0.5)
    pen.text(
        MARGIN + BAR + 3.0,
        base,
        say(f"{number_text(BAR)} mm on paper = {length_text(from_mm(BAR * scale))} of film"),
        7.5,
    )
    pen.text(right, base, say(f"Pattern drawn 1 : {number_text(scale)}"), 7.5, color=SOFT, ha="right")
