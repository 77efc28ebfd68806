# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork, layout on film and assembly sheet with the mouse and the keyboard."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create, kinds
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.remnant import read_remnants


@pytest.fixture
def made(doc, tmp_path):
    """A finished balloon, selected, and a picture: blue left, yellow right."""
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=12, correct=False)
    pixels = np.full((60, 80, 4), (20, 60, 220, 255), np.uint8)
    pixels[:, 40:] = (240, 200, 20, 255)
    (tmp_path / "two colours.png").write_bytes(png_bytes(pixels, 100.0))
    doc.clearUndos()
    Gui.Selection.addSelection(parts.balloon)
    return parts


def run(name):
    Gui.runCommand(f"BalloonWorkbench_{name}")
    hands.wait_until(hands.panel_is_seen)


def colours_in_view():
    """Parts of the view's pixels that are blue and yellow."""
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.4)
    path = hands.SCREENSHOTS / "artwork_view.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    Gui.activeDocument().activeView().saveImage(str(path), 320, 240, "White")
    image = hands.QtGui.QImage(str(path))
    seen = [image.pixelColor(x, y) for x in range(0, 320, 2) for y in range(0, 240, 2)]
    blue = sum(colour.blue() > 150 and colour.red() < 90 for colour in seen)
    yellow = sum(colour.red() > 180 and colour.green() > 140 and colour.blue() < 90 for colour in seen)
    return blue / len(seen), yellow / len(seen)


@pytest.mark.slow
def test_artwork_is_chosen_shown_written_and_undone(made, tmp_path, stand_in):
    run("Artwork")
    assert "no picture" in hands.find("ArtworkMessage").text()
    assert not hands.find("WriteArtwork").isEnabled()
    hands.type_into(hands.find("Picture"), str(tmp_path / "nowhere.png"), confirm=False)
    hands.find("Picture").editingFinished.emit()
    assert "nowhere.png" in hands.find("ArtworkMessage").text()
    hands.type_into(hands.find("Picture"), str(tmp_path / "two colours.png"), confirm=False)
    hands.find("Picture").editingFinished.emit()
    hands.wait_until(lambda: hands.find("WriteArtwork").isEnabled())
    art = artwork.of_balloon(made.balloon)
    assert art.Status == status.READY
    art.Resolution = 40.0
    marks = hands.find("MarksFor")
    assert marks.currentText() == "Crosses, by eye"
    names = [marks.itemText(row) for row in range(marks.count())]
    for title, width in (("Silhouette from Inkscape", 210.0), ("Zünd Cut Center (flat bed)", None)):
        marks.setCurrentIndex(names.index(title))
        marks.activated.emit(marks.currentIndex())
        assert status.is_ready(art)
        front, _ = artwork.sheets(art)
        assert width is None or float(np.ptp(front.pattern.page, axis=0)[0]) == pytest.approx(1e-3 * width)
    assert art.MarksFor == "zuend"
    stand_in.setattr(
        hands.QtWidgets.QFileDialog, "getExistingDirectory", lambda *given: str(tmp_path / "prints")
    )
    hands.click(hands.find("WriteArtwork"))
    hands.wait_until(lambda: hands.find("ArtworkMessage").text())
    assert len(list((tmp_path / "prints").iterdir())) >= 8
    cut = (tmp_path / "prints" / "print-front-pattern-zuend_mm.dxf").read_text(encoding="cp1252")
    assert cut.count("Register") >= 5
    assert hands.find("ArtworkMessage").text() == f"Files written to {tmp_path / 'prints'}"
    for obj in (made.outline, made.pattern, art):
        obj.ViewObject.Visibility = False
    Gui.activeDocument().activeView().viewTop()
    for shown, hidden in ((made.balloon, art), (art, made.balloon)):  # on the balloon, and as it is printed
        shown.ViewObject.Visibility, hidden.ViewObject.Visibility = True, False
        blue, yellow = colours_in_view()
        assert blue > 0.015
        assert yellow > 0.015
    hands.screenshot("artwork")
    # another picture for the back: blue below, and from above as before
    blues = np.full((60, 80, 4), (20, 60, 220, 255), np.uint8)
    (tmp_path / "blue.png").write_bytes(png_bytes(blues, 100.0))
    art.BackPicture = str(tmp_path / "blue.png")
    App.ActiveDocument.recompute()
    made.balloon.ViewObject.Visibility, art.ViewObject.Visibility = True, False
    for view, least, most in (("viewBottom", 0.0, 0.001), ("viewTop", 0.015, 1.0)):
        getattr(Gui.activeDocument().activeView(), view)()
        blue, yellow = colours_in_view()
        assert blue > 0.015
        assert least <= yellow <= most
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert art.ViewObject.Proxy.icon == "artwork"
    doc = App.ActiveDocument
    assert doc.UndoCount == 1
    doc.undo()
    assert artwork.of_balloon(made.balloon) is None


