# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each check of the users' steps sees the fault that it is for."""

import checks
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
from story import screen

QtWidgets = hands.QtWidgets


@pytest.fixture
def box():
    """A dialog of ours with a label that is as it should be."""
    dialog = QtWidgets.QDialog(Gui.getMainWindow())
    dialog.setStyleSheet("QDialog { background: white } QLabel { color: black }")
    dialog.resize(400, 300)
    label = QtWidgets.QLabel("300 mm", dialog)
    label.setGeometry(20, 20, 200, 30)
    dialog.show()
    hands.wait(0.3)
    yield dialog
    dialog.close()


def label(box):
    return box.findChild(QtWidgets.QLabel)


def faults(box):
    """What is said of this dialog alone."""
    hands.wait(0.2)
    return [fault for fault in checks.all_of(screen()) if "a command" not in fault]


def test_nothing_is_said_of_what_is_right(box):
    assert faults(box) == []


@pytest.mark.parametrize(
    "text", ["1.57e+03 mm", "see file:///a mm", "/usr/share/x mm", "nan mm", "{} mm", "0.00 mm"]
)
def test_wrong_words(box, text):
    label(box).setText(text)
    assert any(fault.startswith("words") for fault in faults(box))


def test_a_text_that_is_cut_off(box):
    label(box).setFixedWidth(20)
    assert any(fault.startswith("cut off") for fault in faults(box))


def test_a_cell_that_is_cut_off(box):
    table = QtWidgets.QTableWidget(1, 1, box)
    table.setGeometry(20, 60, 200, 100)
    table.setItem(0, 0, QtWidgets.QTableWidgetItem("123456789 mm"))
    table.show()
    table.setColumnWidth(0, 150)
    assert not any("a cell of" in fault for fault in faults(box))
    table.setColumnWidth(0, 30)
    assert any("a cell of" in fault for fault in faults(box))


def test_widgets_on_each_other(box):
    other = QtWidgets.QLabel("400 mm", box)
    other.setGeometry(60, 25, 200, 30)
    other.show()
    assert any(fault.startswith("overlap") for fault in faults(box))


def test_a_text_that_is_hardly_seen(box):
    label(box).setStyleSheet("color: #e8e8e8")
    assert any(fault.startswith("contrast") for fault in faults(box))


def test_off_the_screen(box):
    label(box).move(5000, 20)
    box.resize(6000, 300)
    assert any("off the screen" in fault for fault in faults(box))


def test_the_report_view():
    assert not list(checks.report_view())
    docks = Gui.getMainWindow().findChildren(QtWidgets.QDockWidget)
    dock = next(dock for dock in docks if dock.objectName() == "Report view")
    dock.show()
    hands.wait(0.3)
    open_now = list(checks.report_view())
    dock.hide()
    assert open_now


def test_results_on_each_other():
    from sketches import rectangle

    from BalloonWorkbench.app.document import create

    doc = App.newDocument("Two")
    parts = create.balloon_from_sketch(doc, rectangle(doc, 90, 60), mesh_size=12, correct=False)
    assert not list(checks.lying_on_each_other())
    parts.pattern.Placement.Base = App.Vector(-60, 0, 0)
    assert list(checks.lying_on_each_other())


def test_contrast_is_that_of_wcag():
    grey = np.full((10, 10, 3), 255, np.uint8)
    grey[3:6] = 119  # #777777 on white: 4.48
    assert checks.contrast(grey) == pytest.approx(4.48, abs=0.01)
