# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon follows the painting: a quick preview after every stroke, a full design when the pen rests.

They work in threads. The newest painting counts: what was found for an older one is shown only as long as
nothing newer is there.
"""

from __future__ import annotations

import tempfile
import time
from collections import deque
from dataclasses import replace
from pathlib import Path

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import Cancelled
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.paint.painting.layers import SHAPE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.preview.preview_state import PreviewState
from BalloonWorkbench.gui.paint.preview.requests import FullDesign, QuickPreview
from BalloonWorkbench.gui.qt import QtCore

REST = 250  # ms without a change, then the full design begins
_WHILE_DRAWING = 250  # ms between quick previews during a stroke
_KNOWN = 8  # fitted balloons that come back at once
_PART = 0.03  # of the full design between two signs of progress


class LivePreview(QtCore.QObject):
    """Looks at a painting whenever it changes.

    width and settings belong to the balloon; `refused` says why none can be seen. `delays` has, for each
    quick preview, the seconds from the end of the stroke: by the clock, and of the processor in the threads
    on the way, one after the other: what the clock would tell on a machine with nothing else to do.
    """

    shown = QtCore.Signal(object)
    refused = QtCore.Signal(str)
    empty = QtCore.Signal()
    progressed = QtCore.Signal(float)

    def __init__(self, painting: Painting, parent=None):
        super().__init__(parent)
        self.painting = painting
        self.width = preferences.get("Width")
        self.settings = preferences.settings()
        self.latest: PreviewState | None = None
        self.delays: list[tuple[float, float]] = []
        self._known: deque[PreviewState] = deque(maxlen=_KNOWN)  # fitted, the newest first
        self._folder = tempfile.TemporaryDirectory()
        self._quick_preview: Worker | None = None
        self._full_design: Worker | None = None
        self._retired: list[Worker] = []
        self._dirty = False
        self._in_stroke = self._is_early = False  # early: the quick preview began before the stroke had ended
        self._last_part = 0.0
        self._changed_at = 0.0, 0.0
        self._rest = self._timer(REST, self.begin_full_design)
        self._soon = self._timer(_WHILE_DRAWING, self._begin_quick_preview)

    def changed(self) -> None:
        """A step is done: look at once, and closer when nothing more happens."""
        self._changed_at = time.perf_counter(), time.thread_time()
        self._dirty = True
        self._in_stroke = False
        self.drop_full_design()
        if self.painting.is_empty():
            self._nothing()
            return
        self._rest.start()
        if self._quick_preview is None:
            self._begin_quick_preview()
        elif self._is_early:
            self._quick_preview.stop()

    def drawing(self) -> None:
        """A stroke is growing: look now and then."""
        self.painting.revision += 1
        self.drop_full_design()
        self._rest.stop()
        self._dirty = self._in_stroke = True
        if self._quick_preview is None and not self._soon.isActive():
            self._soon.start()

    def set_width(self, width: float) -> None:
        """Of the balloon in mm."""
        if width != self.width:
            self.width = width
            self.painting.revision += 1
            self.changed()

    def read_as(self, drawn_as: str) -> None:
        """How the painting is read, see the core's segment.py."""
        if drawn_as != self.settings.drawn_as:
            self.settings = replace(self.settings, drawn_as=drawn_as)
            self.painting.revision += 1
            self.changed()

    def is_settled(self) -> bool:
        """The latest look is the document's own and belongs to the painting as it is."""
        return (
            self.latest is not None
            and self.latest.solved is not None
            and self.latest.revision == self.painting.revision
        )

    def is_fitted(self) -> bool:
        """The latest look has the document's own balloon and belongs to the painting as it is."""
        return (
            self.latest is not None and self.latest.fitted and self.latest.revision == self.painting.revision
        )

    def is_busy(self) -> bool:
        return self._quick_preview is not None or self._full_design is not None or self._rest.isActive()

    def begin_full_design(self, awaited: bool = False) -> None:
        """Begin the full design now, unless it runs; awaited: somebody waits for its end."""
        self._rest.stop()
        if self._full_design is not None:
            self._full_design.request.is_awaited = awaited
            return
        if self.painting.is_empty():
            return
        folder = Path(self._folder.name) / str(self.painting.revision)
        folder.mkdir(exist_ok=True)
        request = FullDesign(
            self.painting.file_image(),
            self.painting.layers[SHAPE].copy(),
            self.painting.revision,
            self.width,
            self.settings,
            folder / "painting.png",
            is_awaited=awaited,
            known=tuple(self._known),
        )
        self._last_part = 0.0
        self._full_design = self._begin(request, self._full_design_done)
        self._full_design.progressed.connect(self._pass_progress)
        self._full_design.before.connect(self._full_design_shown)
        request.show = self._full_design.show_before
        self._full_design.start(QtCore.QThread.LowPriority)

    def stop(self) -> None:
        """End all work; waits for the engine's next step."""
        for timer in (self._rest, self._soon):
            timer.stop()
        working = [self._quick_preview, self._full_design, *self._retired]
        for worker in filter(None, working):
            worker.stop()
        for worker in filter(None, working):
            worker.abandon()
        self._quick_preview = self._full_design = None
        self._retired.clear()

    def _timer(self, interval: int, action):
        timer = QtCore.QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(interval)
        timer.timeout.connect(action)
        return timer

    def _begin(self, request, done) -> Worker:
        worker = Worker(request, self)
        worker.ended.connect(lambda: done(worker))
        return worker

    def _begin_quick_preview(self) -> None:
        self._soon.stop()
        if self._quick_preview is not None:
            return
        self._dirty, self._is_early = False, self._in_stroke
        if self.painting.is_empty():
            self._nothing()
            return
        image = self.painting.layers[SHAPE].copy()
        known = tuple(self._known)
        self._quick_preview = self._begin(
            QuickPreview(image, self.painting.revision, self.width, self.settings, known),
            self._quick_preview_done,
        )
        self._quick_preview.start()

    def _nothing(self) -> None:
        """Nothing is painted: whatever was seen before is over."""
        self._rest.stop()
        self._soon.stop()
        self._dirty = False
        if self._quick_preview is not None:
            self._quick_preview.stop()
        self.latest = None
        self.empty.emit()

    def _quick_preview_done(self, worker: Worker) -> None:
        if worker is not self._quick_preview:
            return
        self._quick_preview = None
        worker.deleteLater()
        newest = worker.request.revision == self.painting.revision
        if not (newest and self.is_fitted()) and not self.painting.is_empty():
            self._take(worker)
        if newest and not self._dirty:
            clock, work = self._changed_at
            self.delays.append((time.perf_counter() - clock, time.thread_time() - work + worker.work))
        if self._dirty:
            self._begin_quick_preview()

    def _full_design_shown(self, state: PreviewState) -> None:
        """The balloon is fitted; what the document needs is still on its way."""
        if self._full_design is not None and state.revision == self.painting.revision:
            self._show(state)
            self.progressed.emit(1.0)

    def _full_design_done(self, worker: Worker) -> None:
        worker.deleteLater()
        if worker is not self._full_design:
            if worker in self._retired:
                self._retired.remove(worker)
            return
        self._full_design = None
        self.progressed.emit(1.0)
        if worker.request.revision == self.painting.revision:
            self._take(worker)

    def _take(self, worker: Worker) -> None:
        if worker.design is not None:
            self._show(worker.design)
        elif not isinstance(worker.error, Cancelled):
            self.latest = None
            self.refused.emit(worker.fault() or str(worker.error))

    def _show(self, state: PreviewState) -> None:
        self.latest = state
        if state.fitted:
            others = [each for each in self._known if not each.is_of(state.traced, state.width)]
            self._known = deque([state, *others], _KNOWN)
        self.shown.emit(state)

    def drop_full_design(self) -> None:
        """Nobody wants it any more: let the engine stop by itself, nobody waits for it."""
        if self._full_design is not None:
            self._full_design.stop()
            self._retired.append(self._full_design)
            self._full_design = None
            self.progressed.emit(1.0)

    def _pass_progress(self, fraction: float, text: str) -> None:
        if self._full_design is None or (self.is_fitted() and not self._full_design.request.is_awaited):
            return
        if fraction >= self._last_part + _PART:
            self._last_part = fraction
            self.progressed.emit(fraction)
