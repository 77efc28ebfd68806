# SPDX-License-Identifier: LGPL-2.1-or-later
"""However the paint window goes, the panels beside it and the 3D view are as wide as before it came."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from brush import close_window, draw, ellipse, fish_body, is_closed, open_window, press

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.gui.paint import window as paint_window

SAME = 3  # px


@pytest.fixture(autouse=True)
def nothing_left(monkeypatch):
    monkeypatch.setattr(preferences, "settings", lambda: Settings(correct=False, mesh_size=0.02))
    yield
    while paint_window._open:
        close_window()


def widths():
    """Of the panels in the main window and of its documents' area.

    Without FreeCAD's task panel, which is as wide as what it shows.
    """
    main = Gui.getMainWindow()
    docks = {
        dock.objectName(): dock.width()
        for dock in main.findChildren(hands.QtWidgets.QDockWidget)
        if dock.isVisible()
        and not dock.isFloating()
        and dock.parent() is main
        and dock.objectName() != "Tasks"
    }
    return {"documents": main.centralWidget().width()} | docks


def make(window):
    fish_body(window)
    hands.wait_until(window.scene.is_shown, 30)
    press("PaintSizeDone") if window.card.isVisible() else None
    press("PaintMake")
    hands.wait_until(is_closed, 60)


def put_aside_and_finish(window):
    """The window of another document's painting is finished behind it."""
    window.put_aside()
    window.finish()


def close_reveal_and_finish(window):
    window.close()
    window.reveal()
    hands.wait(0.3)
    window.finish()


WAYS = {
    "finish": lambda window: window.finish(),
    "close": lambda window: window.close(),
    "close and finish": lambda window: (window.close(), window.finish()),
    "close, open, finish": close_reveal_and_finish,
    "open twice, finish": lambda window: (window.reveal(), hands.wait(0.2), window.finish()),
    "Make it!": make,
    "another document": lambda _window: App.newDocument("Other"),
    "put aside, finish": put_aside_and_finish,
    "its document is closed": lambda window: App.closeDocument(window.doc.Name),
}


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS)
def test_all_is_as_wide_as_before(doc, way):
    hands.wait(0.5)
    before = widths()
    window = open_window()
    hands.wait(0.5)
    assert widths()["documents"] < before["documents"] - 200
    WAYS[way](window)
    hands.wait(0.8)
    assert widths() == pytest.approx(before, abs=SAME)


@pytest.mark.slow
def test_a_second_painting_takes_and_gives_the_same(doc):
    hands.wait(0.5)
    before = widths()
    seen = []
    for _ in range(3):
        window = open_window()
        draw(window.canvas, ellipse(0.5, 0.5, 0.2, 0.3))
        hands.wait(0.5)
        seen.append(widths())
        close_window()
        hands.wait(0.8)
        assert widths() == pytest.approx(before, abs=SAME)
    assert seen[1:] == [pytest.approx(seen[0], abs=SAME)] * 2
