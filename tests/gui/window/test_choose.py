# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon from picture, from the menu on: the file chooser, a draft at once, then the balloon."""

import shutil
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
from hands import QtCore, QtWidgets
from pictures import framed

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.design import draft as core_draft
from BalloonWorkbench.gui.window import file_dialogs

HEART = Path("resources/examples/pictures/heart.png").resolve()
ASK = file_dialogs.ask_for_drawing


@pytest.fixture(autouse=True)
def no_dialog():
    """Here one is expected."""


@pytest.fixture(autouse=True)
def chooser(no_file_chosen, monkeypatch):
    """FreeCAD's own chooser, and the folder of the last file as it was afterwards."""
    monkeypatch.setattr(file_dialogs, "ask_for_drawing", ASK)
    before = preferences.open_folder()
    yield
    preferences.put_open_folder(before)


def command(answer):
    """Run the command; what comes up is given to `answer` a moment later, as soon as it is there."""
    seen = []

    def look():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if isinstance(dialog, QtWidgets.QFileDialog) and not seen:
            seen.append(dialog)
            answer(dialog)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(20)
    Gui.runCommand("BalloonWorkbench_FromPicture")
    timer.stop()
    assert seen, "no chooser came"


def type_name(name):
    def answer(dialog):
        line = dialog.findChild(QtWidgets.QLineEdit)
        line.setText(str(name))
        hands.key(line, QtCore.Qt.Key_Return, "\r")

    return answer


def test_the_chooser_comes_at_once_and_the_folder_is_remembered(doc, tmp_path):
    photo = shutil.copy(HEART, tmp_path / "HEART.PNG")
    command(type_name(photo))
    hands.wait_until(hands.panel_is_seen)
    assert doc.Outline.Status == status.READY
    assert hands.find("Drawing").text() == "HEART.PNG"
    assert preferences.open_folder() == str(tmp_path)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    names = []

    def look_and_leave(dialog):
        names.extend(dialog.nameFilters())
        names.append(dialog.directory().absolutePath())
        dialog.reject()

    command(look_and_leave)
    assert names[-1] == str(tmp_path)
    assert "*.PNG" in names[0]
    assert "*.svg" in names[0]


def test_cancelled_nothing_is_made(doc):
    command(lambda dialog: hands.key(dialog, QtCore.Qt.Key_Escape))
    hands.wait(0.3)
    assert hands.panel_is_closed()
    assert doc.Objects == []
    assert doc.UndoNames == []
    App.closeDocument(doc.Name)
    command(lambda dialog: hands.key(dialog, QtCore.Qt.Key_Escape))
    assert not App.listDocuments()


def drafts():
    """Nodes of drafts in the view."""
    root = Gui.ActiveDocument.activeView().getSceneGraph()
    return [child for child in root.getChildren() if "SeparatorWithTransform" in kinds(child)]


def kinds(node):
    names = [node.getTypeId().getName().getString()]
    if hasattr(node, "getChildren") and names == ["Separator"]:
        below = [child.getTypeId().getName().getString() for child in node.getChildren()]
        if below[:2] == ["PickStyle", "Transform"]:
            names.append("SeparatorWithTransform")
    return names


def labels():
    return [label.text() for label in hands.visible(QtWidgets.QLabel)]


@pytest.mark.slow
def test_a_draft_is_shown_before_the_balloon(doc, monkeypatch):
    """About the size and volume that the fitted balloon has, in the 3D view and in the panel."""
    made = []
    draw = core_draft.draft

    def kept(*given, **named):
        made.append(draw(*given, **named))
        return made[-1]

    from BalloonWorkbench.gui.panels.balloon import draft as panel_draft

    monkeypatch.setattr(panel_draft, "draft", kept)
    with framed((1366, 768)):
        command(type_name(HEART))
        hands.wait_until(lambda: bool(drafts()), 30)
        assert not doc.Balloon.SolvedFor
        assert [text for text in labels() if text.startswith("about ")]
        hands.screenshot("picture-draft")
        hands.wait_until(lambda: doc.Pattern.Status == status.READY, 120)
        assert drafts() == []
        assert not [text for text in labels() if text.startswith("about ")]
        hands.wait(0.3)
        hands.screenshot("picture-fitted")
    sizes = 1e3 * np.ptp(made[-1].inflation.positions, axis=0) * (1, 1, 2)
    fitted = (doc.Balloon.InflatedWidth, doc.Balloon.InflatedHeight, doc.Balloon.InflatedThickness)
    assert sizes == pytest.approx([length.Value for length in fitted], rel=0.2)
    assert 1e9 * made[-1].inflation.volume == pytest.approx(
        doc.Balloon.Volume.Value, rel=0.3
    )  # how near a draft is: tests/core/design/test_draft.py
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)


@pytest.mark.parametrize("end", ["Cancel", "close"])
def test_nothing_is_left_of_a_draft(doc, end):
    Gui.activeDocument().activeView()
    command(type_name(HEART))
    hands.wait_until(lambda: bool(drafts()), 30)
    if end == "close":
        App.closeDocument(doc.Name)
        hands.wait_until(hands.panel_is_closed)
        return
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert drafts() == []
    assert doc.Objects == []
