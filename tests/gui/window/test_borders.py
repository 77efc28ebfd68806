# SPDX-License-Identifier: LGPL-2.1-or-later
"""The borders one by one: threads, commands, panels, slots, timers, event handlers, observers, views."""

import faulthandler
import sys
from pathlib import Path

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.core.errors import Cancelled, ProgramFault
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.gui import view
from BalloonWorkbench.gui.commands import examples
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.panels.results import colour_map
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.window import borders

FAULT = "This is a fault of the program, not yours."


@pytest.fixture(autouse=True)
def no_fault():
    """Here they are made."""


@pytest.fixture(autouse=True)
def ends():
    """A window that is frozen ends the run; a box is closed."""
    faulthandler.dump_traceback_later(hands.patience(120), exit=True, file=sys.__stderr__)
    yield
    faulthandler.cancel_dump_traceback_later()
    if box() is not None:
        box().close()
    hands.wait(0.05)


@pytest.fixture(autouse=True)
def each_is_told(monkeypatch):
    """The same sentence is told again at once."""
    monkeypatch.setattr(borders, "_ONCE", 0.0)


def box():
    boxes = hands.visible(hands.QtWidgets.QMessageBox)
    return next((one for one in boxes if one.objectName() == "BalloonFault"), None)


def boxed():
    hands.wait_until(lambda: box() is not None, 5)
    text = box().text()
    box().close()
    hands.wait(0.05)
    return text


def broken(*_given, **_named):
    raise IndexError("put in by a test")


class Asked:
    """What a worker is asked: nothing but trouble."""

    def __init__(self, error):
        self._error = error

    def solve(self, progress):
        progress(0.5, "half")
        raise self._error


@pytest.mark.parametrize(
    "error",
    [RuntimeError, ZeroDivisionError, MemoryError, RecursionError, SystemExit, KeyboardInterrupt],
)
def test_whatever_ends_a_thread_the_window_lives(doc, error):
    beats = []
    timer = hands.QtCore.QTimer()
    timer.timeout.connect(lambda: beats.append(1))
    timer.start(10)
    worker = Worker(Asked(error()), title="Testing")
    worker.start()
    hands.wait_until(worker.isFinished, 20)
    assert isinstance(worker.error, ProgramFault)
    assert error.__name__ in Path(worker.error.file).read_text(encoding="utf-8")
    before = len(beats)
    hands.wait_until(lambda: len(beats) > before + 2, 10)
    with pytest.raises(ProgramFault):
        hooks.run_blocking("Testing", Asked(error()).solve)
    with pytest.raises(Cancelled):
        hooks.run_blocking("Testing", Asked(Cancelled("Stopped.")).solve)


def test_a_command_that_fails_says_so_and_leaves_no_undo_step(made, monkeypatch):
    doc = made.balloon.Document
    names = [obj.Name for obj in doc.Objects]
    for name in ("FromPicture", "Artwork", "Nest"):
        monkeypatch.setattr("BalloonWorkbench.gui.panels.show", broken)
        Gui.Selection.addSelection(made.balloon)
        Gui.runCommand(f"BalloonWorkbench_{name}")
        assert FAULT in boxed()
        assert [obj.Name for obj in doc.Objects] == names
        assert not doc.HasPendingTransaction
        assert not hands.panel_is_open()
        monkeypatch.undo()
    assert doc.UndoNames == []
    monkeypatch.setattr(examples, "open_copy", broken)
    Gui.runCommand(examples._name(examples.EXAMPLES[0]))
    assert FAULT in boxed()


def test_a_command_in_doubt_is_off(made, monkeypatch):
    monkeypatch.setattr("BalloonWorkbench.app.document.parts.patterns", broken)
    assert not Gui.Command.get("BalloonWorkbench_Advice").isActive()
    assert FAULT in boxed()


def test_ok_that_fails_leaves_the_panel_and_cancel_closes_it(opened, monkeypatch):
    doc = opened.balloon.Document
    hands.click(hands.find("Live"), x=8)
    hands.type_into(hands.find("MeshSize"), "12 mm")
    monkeypatch.setattr("BalloonWorkbench.gui.panels.balloon.balloon_panel.BalloonPanel.apply", broken)
    hands.press("Ok")
    hands.wait_until(lambda: FAULT in hands.message(), 5)
    assert hands.panel_is_open()
    monkeypatch.setattr("BalloonWorkbench.gui.panels.balloon.balloon_panel.BalloonPanel.close", broken)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed, 5)
    assert not doc.HasPendingTransaction
    assert opened.balloon.MeshSize.Value == 10
    assert doc.UndoNames == []
    boxed()


def test_a_result_that_cannot_be_shown_keeps_the_old_balloon(opened, monkeypatch):
    volume, label = opened.balloon.Mesh.Volume, opened.balloon.SolvedFor
    monkeypatch.setattr("BalloonWorkbench.app.engine.film_result.store", broken)
    hands.type_into(hands.find("MeshSize"), "12 mm")
    hands.press("Ok")
    hands.wait_until(lambda: FAULT in hands.message(), 30)
    assert (opened.balloon.Mesh.Volume, opened.balloon.SolvedFor) == (volume, label)
    assert hands.find("Apply").isVisible()
    monkeypatch.undo()
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert status.is_ready(opened.balloon)
    assert opened.balloon.SolvedFor != label


