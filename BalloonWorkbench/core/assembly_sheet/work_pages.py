# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page with a figure for each part of the work: sealing, leak test, filling, ribbon and weight."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from BalloonWorkbench.core.assembly_sheet.blocks import MARGIN, draw_head
from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, Pen
from BalloonWorkbench.core.assembly_sheet.valve_figure import draw_valve, has_valve
from BalloonWorkbench.core.assembly_sheet.work_figures import (
    HANGING,
    Box,
    FigureStage,
    draw_figure,
    stage_box,
)
from BalloonWorkbench.core.pattern.pattern import Pattern

#: Cells beside each other, least rows; height of a title, gap between cells, height of a line [mm].
_ACROSS, _ROWS, _TITLE, _GAP, _LINE = 2, 3, 20.0, 5.0, 3.7
#: Of a cell its figure has this share, less where the texts beside it are long.
_SHARES = (0.55, 0.48, 0.4, 0.33)

#: Sets a stage in a box of the page; whether its neck is turned down.
Staging = Callable[[Any, Box, bool], FigureStage]


def draw_work_page(
    pen: Pen,
    name: str,
    pictures: Sequence[tuple[str, str]],
    pattern: Pattern,
    staging: Staging,
    first: int,
    size: tuple[float, float],
) -> None:
    """Figures with what is said beside them, numbered from `first`; then the valve of a pattern with one."""
    width, height = size
    right, top = width - MARGIN, height - MARGIN
    draw_head(pen, name, pen.say("Pictures of the work"), right, top)
    rows = max(_ROWS, math.ceil((len(pictures) + has_valve(pattern)) / _ACROSS))
    cell = (right - MARGIN) / _ACROSS, (top - _TITLE - MARGIN) / rows
    most = int((cell[1] - _GAP - 6.0) / _LINE)
    texts = [text for _, text in pictures]
    wide = next(
        (each for each in _widths(cell[0]) if _longest(pen, texts, _room(cell[0], each)) <= most),
        _widths(cell[0])[-1],
    )
    corners = [
        (MARGIN + (place % _ACROSS) * cell[0], top - _TITLE - (place // _ACROSS) * cell[1])
        for place in range(len(pictures) + 1)
    ]
    if has_valve(pattern):
        left, upper = corners[-1]
        draw_valve(pen, pattern, (left, upper - cell[1] + _GAP, left + cell[0] - _GAP, upper))
    for place, ((figure, text), (left, upper)) in enumerate(zip(pictures, corners)):
        middle = left + wide
        box = (left + 4.0, upper - cell[1] + _GAP, middle, upper - 2.0)
        stage = staging(pen.axes, stage_box(figure, box), figure in HANGING)
        draw_figure(figure, stage, box)
        _numbered(pen, first + place, (left + 3.0, upper - 3.0))
        y = upper - 6.0
        for line in pen.lines(text, _room(cell[0], wide)):
            pen.text(middle + 3.0, y, line)
            y -= _LINE


def _widths(cell: float) -> list[float]:
    """How wide figures may be in a cell, the widest first [mm]."""
    return [share * (cell - _GAP) for share in _SHARES]


def _room(cell: float, figure: float) -> float:
    """What is left for the text [mm]."""
    return cell - _GAP - figure - 3.0


def _longest(pen: Pen, texts: Sequence[str], room: float) -> int:
    """Lines of the longest text."""
    return max((len(pen.lines(text, room)) for text in texts), default=0)


def _numbered(pen: Pen, number: int, at: tuple[float, float]) -> None:
    """A number in a disc."""
    pen.axes.plot([at[0]], [at[1]], marker="o", ms=12.0, color=ACCENT, mew=0.0)
    pen.text(at[0], at[1] - 0.1, str(number), 7.5, color="white", ha="center", va="center", bold=True)
