# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet of many panels: the first page, a picture of each step, and all seams in a table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.blocks import MARGIN, draw_head
from BalloonWorkbench.core.assembly_sheet.first_page import FirstPage, draw_first_page
from BalloonWorkbench.core.assembly_sheet.page import page_size, written
from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, INK, RULE, Pen
from BalloonWorkbench.core.assembly_sheet.steps import steps, work_pictures
from BalloonWorkbench.core.assembly_sheet.work_figures import picture_stage
from BalloonWorkbench.core.assembly_sheet.work_pages import draw_work_page
from BalloonWorkbench.core.assembly_sheet.work_settings import NO_SETTINGS, WorkSettings
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.order import LAST, JoinStep
from BalloonWorkbench.core.bag_pattern.seams import SeamMark
from BalloonWorkbench.core.bags.seam_colours import seam_colour
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.packages import matplotlib_pdf
from BalloonWorkbench.core.pages.fonts import Fonts, drawable, fonts_for, readable
from BalloonWorkbench.core.pages.pdf import Page, pdf, picture
from BalloonWorkbench.core.pictures.bag_picture import bag_picture, upright
from BalloonWorkbench.core.types import Floats, Say, in_english
from BalloonWorkbench.core.units import length_text, number_text

#: Steps beside and above each other on a page, dots of their pictures per mm, steps with a picture at most.
_ACROSS, _UP, _DOTS, _MOST = 3, 4, 4.0, 60
#: Height of a row of the table, of a title with its line, and of the text below a picture [mm].
_ROW, _TITLE, _TEXT = 4.6, 18.0, 12.0
#: Dots of the picture of the whole balloon in figures.
_WHOLE = 200
#: Film in pictures of steps, whose seam is in colour.
_FILM = "#c3cad6"


@dataclass(frozen=True)
class BagSubject:
    """What the sheet is about: a name, what it is made of, its design, its panels, its numbers, and the
    user's settings of machines."""

    title: str
    film: Film
    design: BagDesign
    patterns: BagPatterns
    numbers: Numbers
    settings: WorkSettings = NO_SETTINGS

    def name(self, panel: int) -> str:
        """A panel's name in letters that fonts have."""
        return drawable(self.patterns.names[self.patterns.panels.index(panel)])


def bag_assembly_pdf(subject: BagSubject, paper: str = "A4", say: Say = in_english) -> bytes:
    """All pages; the same bytes for the same subject. Raises what `assembly_pdf` raises."""
    size = page_size(paper)
    matplotlib_pdf()
    say = readable(say, "Assembly sheet")
    name, film, patterns = drawable(subject.title), written(subject.film), subject.patterns
    across, up, over = np.ptp(upright(subject.design)[subject.design.film], axis=0).tolist()
    colour = film.look.colour
    count = len(patterns.patterns)
    first = FirstPage(
        name,
        film,
        patterns.sheet,
        subject.numbers,
        (across, up, over),
        say(f"Pattern, {count} panels"),
        partial(bag_picture, subject.design, colour=colour, seams={}),
        steps(patterns.sheet, film, subject.numbers, say, panels=patterns, settings=subject.settings),
    )
    names = "".join(map(subject.name, patterns.panels))
    fonts = fonts_for(say("Assembly sheet"), name + say(film.title) + names)
    drawn: list[Callable[[Pen], None]] = [partial(draw_first_page, subject=first, size=size)]
    for start in range(0, len(patterns.order), _ACROSS * _UP):
        drawn.append(partial(_steps_page, subject=subject, name=name, start=start, size=size))
    rows = max(1, int((size[1] - 2.0 * MARGIN - _TITLE - 2.0 * _ROW) / _ROW))
    pictures = work_pictures(patterns.sheet, film, subject.numbers, say, panels=patterns)
    if pictures:
        drawn.append(partial(_work_page, subject=subject, name=name, pictures=pictures, size=size))
    made = [seam for seam in patterns.seams if seam.made]
    for start in range(0, len(made), rows):
        seams = made[start : start + rows]
        drawn.append(partial(_table, subject=subject, name=name, seams=seams, size=size))
    pages: list[Page] = [(size, partial(_with_pen, say=say, fonts=fonts, draw=draw)) for draw in drawn]
    return pdf(f"{name}: {say('Assembly sheet')}", fonts, pages)


def _with_pen(axes: Any, say: Say, fonts: Fonts, draw: Callable[[Pen], None]) -> None:
    draw(Pen(axes, say, fonts))


