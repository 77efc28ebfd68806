# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet of two equal panels as a PDF: the first page, and the work in pictures."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.first_page import FirstPage, draw_first_page
from BalloonWorkbench.core.assembly_sheet.pen import Pen
from BalloonWorkbench.core.assembly_sheet.steps import steps, work_pictures
from BalloonWorkbench.core.assembly_sheet.work_figures import pattern_stage
from BalloonWorkbench.core.assembly_sheet.work_pages import draw_work_page
from BalloonWorkbench.core.assembly_sheet.work_settings import NO_SETTINGS, WorkSettings
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.packages import matplotlib_pdf
from BalloonWorkbench.core.pages.fonts import drawable, fonts_for, readable
from BalloonWorkbench.core.pages.pdf import pdf
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pictures.render import balloon_picture
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Say, in_english

#: Pages by name, upright [mm].
PAGES = {"A4": (210.0, 297.0), "Letter": (215.9, 279.4)}


@dataclass(frozen=True)
class SheetSubject:
    """What the sheet is about: a name, what it is made of, how it inflates, its panel, its numbers, and the
    user's settings of machines."""

    title: str
    film: Film
    inflation: Inflation
    pattern: Pattern
    numbers: Numbers
    settings: WorkSettings = NO_SETTINGS


def assembly_pdf(subject: SheetSubject, paper: str = "A4", say: Say = in_english) -> bytes:
    """Both pages; the same bytes for the same subject.

    say  gives the engine's texts in the reader's language; English stays where no font has its letters
    ExportError for other paper than "A4" and "Letter", MissingPackageError without matplotlib.
    """
    size = page_size(paper)
    matplotlib_pdf()
    say = readable(say, "Assembly sheet")
    name, film = drawable(subject.title), written(subject.film)
    across, up, _ = np.ptp(subject.inflation.positions, axis=0).tolist()
    over = 2.0 * float(subject.inflation.positions[:, 2].max())
    page = FirstPage(
        name,
        film,
        subject.pattern,
        subject.numbers,
        (across, up, over),
        say("Pattern, cut two (one mirrored)"),
        partial(_image, subject),
        steps(subject.pattern, film, subject.numbers, say, settings=subject.settings),
    )
    fonts = fonts_for(say("Assembly sheet"), name + say(film.title))
    title = f"{name}: {say('Assembly sheet')}"
    pictures = work_pictures(subject.pattern, film, subject.numbers, say)

    def draw_first(axes: Any) -> None:
        draw_first_page(Pen(axes, say, fonts), page, size)

    def draw_work(axes: Any) -> None:
        stage = partial(pattern_stage, pattern=subject.pattern)
        draw_work_page(Pen(axes, say, fonts), name, pictures, subject.pattern, stage, 1, size)

    return pdf(title, fonts, [(size, draw_first), (size, draw_work)])


def page_size(paper: str) -> tuple[float, float]:
    """Width and height of a paper [mm]. ExportError for one that is not known."""
    size = PAGES.get("A4" if paper.upper() == "A4" else paper.capitalize())
    if size is None:
        raise ExportError(f'There is no paper "{paper}" for the assembly sheet: choose A4 or Letter.')
    return size


def written(film: Film) -> Film:
    """A film with its names in letters that fonts have."""
    return replace(film, title=drawable(film.title), name=drawable(film.name))


def _image(subject: SheetSubject, width: int, height: int) -> Floats:
    colour = subject.film.look.colour
    return balloon_picture([subject.inflation], subject.pattern.seal_width, width, height, colour)
