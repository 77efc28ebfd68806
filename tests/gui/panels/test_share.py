# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon for others with the mouse: page, 3D model, picture, and the inflation as a film."""

import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.shared import animation, sharing
from BalloonWorkbench.core.tracing.picture_file import decode
from BalloonWorkbench.gui.panels.results import animation as animation_panel
from BalloonWorkbench.gui.panels.results.ground_row import GroundRow
from BalloonWorkbench.gui.qt import QtGui
from BalloonWorkbench.gui.view3d import inflation_player
from BalloonWorkbench.gui.window import macro_recorder

KINDS = {"html": b"<!DOCTYPE html>", "glb": b"glTF", "png": b"\x89PNG"}


@pytest.fixture
def made(doc):
    """A finished balloon, selected."""
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=20, correct=False)
    doc.clearUndos()
    Gui.Selection.addSelection(parts.balloon)
    return parts


@pytest.fixture
def macro(stand_in):
    """The lines that go into the macro."""
    lines = []
    stand_in.setattr(macro_recorder.Gui, "doCommand", lines.append)
    return lines


def run(name):
    Gui.runCommand(f"BalloonWorkbench_{name}")
    hands.wait_until(hands.panel_is_seen)


@pytest.mark.slow
def test_each_kind_is_written(made, macro, tmp_path, monkeypatch):
    """A folder that is a file keeps the panel open with a sentence; a file that is there is asked about."""
    monkeypatch.setattr(sharing, "_LARGE", (160, 120))
    for row, (kind, begin) in enumerate(KINDS.items()):
        run("ExportForWeb")
        hands.find("SharedKind").setCurrentIndex(row)
        hands.wait_until(lambda kind=kind: bool(hands.visible(GroundRow)) == (kind != "glb"))
        (tmp_path / "blocked").write_text("a file")
        hands.type_into(hands.find("SharedFile"), str(tmp_path / "blocked" / "mine"), confirm=False)
        hands.press("Ok")
        hands.wait_until(lambda: "blocked" in hands.find("ShareMessage").text())
        hands.type_into(hands.find("SharedFile"), str(tmp_path / "mine"), confirm=False)
        if kind == "png":
            hands.choose(hands.find("Ground"), "Transparent")
            hands.screenshot("export_for_web")
        hands.press("Ok")
        hands.wait_until(hands.panel_is_closed)
        assert (tmp_path / f"mine.{kind}").read_bytes().startswith(begin)
    assert made.balloon.Document.UndoNames == []
    lines = [line for line in macro if "BalloonWorkbench.share(" in line]
    assert len(lines) == 3
    assert lines[-1].replace("'", '"').endswith('ground="transparent")')
    run("ExportForWeb")
    hands.type_into(hands.find("SharedFile"), str(tmp_path / "mine"), confirm=False)
    hands.press("Ok")
    hands.wait_until(lambda: "is there already" in hands.find("ShareMessage").text())
    hands.press("Cancel")


def test_a_colour_or_a_photograph_is_behind_the_balloon(made, macro, tmp_path, stand_in, monkeypatch):
    """What a file cannot have is not offered; a photograph is asked for until it is there."""
    monkeypatch.setattr(sharing, "_LARGE", (160, 120))
    photograph = tmp_path / "room.png"
    photograph.write_bytes(png_bytes(np.full((30, 40, 4), (10, 20, 30, 255), np.uint8), 96.0))
    wanted = QtGui.QColor("#102030")
    stand_in.setattr(hands.QtWidgets.QColorDialog, "getColor", lambda *given: wanted)
    run("ExportForWeb")
    hands.choose(hands.find("SharedKind"), "Picture (PNG)")
    hands.choose(hands.find("Ground"), "A colour")
    hands.click(hands.find("GroundColour"))
    assert hands.find("GroundColour").text() == "#102030"
    hands.type_into(hands.find("SharedFile"), str(tmp_path / "colour"), confirm=False)
    hands.screenshot("export_ground")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert decode(tmp_path / "colour.png")[0, 0].tolist() == [16, 32, 48, 255]
    run("ExportForWeb")
    hands.choose(hands.find("SharedKind"), "Picture (PNG)")
    hands.choose(hands.find("Ground"), "Transparent")
    hands.choose(hands.find("SharedKind"), "Web page that turns the balloon (HTML)")
    assert hands.find("Ground").currentText() == "That of the page"
    hands.choose(hands.find("Ground"), "A photograph")
    hands.type_into(hands.find("SharedFile"), str(tmp_path / "page"), confirm=False)
    hands.press("Ok")
    hands.wait_until(lambda: "Choose the photograph" in hands.find("ShareMessage").text())
    hands.type_into(hands.find("GroundPicture"), str(photograph))
    assert hands.find("ShareMessage").text() == ""
    hands.screenshot("export_photograph")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert 'id="balloon-ground"' in (tmp_path / "page.html").read_text(encoding="utf-8")
    lines = [line.replace("'", '"') for line in macro if "BalloonWorkbench.share(" in line]
    assert lines[0].endswith('ground="#102030")')
    assert photograph.name in lines[1]


def test_the_inflation_is_saved(made, tmp_path, stand_in, monkeypatch):
    """The frames that were played, as a GIF; where nothing writes an MP4 a sentence says what to do."""
    for module in (inflation_player, animation_panel):
        monkeypatch.setattr(module, "FRAMES", 4)
    run("Animate")
    hands.wait_until(lambda: hands.find("SaveAnimation").isVisible())
    chosen = []
    stand_in.setattr(hands.QtWidgets.QFileDialog, "getSaveFileName", lambda *given: chosen[-1])
    monkeypatch.setattr(animation, "opencv", lambda: None)
    for answer, told in (
        ((str(tmp_path / "film"), "MP4 (*.mp4)"), "choose a GIF"),
        ((str(tmp_path / "film"), "GIF (*.gif)"), "film.gif"),
    ):
        chosen.append(answer)
        hands.click(hands.find("SaveAnimation"))
        hands.wait_until(lambda told=told: told in hands.find("AnimationMessage").text(), 60)
    assert [path.name for path in tmp_path.iterdir()] == ["film.gif"]
    assert (tmp_path / "film.gif").read_bytes().startswith(b"GIF89a")
    hands.screenshot("animate")
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