def test_cancel_takes_the_artwork_back(made):
    run("Artwork")
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert artwork.of_balloon(made.balloon) is None


@pytest.mark.slow
def test_layout_on_film(made, tmp_path, stand_in):
    """Six pieces on a roll; refused where they do not fit; offered for export."""
    stand_in.setattr(nesting, "PACKAGE", "no_such_package")
    run("Nest")
    sheet = next(obj for obj in App.ActiveDocument.Objects if kinds.is_film_sheet(obj))
    hands.find("Balloons").setValue(3)
    hands.find("FilmWidth").setProperty("rawValue", 60.0)
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: "fit" in hands.find("NestMessage").text())
    hands.find("FilmWidth").setProperty("rawValue", 400.0)
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: "used" in hands.find("NestResult").text())
    assert "Pieces: 6," in hands.find("NestResult").text()
    hands.type_into(hands.find("Remnant"), str(tmp_path / "none.json"))
    assert "There is no file" in hands.find("NestMessage").text()
    left = tmp_path / "left.json"
    left.write_text('{"unit": "mm", "outer": [[0, 0], [900, 0], [900, 450], [0, 450]]}')
    hands.type_into(hands.find("Remnant"), str(left))
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: "900 x 450 mm" in hands.find("NestResult").text())
    hands.screenshot("nest")
    kept = tmp_path / "kept.json"
    chosen = str(kept.with_suffix("")), "Remnants (*.json)"  # typed without its ending
    stand_in.setattr(hands.QtWidgets.QFileDialog, "getSaveFileName", staticmethod(lambda *_: chosen))
    hands.click(hands.find("KeepRemnant"))
    hands.wait_until(kept.is_file)
    assert str(kept) in hands.find("NestMessage").text()
    (rest,) = read_remnants(kept)[:1]
    assert 0.0 < rest.area.area < 0.9 * 0.45
    hands.click(hands.find("KeepRemnant"))
    hands.wait_until(lambda: "kept.json is there already" in hands.find("NestMessage").text())
    kept.unlink()
    hands.find("Balloons").setValue(2)
    hands.click(hands.find("KeepRemnant"))
    hands.wait_until(lambda: "older" in hands.find("NestMessage").text())
    hands.find("Balloons").setValue(3)
    hands.find("Remnant").clear()
    hands.type_into(hands.find("Remnant"), " ")
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: "400 mm" in hands.find("NestResult").text())
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert sheet.Status == status.READY
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(sheet)
    run("ExportPattern")
    assert hands.find("Pattern").currentText() == sheet.Label
    hands.type_into(hands.find("File"), str(tmp_path / "nested.dxf"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert list(tmp_path.glob("nested*"))


def test_nesting_library_works_beside_the_window(made):
    """The search runs in a thread while the window lives."""
    if nesting.importlib.util.find_spec(nesting.PACKAGE) is None:
        pytest.skip("the nesting library is not installed")
    run("Nest")
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: "used" in hands.find("NestResult").text())
    assert not hands.find("NestMessage").text()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert not [obj for obj in App.ActiveDocument.Objects if kinds.is_film_sheet(obj)]


def test_assembly_sheet(made, tmp_path):
    run("AssemblySheet")

    def tells(start, part=""):
        texts = [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]
        return any(text.startswith(start) and part in text for text in texts)

    hands.wait_until(lambda: tells("Helium lifts"), 30)  # a thread counts
    assert tells("", "margin 2")
    hands.screenshot("assembly_sheet")
    hands.type_into(hands.find("AssemblyFile"), str(tmp_path / "no folder" / "x" / "sheet"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (tmp_path / "no folder" / "x" / "sheet.pdf").read_bytes().startswith(b"%PDF")
