# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is asked about a painting, each in a worker: a quick preview, on a coarse mesh; the full design, which
the document will have; and a picture without its background."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from BalloonWorkbench.app.drawings import painting
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.advice.as_data import finding_from
from BalloonWorkbench.core.checkpoint import checkpoint, stoppable
from BalloonWorkbench.core.design.draft import VERTICES, check_area, draft
from BalloonWorkbench.core.errors import BalloonError, ExportError
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.preview.advice_marks import remarks
from BalloonWorkbench.gui.paint.preview.preview_state import (
    NEARLY,
    PictureFrame,
    PreviewState,
    contours,
    drawn,
    loops_in,
    seen,
    size,
    skin,
)
from BalloonWorkbench.gui.qt import QtCore, QtGui, translate

_MOST_SHAPES = 6  # by a quick preview
_LEAST = 60  # vertices of a small shape
_PAUSE = 0.5  # s between a fitted balloon and the rest of a full design, looking whether to go on after
_LOOK = 0.05  # s each


@dataclass
class QuickPreview:
    """The quick look at the shape of a painting, an image; width in mm.

    known  fitted states, the newest first: one of the same outline is kept, whatever else has been painted;
           the newest stands for an outline that is nearly the same until that is fitted
    """

    image: object
    revision: int
    width: float
    settings: Settings
    known: tuple[PreviewState, ...] = ()

    def solve(self, progress) -> PreviewState:
        """Raises BalloonError where no balloon can be seen yet, Cancelled when progress says stop."""
        with stoppable(progress):
            return self._look(progress)

    def _look(self, progress) -> PreviewState:
        drawing, frame = seen(self.image, self.width, self.settings.drawn_as)
        traced = loops_in(drawing, frame)
        for state in self.known:
            if state.is_of(traced, self.width):
                return replace(state, revision=self.revision, solved=None, file=None)
        for state in self.known[:1]:
            if state.is_of(traced, self.width, NEARLY):
                # as where an inner line touches the rim: the balloon that was fitted is nearer than a draft
                return replace(
                    state,
                    revision=self.revision,
                    drawing=drawing,
                    frame=frame,
                    fitted=False,
                    remarks=(),
                    solved=None,
                    file=None,
                )
        checkpoint()
        drafts = []
        for number, part in enumerate(drawing.parts[:_MOST_SHAPES]):
            vertices = max(_LEAST, int(VERTICES * part.area / drawing.largest.area))
            try:
                drafts.append(
                    draft(
                        part,
                        self.settings.film,
                        self.settings.pressure,
                        vertices,
                        progress,
                        self.settings.correct,
                    )
                )
            except BalloonError:
                if number == 0:
                    raise
            checkpoint()
        largest = drafts[0].inflation
        return PreviewState(
            self.revision,
            tuple(skin(each.inflation, frame.places(each.inflation.panel.rest_positions)) for each in drafts),
            drawing,
            frame,
            contours([each.pattern for each in drafts], self.settings, fair=False),
            size(largest),
            largest.volume,
        )


@dataclass
class FullDesign:
    """The fitted balloons of an image, in the file that the document will have.

    shape       the image without its decoration: what the outline comes from
    show        is given the state of the balloons as soon as they are fitted; what can be said about them
                and what the document needs comes later
    is_awaited  somebody waits for that
    known       fitted states, the newest first: balloons that are the same are not fitted again
    """

    image: object
    shape: object
    revision: int
    width: float
    settings: Settings
    file: Path
    show: Callable[[PreviewState], object] = bool
    is_awaited: bool = False
    known: tuple[PreviewState, ...] = ()

    def solve(self, progress) -> PreviewState:
        """Raises BalloonError where there is none, Cancelled when progress says stop."""
        with stoppable(progress):
            return self._solve(progress)

    def _solve(self, progress) -> PreviewState:
        if not self.image.save(str(self.file), "PNG"):
            raise ExportError(
                translate("The painting cannot be written to '{}': is the disk full?").format(self.file)
            )
        drawing, frame = seen(self.shape, self.width, self.settings.drawn_as)
        check_area(drawing.largest)
        checkpoint()
        traced = loops_in(drawing, frame)
        states = []

        def fitted(requests, designs) -> None:
            same = (state for state in self.known if state.is_of(traced, self.width))
            state = next((state for state in same if _are_same(state.designs, designs)), None)
            if state is None:
                state = replace(self._look(frame, requests, designs), traced=traced, designs=tuple(designs))
                self.show(state)
            else:
                state = replace(state, revision=self.revision, drawing=_drawing(requests))
            states.append(state)
            self._pause()

        solved = painting.solve(self.file, self.width, self.settings, progress, fitted)
        findings = [finding_from(data) for report in solved.reports for data in report["advice"]]
        findings.sort(key=lambda finding: -finding.severity.rank)
        pattern = contours([design.pattern for design in solved.designs], solved.requests[0].settings)
        return replace(
            states[0], contours=pattern, remarks=remarks(findings, frame, SIDE), solved=solved, file=self.file
        )

    def _pause(self) -> None:
        """The pen may be back soon: then the rest would be for nothing, and slow down the next preview."""
        end = time.monotonic() + _PAUSE
        while time.monotonic() < end and not self.is_awaited:
            checkpoint()
            time.sleep(_LOOK)

    def _look(self, frame: PictureFrame, requests, designs) -> PreviewState:
        """The balloons and the pattern, whose lines are not smooth yet."""
        inflations = [design.inflation for design in designs]
        return PreviewState(
            self.revision,
            tuple(skin(inflation, frame.places(drawn(inflation))) for inflation in inflations),
            _drawing(requests),
            frame,
            contours([design.pattern for design in designs], self.settings, fair=False),
            size(inflations[0]),
            inflations[0].volume,
            fitted=True,
            width=self.width,
        )


def _are_same(designs, others) -> bool:
    """The same balloons; what was said of their drawings may differ."""
    return len(designs) == len(others) and all(
        one.inflation is other.inflation for one, other in zip(designs, others)
    )


def _drawing(requests) -> Drawing:
    return Drawing(tuple(request.source.outline for request in requests))


@dataclass
class CutOut:
    """A picture without its background, to be painted on."""

    content: bytes

    def solve(self, progress) -> bytes:
        """The same picture as PNG, transparent where nothing is drawn. Raises BalloonError."""
        from BalloonWorkbench.core.tracing.segment import segment

        rgba = pixels(QtGui.QImage.fromData(self.content))
        silhouette, _ = segment(rgba)
        rgba[..., 3] = np.minimum(np.maximum(rgba[..., 3], 255 * (silhouette > 0.5)), 255 * silhouette)
        height, width = silhouette.shape
        image = QtGui.QImage(rgba.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
        buffer = QtCore.QBuffer()
        buffer.open(QtCore.QIODevice.WriteOnly)
        image.save(buffer, "PNG")
        return bytes(buffer.data())
