# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work: the status bar shows it and stops it, the window answers, the document stays as it was."""

import gc
import re
import sys
import threading
import time
from pathlib import Path

import FreeCADGui as Gui
import hands
import pytest
from heartbeat import Heartbeat

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.engine import bag_result, maker
from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import Cancelled, MeshError
from BalloonWorkbench.gui.long_work import worker as worker_module
from BalloonWorkbench.gui.long_work.status_progress import StatusProgress
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.balloon import body_rows
from BalloonWorkbench.gui.panels.balloon.body_rows import BodyRows
from BalloonWorkbench.gui.panels.making.maker_rows import MakerRows

pytestmark = pytest.mark.works_out

OURS = Path(worker_module.__file__).parents[1]


def shown():
    """The stop button of the work that the status bar shows; None when there is none."""
    return next(
        (b for b in hands.visible(hands.QtWidgets.QPushButton) if b.objectName() == "BalloonStop"), None
    )


def when_shown(action):
    """Do something once, as soon as the status bar shows work; returns the timer."""
    timer = hands.QtCore.QTimer()

    def look():
        if shown() is not None:
            timer.stop()
            action()

    timer.timeout.connect(look)
    timer.start(10)
    return timer


@pytest.mark.parametrize("how", ["key", "button"])
def test_a_recompute_is_stopped_and_keeps_what_was(made, how, monkeypatch):
    doc, volume = made.balloon.Document, made.balloon.Volume.Value
    made.balloon.MeshSize = 1
    steps, report = [], Worker._report

    def count(worker, fraction, text):
        steps.append(worker._stop)
        return report(worker, fraction, text)

    monkeypatch.setattr(Worker, "_report", count)

    def stop():
        hands.screenshot(f"long-work-{how}")
        beat.skip()
        if how == "key":
            hands.key(Gui.getMainWindow(), hands.QtCore.Qt.Key_Escape)
        else:
            hands.click(shown())

    timer, beat = when_shown(stop), Heartbeat()
    doc.recompute()
    beat.stop()
    assert not timer.isActive()
    assert made.balloon.Status.startswith(status.STALE)
    assert made.balloon.Volume.Value == volume
    assert steps.index(True) == len(steps) - 1  # the engine asks at each step, and goes no further
    assert beat.answers()
    hands.wait(0.05)
    assert shown() is None


def test_nobody_edits_meanwhile(made, monkeypatch):
    """A click on a widget and a key press wait in vain until the recompute is over."""
    pressed, clicked, report = [], threading.Event(), Worker._report

    def when_clicked(worker, fraction, text):
        return clicked.wait(60.0) and report(worker, fraction, text)

    monkeypatch.setattr(Worker, "_report", when_clicked)
    button = hands.QtWidgets.QPushButton("x", Gui.getMainWindow())
    button.clicked.connect(lambda: pressed.append(1))
    button.show()
    made.balloon.MeshSize = 8
    timer = when_shown(lambda: (hands.click(button), clicked.set()))
    made.balloon.Document.recompute()
    assert not timer.isActive()
    assert not pressed
    assert status.is_ready(made.balloon)
    hands.click(button)
    assert pressed
    button.deleteLater()


def test_work_runs_beside_the_window_and_its_error_comes_back(doc):
    def job(progress):
        assert progress(0.5, "half")
        return threading.current_thread() is threading.main_thread()

    assert hooks.run_blocking("Testing", job) is False

    def broken(progress):
        raise MeshError("too thin")

    with pytest.raises(MeshError, match="too thin"):
        hooks.run_blocking("Testing", broken)

    def endless(progress):
        while progress(0.1, ""):
            time.sleep(0.01)
        raise Cancelled("Stopped.")

    timer = when_shown(lambda: hands.key(Gui.getMainWindow(), hands.QtCore.Qt.Key_Escape))
    with pytest.raises(Cancelled):
        hooks.run_blocking("Testing", endless)
    assert not timer.isActive()


