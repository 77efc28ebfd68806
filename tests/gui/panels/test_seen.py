# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel says is seen: it is scrolled to, rows have their heights, what is left out is a tooltip."""

import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo, fit_heights

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets


@pytest.fixture
def low_window():
    """FreeCAD's window as on a small laptop."""
    main = Gui.getMainWindow()
    before = main.geometry()
    main.showNormal()
    main.setGeometry(0, 0, 1000, 600)
    hands.wait(0.3)
    yield
    main.setGeometry(before)
    hands.wait(0.2)


def test_why_nothing_was_written_is_scrolled_to(made, low_window, tmp_path):
    Gui.Selection.addSelection(made.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    hands.choose(hands.find("Machine"), "LightBurn (laser)")
    hands.type_into(hands.find("Bed"), "50 x 50 mm")
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    message = hands.find("Message")
    hands.wait(0.2)
    assert message.visibleRegion().isEmpty(), "the window is too high for this test"
    hands.press("Ok")
    hands.wait_until(lambda: bool(message.text()), 10)
    hands.wait_until(lambda: message.visibleRegion().boundingRect().height() >= message.height() - 2, 5)
    hands.screenshot("refused_and_seen")


def test_rows_have_their_heights_at_once(opened):
    """Not a turn of the event loop for each level of widgets later."""
    pages = hands.find("Steps")
    pages.setCurrentIndex(1)
    page = pages.currentWidget()
    hands.wait(0.3)
    for text in ("some words more " * 60, ""):
        page.welding.setText(text)
        page.welding.setVisible(True)
        fit_heights()
        assert page.height() == pytest.approx(page.layout().totalSizeHint().height(), abs=40)
        assert page.height() >= page.layout().minimumSize().height()


def test_the_whole_of_an_entry_is_in_the_tooltip(opened):
    choice = hands.find("Film")
    hands.show_tab(choice)
    assert isinstance(choice, ElidedCombo)
    choice.setFixedWidth(90)
    hands.wait(0.2)
    at = choice.rect().center()
    event = QtGui.QHelpEvent(QtCore.QEvent.ToolTip, at, choice.mapToGlobal(at))
    QtWidgets.QApplication.sendEvent(choice, event)
    assert choice.currentText() in QtWidgets.QToolTip.text()
    assert choice.toolTip() in QtWidgets.QToolTip.text()
    QtWidgets.QToolTip.hideText()
