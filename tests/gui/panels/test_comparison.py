# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare with a photograph: marked, compared, saved and fitted with the mouse; nonsense is told there."""

import json
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
from drawn_pictures import png
from photographs import photograph

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.core.as_made.comparison import with_rim
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.gui.window import macro_recorder

PIXEL = 0.0004  # m


@pytest.fixture
def photo(made, tmp_path):
    """The balloon with weld and allowance, turned, 2 % larger than it was simulated."""
    inflation, own = film_result.stored(made.balloon)
    rim = own.seal_width + made.pattern.Allowance.Value / 1000.0
    loop = 1.02 * with_rim(silhouette(inflation), rim).outer
    path = tmp_path / "photo.png"
    path.write_bytes(png(photograph([loop], pixel=PIXEL, size=(480, 400), turn=20.0, noise=3.0)))
    return str(path)


@pytest.fixture
def own_films(tmp_path, monkeypatch):
    monkeypatch.setattr(film, "own_folder", lambda: tmp_path / "films")
    return tmp_path / "films"


def open_panel(made):
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_Compare")
    hands.wait_until(hands.panel_is_seen, 5)


def fill(**texts):
    for name, text in texts.items():
        hands.type_into(hands.find(name), text, confirm=False)


def compare():
    hands.click(hands.find("Compare"))
    hands.wait_until(lambda: hands.find("Compare").isEnabled(), 60)


def test_a_length_is_marked_and_the_balloon_compared(made, photo, tmp_path, stand_in):
    lines = []
    open_panel(made)
    hands.type_into(hands.find("Photo"), photo)
    hands.click(hands.find("MarkLength"))
    view = hands.find("MarkedPicture")
    hands.wait_until(view.isVisible)
    for x, y in ((40.0, 200.0), (400.0, 200.0), (440.0, 200.0)):  # the third one moves the second
        at = view.mapFromScene(x, y)
        hands.drag(view.viewport(), (at.x(), at.y()), (at.x(), at.y()), steps=1)
    hands.screenshot("compare_marks")
    assert float(hands.find("PhotoPixels").text()) == pytest.approx(400.0, abs=2.0)
    fill(PhotoPixels="400", PhotoLength="160 mm")
    compare()
    hands.wait_until(lambda: not hands.message().startswith("Comparing"))
    hands.wait(0.2)
    hands.screenshot("compare")
    assert hands.find("ComparedPicture").isVisible()
    assert "Difference: " in hands.message()
    stand_in.setattr(macro_recorder.Gui, "doCommand", lines.append)
    stand_in.setattr(
        hands.QtWidgets.QFileDialog, "getExistingDirectory", lambda *_asked: str(tmp_path / "out")
    )
    hands.click(hands.find("SaveComparison"))
    written = json.loads((tmp_path / "out" / "compare.json").read_text())
    width, height = written["expected"]["width_mm"], written["expected"]["height_mm"]
    assert written["seen"]["width_mm"] == pytest.approx(1.02 * width, abs=0.3)
    assert written["difference"]["mean_mm"] == pytest.approx(0.01 * (width + height) / 2, rel=0.3)
    for path in (tmp_path / "out").iterdir():
        path.unlink()
    exec("\n".join(lines), {"App": App})
    assert json.loads((tmp_path / "out" / "compare.json").read_text()) == written
    hands.press("Close")


@pytest.mark.slow
def test_the_fitted_film_is_kept_and_gets_the_mean_of_photographs(made, photo, own_films, stand_in):
    lines = []
    stand_in.setattr(macro_recorder, "call", lambda *words, **named: lines.append((words, named)))
    open_panel(made)
    fill(Photo=photo, PhotoPixels="400", PhotoLength="160 mm")
    hands.tick(hands.find("FitFilm"))
    compare()
    assert "tretch of the film" in hands.message() or "stretch of" in hands.message()
    hands.click(hands.find("KeepFilm"))
    (kept,) = own_films.iterdir()
    assert kept.stem == f"{made.balloon.Film}-as-made" in film.known_films()
    assert json.loads(kept.read_text())["as_made"]["stretch"] == pytest.approx(0.02, abs=0.01)
    assert lines[0][0][0] == "fit_film"
    first = json.loads(kept.read_text())
    other = dict(first["as_made"], stretch=first["as_made"]["stretch"] + 0.01)
    del other["photographs"]
    first["as_made"]["photographs"] = {"other.jpg": other}
    kept.write_text(json.dumps(first))
    compare()
    hands.screenshot("compare_fitted")
    hands.click(hands.find("KeepFilm"))
    both = json.loads(kept.read_text())["as_made"]
    assert sorted(both["photographs"]) == sorted(["other.jpg", Path(photo).name])
    assert both["stretch"] == pytest.approx(first["as_made"]["stretch"] + 0.005, abs=0.001)
    kept.write_text("precious")
    compare()
    hands.click(hands.find("KeepFilm"))
    assert kept.name in hands.message()
    assert kept.read_text() == "precious"
    hands.tick(hands.find("ReplaceFilm"))
    hands.click(hands.find("KeepFilm"))
    assert list(json.loads(kept.read_text())["as_made"]["photographs"]) == [Path(photo).name]
    hands.press("Close")


@pytest.mark.slow
def test_what_makes_no_sense_is_told_in_the_panel(made, photo, tmp_path):
    empty = tmp_path / "empty.png"
    empty.write_bytes(png(np.full((200, 300, 4), 220, np.uint8)))
    (tmp_path / "text.png").write_text("no picture")
    open_panel(made)
    for texts, sentence in (
        ({}, "Choose a photograph first"),
        ({"Photo": str(tmp_path / "none.png")}, "Mark a length in the picture"),
        ({"PhotoPixels": "400", "PhotoLength": "160"}, "none.png"),
        ({"Photo": str(tmp_path / "text.png")}, "text.png"),
        ({"Photo": str(empty)}, "shape"),
        ({"Photo": photo, "PhotoPixels": "0"}, "has no length"),
        ({"PhotoPixels": "many"}, "cannot be used"),
        ({"PhotoPixels": "400", "PhotoLength": "3 m"}, "check the scale"),
        ({"PhotoLength": "160", "PhotoRim": "-3"}, "The rim is"),
    ):
        fill(**texts)
        compare()
        assert sentence in hands.message(), (texts, hands.message())
        assert not hands.find("SaveComparison").isVisible()
    hands.screenshot("compare_refused")
    hands.press("Close")


@pytest.mark.works_out
def test_it_can_be_stopped_and_a_closed_document_closes_it(made, photo):
    open_panel(made)
    fill(Photo=photo, PhotoPixels="400", PhotoLength="160 mm")
    with hands.work_held():
        hands.click(hands.find("Compare"))
        assert not hands.find("Compare").isEnabled()
        hands.wait_until(lambda: hands.visible(hands.QtWidgets.QProgressBar), 5)
        hands.key(hands.find("Compare"), hands.QtCore.Qt.Key_Escape)
        hands.wait_until(lambda: hands.find("Compare").isEnabled(), 20)
    assert hands.message() == "Stopped."
    with hands.work_held():
        hands.click(hands.find("Compare"))
        App.closeDocument(made.balloon.Document.Name)
        hands.wait_until(hands.panel_is_closed, 10)
