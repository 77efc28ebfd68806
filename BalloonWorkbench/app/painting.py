# SPDX-License-Identifier: LGPL-2.1-or-later
"""Painted balloons in a document: the painting is the outline's drawing, a PNG that keeps its strokes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from BalloonWorkbench.app import balloon, create, pattern, status
from BalloonWorkbench.app.create import Parts
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.app.solve import Request
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.types import Progress, no_progress

#: Name of the text in a PNG file that holds the strokes.
KEY = "FilmBalloonPainting"
_HEAD = 4096  # bytes in which its name appears, before the pixels


@dataclass(frozen=True)
class Solved:
    """The balloons of a painting, the largest shape first, free of the document.

    told  what `balloon.describe` says about each
    """

    requests: tuple[Request, ...]
    designs: tuple[Design, ...]
    told: tuple[dict, ...]


def is_painting(path) -> bool:
    """Whether a file comes from the paint window: its strokes can be edited again."""
    try:
        with open(path, "rb") as file:
            return KEY.encode() in file.read(_HEAD)
    except OSError:
        return False


def solve(
    path: Path,
    width: float,
    settings: Settings,
    sheet: dict | None = None,
    progress: Progress = no_progress,
) -> Solved:
    """Design the balloons of a painting [width in mm]; may run in another thread.

    sheet  values of a pattern as `pattern.values` has them: the arcs of its contours are prepared

    Raises BalloonError when there is none, Cancelled when progress says stop.
    """
    from BalloonWorkbench.app.drawing import read_drawing
    from BalloonWorkbench.core.report import Source

    drawing, kind = read_drawing(str(path), width, 0.0, symmetry=settings.symmetry)
    count = len(drawing.parts)
    requests, designs, told = [], [], []
    for number, outline in enumerate(drawing.parts):
        alike = settings if number == 0 else replace(settings, goal=None)
        request = Request(Source(path.name, kind, outline), alike)
        design = request.solve(
            lambda fraction, text, before=number: progress((before + fraction) / count, text)
        )
        requests.append(request)
        designs.append(design)
        told.append(balloon.describe(request, design))
        if sheet is not None:
            _prepare(design.pattern, settings.film.seal_width, sheet)
    return Solved(tuple(requests), tuple(designs), tuple(told))


def _prepare(seam, seal_width: float, sheet: dict) -> None:
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.pattern.build import build_pattern

    try:
        contours = build_pattern(seam, seal_width, **sheet).contours
    except InputError:  # the pattern object will say what is wrong
        return
    for contour in contours:
        pattern.arcs(contour.points, contour.closed)


def make(doc, path: Path, width: float, solved: Solved, pause: Callable[[], object] = bool) -> Parts:
    """The objects of a painted balloon, width in mm; pause is called between the steps of the work.

    Raises BalloonError when no balloon comes out; the objects stay for the caller to take back.
    """
    parts = create.make(doc, path.stem)
    everyone = _fill(parts, path, width, solved, pause)
    create.compute(*everyone)
    return parts


def update(
    parts: Parts, path: Path, width: float, solved: Solved, pause: Callable[[], object] = bool
) -> None:
    """Give a painted balloon its changed painting; as `make`."""
    _fill(parts, path, width, solved, pause)
    parts.balloon.Document.recompute()


def _fill(parts: Parts, path: Path, width: float, solved: Solved, pause) -> list[Parts]:
    set_drawing(parts.outline, path)
    parts.outline.Width, parts.outline.Height = width, 0.0
    create.match_companions(parts)
    pause()
    everyone = [parts, *create.companions(parts)]
    for each, request, design, told in zip(everyone, solved.requests, solved.designs, solved.told):
        each.outline.recompute()
        pause()
        if status.is_ready(each.outline):
            wanted = balloon.request(each.balloon)
            if wanted.key() == request.key():  # else its own values differ, and the recompute solves it
                balloon.show(each.balloon, wanted, design, told)
                pause()
                each.balloon.recompute()
                pause()
                each.pattern.recompute()
        pause()
    return everyone