class Watched:
    """What a worker is asked: it sees which functions of Qt are called in the worker's thread after it."""

    def __init__(self):
        self.calls = []

    def solve(self, progress):
        sys.setprofile(self._watch)
        return progress(0.5, "half")

    def _watch(self, _frame, event, called):
        own = type(getattr(called, "__self__", None)).__module__
        if event == "c_call" and own.startswith(("PySide", "Shiboken")):
            self.calls.append(called.__name__)


def test_a_workers_thread_leaves_qt_alone(doc):
    """What it tells comes in its order, in the window's thread."""
    asked, told = Watched(), []
    worker = Worker(asked, title="Testing")
    main = threading.main_thread()
    worker.progressed.connect(lambda *given: told.append((given, threading.current_thread() is main)))
    worker.ended.connect(lambda: told.append((worker.design, threading.current_thread() is main)))
    worker.start()
    hands.wait_until(lambda: len(told) == 2)
    assert told == [((0.5, "half"), True), (True, True)]
    assert asked.calls == []
    assert gc.isenabled()


def test_nobody_listens_to_a_workers_thread():
    lines = [line for path in OURS.rglob("*.py") for line in path.read_text(encoding="utf-8").splitlines()]
    assert [line for line in lines if "orker.ended.connect" in line]
    assert not [line for line in lines if re.search(r"orker\.(finished|started)\b", line)]


def test_who_abandons_a_worker_hears_nothing_of_it(doc):
    told = []
    worker = Worker(Watched(), title="Testing")
    for signal in (worker.progressed, worker.ended):
        signal.connect(lambda *_given: told.append(1))
    worker.start()
    assert not gc.isenabled()  # what it finds in another thread may be widgets
    worker.abandon()
    hands.wait(0.1)
    assert told == []
    assert gc.isenabled()
    assert shown() is None


def endless(begun, over):
    """Work that asks whether it is still wanted, and is never done."""

    def work(*_given):
        begun.append(1)
        try:
            while True:
                checkpoint()
                time.sleep(0.01)
        finally:
            over.append(1)

    return work


@pytest.mark.parametrize("rows", [MakerRows, BodyRows])
def test_a_count_that_nobody_waits_for_any_more_ends(made, monkeypatch, rows):
    begun, over = [], []
    monkeypatch.setattr(maker, "counting", lambda _parts, exact: endless(begun, over))
    monkeypatch.setattr(bag_result, "stored", lambda _balloon: (None, None))
    monkeypatch.setattr(body_rows, "body_figures", endless(begun, over))
    page = hands.QtWidgets.QWidget()
    shown = rows(hands.QtWidgets.QFormLayout(page))
    for turn in (1, 2):
        shown.show(made)
        hands.wait_until(lambda turn=turn: len(begun) == turn and len(over) == turn - 1, 10)
    shown.release()
    hands.wait_until(lambda: len(over) == 2, 10)


def test_a_message_in_the_status_bar_stays_readable():
    """Work that comes and goes does not lay FreeCAD's labels over it."""
    bar = Gui.getMainWindow().statusBar()

    def work():
        progress = StatusProgress("Working", lambda: None)
        hands.wait_until(lambda: shown() is not None, 5)
        return progress

    work().close()
    bar.clearMessage()
    hands.wait(0.2)
    labels = [w for w in bar.findChildren(hands.QtWidgets.QLabel) if w.isVisible()]
    bar.showMessage("Written to somewhere", 60_000)
    hands.wait(0.1)
    hidden = [label for label in labels if not label.isVisible()]
    assert hidden
    progress = work()
    assert not any(label.isVisible() for label in hidden)
    progress.close()
    hands.wait(0.1)
    assert not any(label.isVisible() for label in hidden)
    assert shown() is None
    bar.clearMessage()
    hands.wait(0.1)
    assert all(label.isVisible() for label in hidden)
