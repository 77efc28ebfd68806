# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first page of an assembly sheet: pattern to scale, balloon, sizes, material, numbers, steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.assembly_sheet.blocks import (
    GUTTER,
    INDENT,
    LINE,
    MARGIN,
    dimension,
    draw_foot,
    draw_head,
    draw_legend,
    draw_list,
    draw_steps,
    height_of,
    in_two_columns,
    rows_of,
)
from BalloonWorkbench.core.assembly_sheet.pen import BAND, RULE, SOFT, Pen
from BalloonWorkbench.core.assembly_sheet.texts import figures, material
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.pages.pdf import picture
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, size_text, to_mm, volume_text

#: Scales of the drawing: 1 to so many.
_SCALES = (*np.arange(1.0, 8.0, 0.5), *range(8, 12), 12, 15, 20, 25, 30, 40, 50, 75, 100)
#: Dots of the balloon's picture per mm.
_DOTS = 6.0


@dataclass(frozen=True)
class FirstPage:
    """What the page is about.

    size     of the balloon: width, height, thickness [m]
    heading  over the pattern
    image    RGBA (h, w, 4) of the balloon for a width and a height in dots
    work     the steps, a few sentences each
    """

    title: str
    film: Film
    pattern: Pattern
    numbers: Numbers
    size: tuple[float, float, float]
    heading: str
    image: Callable[[int, int], Floats]
    work: Sequence[str]


def draw_first_page(pen: Pen, subject: FirstPage, size: tuple[float, float]) -> None:
    """All of it on a page of that width and height [mm]."""
    say, (width, height) = pen.say, size
    right, top = width - MARGIN, height - MARGIN
    column = 0.5 * (right - MARGIN - GUTTER)
    second = MARGIN + column + GUTTER
    inside = say(f"inflated {size_text(*subject.size)}, {volume_text(subject.numbers.volume)}")
    draw_head(pen, subject.title, inside, right, top)
    work = in_two_columns(pen, subject.work, column - INDENT)
    foot = MARGIN + 6.0
    steps_top = foot + 10.0 + max(map(height_of, work))
    pen.axes.plot([MARGIN, right], [steps_top + 4.5, steps_top + 4.5], color=RULE, lw=0.8)
    pen.heading(MARGIN, steps_top - 1.6, say("Steps"))
    for items, x in zip(work, (MARGIN, second)):
        draw_steps(pen, items, x, steps_top)
    rows = (
        rows_of(pen, material(subject.film, subject.pattern, subject.numbers, say), column),
        rows_of(pen, figures(subject.film, subject.numbers, say), column),
    )
    lists_top = steps_top + 12.0 + LINE * max(sum(len(lines) for _, lines in each) for each in rows)
    for title, each, x in zip((say("Material"), say("Numbers")), rows, (MARGIN, second)):
        draw_list(pen, title, each, x, lists_top)
    split = MARGIN + 0.6 * (right - MARGIN)
    scale = _pattern(pen, subject, (MARGIN, lists_top + 6.0, split - 4.0, top - 17.0))
    _balloon(pen, subject, (split + 4.0, lists_top + 6.0, right, top - 17.0))
    draw_foot(pen, scale, foot, right)


def _pattern(pen: Pen, subject: FirstPage, box: tuple[float, float, float, float]) -> float:
    """The panel with its dimensions; returns the scale it is drawn in."""
    pattern = subject.pattern
    axes, (left, bottom, right, top) = pen.axes, box
    pen.heading(left, top - 3.4, subject.heading, right - left)
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
        thin = {Role.ENGRAVE: 0.25, Role.PEN: 0.4}.get(contour.role, 0.9)
        axes.plot(*points.T, color=LAYERS[contour.role].rgb, lw=thin, solid_joinstyle="round", **style)
    (x0, y0), (x1, y1) = place(low), place(high)
    width, height = high - low
    dimension(axes, (x0, y0 - 5.0), (x1, y0 - 5.0), length_text(from_mm(float(width))))
    dimension(axes, (x0 - 5.0, y0), (x0 - 5.0, y1), length_text(from_mm(float(height))), 90.0)
    for x in (x0, x1):
        axes.plot([x, x], [y0 - 6.5, y0 - 1.0], color=SOFT, lw=0.4)
    for y in (y0, y1):
        axes.plot([x0 - 6.5, x0 - 1.0], [y, y], color=SOFT, lw=0.4)
    draw_legend(pen, pattern.roles, subject.film.seam, (left + 10.0, bottom + 3.0), right)
    return float(scale)


def _balloon(pen: Pen, subject: FirstPage, box: tuple[float, float, float, float]) -> None:
    left, bottom, right, top = box
    pen.heading(left, top - 3.4, pen.say("Inflated"))
    wide, tall = right - left, top - 7.0 - bottom
    image = subject.image(int(_DOTS * wide), int(_DOTS * tall))
    picture(pen.axes, image, (left, bottom, right, top - 7.0))