def test_slots_timers_and_event_handlers(made, monkeypatch):
    others = []
    monkeypatch.setattr(sys, "excepthook", lambda *given: others.append(given[0].__name__))
    borders.watch()
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    monkeypatch.setattr(colour_map, "save_results", broken)
    hands.click(hands.find("SaveResults"))
    hands.wait_until(lambda: FAULT in hands.find("ColourMapMessage").text(), 5)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    monkeypatch.setattr("BalloonWorkbench.gui.view3d.film_display.FilmDisplay.follow", broken)
    made.balloon.ViewObject.Visibility = False
    assert FAULT in boxed()  # a timer; nothing of ours is open
    button = hands.QtWidgets.QPushButton("x", Gui.getMainWindow())
    button.clicked.connect(lambda: others[5])
    button.show()
    hands.click(button)
    button.deleteLater()
    assert others == ["IndexError"]  # somebody else's
    assert box() is None


def test_a_canvas_that_cannot_be_painted_is_one_message(doc, monkeypatch):
    window = brush.open_window()
    monkeypatch.setattr(borders, "_ONCE", 60.0)
    told = []
    monkeypatch.setattr(paint_window.PaintWindow, "fail", lambda _window, error: told.append(error))
    monkeypatch.setattr("BalloonWorkbench.gui.paint.canvas.scale.Scale.paint", broken)
    for _ in range(5):
        window.canvas.update()
        hands.wait(0.05)
    monkeypatch.undo()
    assert len(told) == 1
    window.canvas.update()
    hands.wait(0.05)
    brush.close_window()


@pytest.mark.slow
def test_make_it_says_why_it_cannot_go_on_and_goes_on_the_next_time(doc, monkeypatch):
    window = brush.open_window()
    window.live.settings = Settings(correct=False, mesh_size=0.02)
    brush.fish_body(window)
    hands.wait_until(window.live.is_settled, 60)
    if window.card.isVisible():
        brush.press("PaintSizeDone")
    hands.wait_until(window.live.is_settled, 60)
    for place in ("app.document.create.compute", "core.results.stl.balloon_mesh"):
        monkeypatch.setattr(f"BalloonWorkbench.{place}", broken)
        brush.press("PaintMake")
        hands.wait_until(lambda: FAULT in window.form.hint.text(), 20)
        monkeypatch.undo()
        assert doc.Objects == []
        assert not doc.HasPendingTransaction
        assert window.form.make_button.isEnabled()
    brush.press("PaintMake")
    hands.wait_until(brush.is_closed, 60)
    assert [doc.getObject(name).Status for name in ("Outline", "Balloon", "Pattern")] == [status.READY] * 3
    hands.wait_until(hands.panel_is_seen)


def test_a_glance_that_fails_is_told_and_the_next_stroke_is_looked_at(doc, monkeypatch):
    window = brush.open_window()
    monkeypatch.setattr("BalloonWorkbench.gui.paint.preview.requests.seen", broken)
    window.live.settings = Settings(correct=False, mesh_size=0.02)
    brush.fish_body(window)
    hands.wait_until(lambda: FAULT in window.form.hint.text(), 20)
    brush.press("PaintMake")
    hands.wait_until(window.form.make_button.isEnabled, 20)
    assert FAULT in window.form.hint.text()
    monkeypatch.undo()
    brush.draw(window.canvas, brush.ellipse(0.44, 0.52, 0.30, 0.19))
    hands.wait_until(lambda: window.live.latest is not None, 30)
    hands.wait_until(lambda: FAULT not in window.form.hint.text(), 30)
    brush.close_window()


def test_what_freecad_calls_prints_no_traceback(made, monkeypatch):
    """The log is searched for tracebacks after the tests."""
    monkeypatch.setattr(view, "drawn_icon", broken)
    made.balloon.ViewObject.signalChangeIcon()
    monkeypatch.setattr("BalloonWorkbench.gui.view3d.balloon_display.BalloonDisplay.view_changed", broken)
    made.balloon.ViewObject.Transparency = 11
    monkeypatch.setattr("BalloonWorkbench.gui.view3d.balloon_display.BalloonDisplay.mode_chosen", broken)
    made.balloon.ViewObject.DisplayMode = "Shaded"
    assert made.balloon.ViewObject.DisplayMode == "Shaded"
    monkeypatch.setattr("BalloonWorkbench.gui.panels.edit", broken)
    assert made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    assert FAULT in boxed()
    gone = Watch([made.pattern], broken)
    made.pattern.Document.removeObject(made.pattern.Name)
    assert FAULT in boxed()
    gone.remove()
    assert App.ActiveDocument.getObject("Pattern") is None
