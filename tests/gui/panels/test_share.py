# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon for others with the mouse: page, 3D model, picture, and the inflation as a film."""

import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.shared import animation, sharing
from BalloonWorkbench.gui.panels.results import animation as animation_panel
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


def test_each_kind_is_written(made, macro, tmp_path, monkeypatch):
    """A folder that is a file keeps the panel open with a sentence; a file that is there is asked about."""
    monkeypatch.setattr(sharing, "_LARGE", (160, 120))
    for row, (kind, begin) in enumerate(KINDS.items()):
        run("ExportForWeb")
        hands.find("SharedKind").setCurrentIndex(row)
        assert hands.find("TransparentGround").isVisible() == (kind == "png")
        (tmp_path / "blocked").write_text("a file")
        hands.type_into(hands.find("SharedFile"), str(tmp_path / "blocked" / "mine"), confirm=False)
        hands.press("Ok")
        hands.wait_until(lambda: "blocked" in hands.find("ShareMessage").text())
        hands.type_into(hands.find("SharedFile"), str(tmp_path / "mine"), confirm=False)
        if kind == "png":
            hands.tick(hands.find("TransparentGround"))
            hands.screenshot("export_for_web")
        hands.press("Ok")
        hands.wait_until(hands.panel_is_closed)
        assert (tmp_path / f"mine.{kind}").read_bytes().startswith(begin)
    assert made.balloon.Document.UndoNames == []
    lines = [line for line in macro if "BalloonWorkbench.share(" in line]
    assert len(lines) == 3
    assert lines[-1].endswith("transparent=True)")
    run("ExportForWeb")
    hands.type_into(hands.find("SharedFile"), str(tmp_path / "mine"), confirm=False)
    hands.press("Ok")
    hands.wait_until(lambda: "is there already" in hands.find("ShareMessage").text())
    hands.press("Cancel")


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
