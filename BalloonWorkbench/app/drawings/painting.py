# SPDX-License-Identifier: LGPL-2.1-or-later
"""Painted balloons in a document: the painting is the outline's drawing, a PNG that keeps its strokes."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.kinds import leader
from BalloonWorkbench.app.document.parts import Parts, companions
from BalloonWorkbench.app.drawings.drawing_file import (
    drawn_pixels_of,
    file_of,
    is_painting,
    pixels_of,
    read_drawing,
)
from BalloonWorkbench.app.engine.solve import Request, describe
from BalloonWorkbench.app.outline import DRAWN_AS, reading_of, set_drawing
from BalloonWorkbench.core.checkpoint import checkpoint, stoppable
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.outline.chambers import linked
from BalloonWorkbench.core.rounded import rounded
from BalloonWorkbench.core.tracing.segment import AUTO
from BalloonWorkbench.core.types import Progress, no_progress

_FITTING = 0.6  # of the work of `solve`


@dataclass(frozen=True)
class SolvedPainting:
    """The balloons of a painting, the largest shape first, free of the document.

    reports  what `describe` says about each
    """

    requests: tuple[Request, ...]
    designs: tuple[Design, ...]
    reports: tuple[dict, ...]


@dataclass(frozen=True)
class PaintedArtwork:
    """What is painted on a balloon: a picture with its scale and place in the drawing.

    rgba    (h, w, 4) uint8, upright; alpha 0 where the film is bare
    corner  (2,) mm, its lower left corner in the frame of the Outline
    pixel   mm, side of a pixel
    """

    rgba: np.ndarray
    corner: np.ndarray
    pixel: float

    def places(self, points) -> np.ndarray:
        """Where points (n, 2) mm of the drawing are in the picture (n, 2), 0 to 1, y up."""
        height, width = self.rgba.shape[:2]
        return (np.asarray(points, dtype=float)[:, :2] - self.corner) / (
            self.pixel * np.array([width, height])
        )


def artwork(outline) -> PaintedArtwork | None:
    """The painting of an Outline object, of its own or of the one whose drawing it shares.

    None where there is none: an outline from a sketch, a vector drawing, a photo.
    """
    first = leader(outline)
    if first.Source or not is_painting(first.Drawing):
        return None
    return place(first.Drawing, first.Width.Value, first.Height.Value, *reading_of(first)[1:])


def place(
    path,
    width: float,
    height: float = 0.0,
    drawn_as: str = AUTO,
    tracing: TracingOptions = USUAL_TRACING,
) -> PaintedArtwork | None:
    """The picture in a painting's file, which becomes so wide or high in mm; None where it has no shape."""
    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.tracing.picture import placed_drawing

    rgba = pixels_of(file_of(path))
    try:
        drawing, corner = placed_drawing(drawn_pixels_of(file_of(path)), drawn_as=drawn_as, tracing=tracing)
    except BalloonError:
        return None
    pixel = width / drawing.size[0] if width else height / drawing.size[1]
    return PaintedArtwork(rgba, -pixel * corner, pixel)


def solve(
    path: Path,
    width: float,
    settings: Settings,
    progress: Progress = no_progress,
    fitted: Callable[[list[Request], list[Design]], object] = lambda requests, designs: None,
) -> SolvedPainting:
    """Design the balloons of a painting [width in mm]; may run in another thread.

    What the document's objects will ask for is worked out. fitted: called as soon as all balloons have their
    shape, before what there is to tell about them.
    Raises BalloonError when there is none, Cancelled when progress says stop.
    """
    from BalloonWorkbench.core.reports.report import Source

    settings = _as_stored(settings)
    drawing, kind = read_drawing(
        str(path), width, 0.0, symmetry=settings.symmetry, drawn_as=settings.drawn_as
    )
    count = len(drawing.parts)
    requests, designs, reports = [], [], []
    for number, drawn in enumerate(drawing.parts):
        outline = linked(drawn, settings.passage)
        alike = settings if number == 0 else replace(settings, goal=None)
        request = Request(Source(path.name, kind, outline), alike)
        requests.append(request)
        designs.append(request.design(_share(progress, number, count)))
    fitted(requests, designs)
    with stoppable(progress):
        for number, (request, design) in enumerate(zip(requests, designs)):
            checkpoint(_FITTING + (1.0 - _FITTING) * number / count)
            reports.append(describe(request, design))
            checkpoint(_FITTING + (1.0 - _FITTING) * (number + 0.5) / count)
            with suppress(InputError):  # the pattern object will say what is wrong
                pattern.draw(design.pattern, settings.film.seal_width, settings.pattern)
        place(path, width, drawn_as=settings.drawn_as)  # the window will ask for it, and shall not wait
    return SolvedPainting(tuple(requests), tuple(designs), tuple(reports))


def _share(progress: Progress, number: int, count: int) -> Progress:
    """The progress of fitting one of several balloons within the whole work."""
    return lambda fraction, text: progress(_FITTING * (number + fraction) / count, text)


def _as_stored(settings: Settings) -> Settings:
    """Settings as the objects will have them, which keep the width of the intake."""
    from BalloonWorkbench.core.pattern.intake.places import intake_of

    options = settings.pattern
    return rounded(replace(settings, pattern=replace(options, intake_width=intake_of(options).width)))


def make(
    doc,
    path: Path,
    width: float,
    solved: SolvedPainting,
    pause: Callable[[], object] = bool,
    begin: Callable[..., Parts] = create.make,
) -> Parts:
    """The objects of a painted balloon, width in mm; pause is called between the steps of the work.

    begin  makes the objects in a document, with a label

    Raises BalloonError when no balloon comes out; the objects stay for the caller to take back.
    """
    parts = begin(doc, path.stem)
    everyone = _fill(parts, path, width, solved, pause)
    create.compute(*everyone, pause=pause)
    return parts


def update(
    parts: Parts, path: Path, width: float, solved: SolvedPainting, pause: Callable[[], object] = bool
) -> None:
    """Give a painted balloon its changed painting; as `make`."""
    _fill(parts, path, width, solved, pause)
    parts.balloon.Document.recompute()


def _fill(parts: Parts, path: Path, width: float, solved: SolvedPainting, pause) -> list[Parts]:
    set_drawing(parts.outline, path)
    parts.outline.Width, parts.outline.Height = width, 0.0
    drawn_as = solved.requests[0].settings.drawn_as
    parts.outline.DrawnAs = next(title for title, choice in DRAWN_AS.items() if choice == drawn_as)
    create.match_companions(parts)
    pause()
    everyone = [parts, *companions(parts)]
    for each, request, design, report in zip(everyone, solved.requests, solved.designs, solved.reports):
        parts.outline.Document.recompute([each.outline])
        pause()
        if status.is_ready(each.outline):
            current = balloon.request(each.balloon)
            if current.key() == request.key():  # else its own values differ, and the recompute solves it
                balloon.show(each.balloon, current, design, report)
                pause()
                parts.outline.Document.recompute([each.balloon])
                pause()
                parts.outline.Document.recompute([each.pattern])
        pause()
    return everyone