def _work_page(
    pen: Pen, subject: BagSubject, name: str, pictures: Sequence[tuple[str, str]], size: tuple[float, float]
) -> None:
    """Leak test, filling and what comes after, with the whole balloon in each figure."""
    pixels = bag_picture(subject.design, _WHOLE, _WHOLE, _FILM, seams={})
    first = len(subject.patterns.order) + 1
    stage = partial(picture_stage, pixels=pixels)
    draw_work_page(pen, name, pictures, subject.patterns.sheet, stage, first, size)


def joined_before(order: Sequence[JoinStep], step: int) -> tuple[int, ...]:
    """The panels that hang together after a step, by its place in the order: those of its part."""
    together = set(order[step].panels)
    grown = True
    while grown:
        more = {panel for each in order[:step] if together & set(each.panels) for panel in each.panels}
        grown = not more <= together
        together |= more
    return tuple(sorted(together))


def step_text(subject: BagSubject, step: JoinStep) -> str:
    """A sentence on a step."""
    one, other = (subject.name(panel) for panel in step.panels)
    if step.opening:
        return f"Seam {step.seam}: {one} to {other}, last, with the opening."
    if step.kind == LAST:
        return f"Seam {step.seam}: {one} to {other}, last."
    if step.flat:
        return f"Seam {step.seam}: {one} to {other}, lying flat."
    return f"Seam {step.seam}: {one} to {other}, one edge turned round the other."


def _steps_page(pen: Pen, subject: BagSubject, name: str, start: int, size: tuple[float, float]) -> None:
    say, (width, height) = pen.say, size
    right, top = width - MARGIN, height - MARGIN
    order = subject.patterns.order
    draw_head(pen, name, say("Order of the seams"), right, top)
    cell = (right - MARGIN) / _ACROSS, (top - _TITLE - MARGIN) / _UP
    for place, step in enumerate(order[start : start + _ACROSS * _UP]):
        left = MARGIN + (place % _ACROSS) * cell[0]
        upper = top - _TITLE - (place // _ACROSS) * cell[1]
        box = (left, upper - cell[1] + _TEXT, left + cell[0] - 4.0, upper)
        if start + place < _MOST:
            picture(pen.axes, _step_image(subject, start + place, box), box)
        pen.axes.plot([left + 3.0], [upper - 3.0], marker="o", ms=12.0, color=ACCENT, mew=0.0)
        pen.text(
            left + 3.0, upper - 3.1, str(start + place + 1), 7.5, color="white", ha="center", va="center"
        )
        y = box[1] - 3.4
        for line in pen.lines(say(step_text(subject, step)), cell[0] - 5.0)[:3]:
            pen.text(left, y, line)
            y -= 3.5


def _step_image(subject: BagSubject, place: int, box: tuple[float, float, float, float]) -> Floats:
    """The panels joined so far, the seam of the step in its colour and turned to the eye."""
    left, bottom, right, top = box
    order = subject.patterns.order
    number = order[place].seam
    return bag_picture(
        subject.design,
        int(_DOTS * (right - left)),
        int(_DOTS * (top - bottom)),
        _FILM,
        seams={number: seam_colour(number)},
        panels=joined_before(order, place),
        facing=number,
        sealed=[each.seam for each in order[:place]],
    )


def _table(
    pen: Pen, subject: BagSubject, name: str, seams: Sequence[SeamMark], size: tuple[float, float]
) -> None:
    say, (width, height) = pen.say, size
    right, top = width - MARGIN, height - MARGIN
    draw_head(pen, name, say("Seams"), right, top)
    room = right - MARGIN
    columns = [MARGIN + share * room for share in (0.0, 0.09, 0.36, 0.63, 0.75, 0.87)]
    panel, long = say("Panel"), say("Length")
    titles = (say("Seam"), panel, panel, long, long, say("Turns"))
    y = top - _TITLE - 2.0
    for x, title in zip(columns, titles):
        pen.heading(x, y, title)
    for seam in seams:
        y -= _ROW
        one, other = (subject.name(panel) for panel in seam.panels)
        turn = "" if seam.flat else f"{number_text(float(np.degrees(seam.flatness)), 2)}°"
        pen.axes.plot([columns[0], columns[0] + 4.0], [y + 1.0] * 2, color=seam_colour(seam.number), lw=3.0)
        texts = (str(seam.number), one, other, length_text(seam.length_a), length_text(seam.length_b), turn)
        for x, text, wide in zip(columns, texts, np.diff([*columns, right])):
            shift = 6.0 if x == columns[0] else 0.0
            pen.text(x + shift, y, text, room=wide - 1.0 - shift, color=INK)
        pen.axes.plot([MARGIN, right], [y - 1.3] * 2, color=RULE, lw=0.4)
