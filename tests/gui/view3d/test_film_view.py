# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown of a balloon: its film, results as colours, the drawing over it, its inflation."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.app.engine import maker
from BalloonWorkbench.core.results import colour_map
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.view3d import film_map

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets


@pytest.fixture(autouse=True)
def fitted(made):
    """The balloon in the middle of the view, without its pattern."""
    made.pattern.ViewObject.Visibility = False
    view().viewTop()
    hands.wait(0.3)
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.1)


def view():
    return Gui.activeDocument().activeView()


def picture(tmp_path, background="White"):
    """The 3D view (h, w, 3)."""
    hands.wait(0.05)
    path = tmp_path / "view.png"
    view().saveImage(str(path), 600, 400, background)
    return pixels(hands.QtGui.QImage(str(path)))[..., :3].astype(int)


def middle(image):
    return np.median(image[180:220, 280:320].reshape(-1, 3), axis=0)


def legend(image):
    """The corner in which the legend stands."""
    return image[:300, :200]


def hues(image):
    """How many of the scale's ten colours appear, by hue and not by shade."""
    stops = colour_map.colours(np.linspace(0, 1, 10)).astype(float)
    found = image.reshape(-1, 3).astype(float)
    found = found[np.ptp(found, axis=1) > 40]
    found = found / np.linalg.norm(found, axis=1, keepdims=True)
    stops = stops / np.linalg.norm(stops, axis=1, keepdims=True)
    return int(((found @ stops.T > 0.995).sum(axis=0) > 5).sum())


def test_foil_is_red_and_shiny(made, tmp_path):
    image = picture(tmp_path)
    film = image[100:300, 150:450].reshape(-1, 3)
    red = (film[:, 0] > 1.8 * film[:, 1]) & (film[:, 0] > 1.8 * film[:, 2])
    assert red.mean() > 0.4
    inside = image[120:280, 200:400].reshape(-1, 3)
    assert (inside.min(axis=1) > 200).any()  # a window is mirrored
    assert inside.max(axis=1).min() < 170


LOOKS = {
    "kraft-paper": lambda rgb: rgb[0] > rgb[1] > rgb[2] and rgb[0] > 1.4 * rgb[2],
    "bopp-foil": lambda rgb: np.ptp(rgb) < 40,
    "pe": lambda rgb: rgb.min() > 150,
}


def test_film_looks_like_itself(made, tmp_path):
    for film, is_like in LOOKS.items():
        made.balloon.Film = film
        assert is_like(middle(picture(tmp_path))), film


def test_clear_film_is_seen_through(made, tmp_path):
    made.balloon.Film = "pe"
    assert np.abs(middle(picture(tmp_path, "White")) - middle(picture(tmp_path, "Black"))).max() > 60
    made.balloon.Film = "kraft-paper"
    assert np.abs(middle(picture(tmp_path, "White")) - middle(picture(tmp_path, "Black"))).max() < 5


def test_colour_can_be_chosen(made, tmp_path):
    made.balloon.ViewObject.ShapeColor = (0.1, 0.3, 0.9)
    red, _, blue = middle(picture(tmp_path))
    assert blue > red + 20


OF_TWO_PANELS = [kind for kind in colour_map.KINDS if kind not in (colour_map.STATE, colour_map.DISTANCE)]


def test_map_has_a_legend(made, tmp_path):
    assert hues(legend(picture(tmp_path))) == 0
    for kind in OF_TWO_PANELS:
        made.balloon.ViewObject.ColourMap = kind
        image = picture(tmp_path)
        assert hues(legend(image)) >= 8, kind
        assert hues(image[:, 200:]) >= 2, kind  # a good fit is far off at few places
        assert made.balloon.ViewObject.DisplayMode == "Colour map"
        made.balloon.ViewObject.ColourMap = "Off"


def test_legend_stays_while_the_view_turns(made, tmp_path):
    made.balloon.ViewObject.ColourMap = "Thickness"
    from_above = picture(tmp_path)
    view().viewIsometric()
    hands.wait(0.5)
    from_aside = picture(tmp_path)
    title = np.s_[10:36, 10:170]
    ink = from_above[title].max(axis=2) < 90
    assert ink.sum() > 200
    assert (from_aside[title].max(axis=2) < 110)[ink].mean() > 0.97
    assert not np.array_equal(from_above[:, 200:], from_aside[:, 200:])


def test_legend_can_be_read_on_any_background(made, tmp_path):
    made.balloon.ViewObject.ColourMap = "Thickness"
    for background in ("White", "Black"):
        paper = legend(picture(tmp_path, background))[25:120, 70:85].reshape(-1, 3)
        assert np.percentile(paper, 95) > 190, background
        assert paper.min() < 90, background


def test_legend_does_not_shrink_what_fits_into_the_view(made):
    view().fitAll()
    height = view().getCameraNode().height.getValue()
    made.balloon.ViewObject.ColourMap = "Tension"
    made.balloon.ViewObject.CompareOutlines = True
    hands.wait(0.1)
    view().fitAll()
    assert view().getCameraNode().height.getValue() == pytest.approx(height, rel=0.01)


def test_off_brings_the_film_back(made, tmp_path):
    before = picture(tmp_path)
    made.balloon.ViewObject.DisplayMode = "Flat Lines"
    made.balloon.ViewObject.ColourMap = "Strain"
    hands.wait(0.05)
    made.balloon.ViewObject.ColourMap = "Off"
    assert made.balloon.ViewObject.DisplayMode == "Flat Lines"
    made.balloon.ViewObject.DisplayMode = "Colour map"
    assert made.balloon.ViewObject.ColourMap == "Tension"
    made.balloon.ViewObject.DisplayMode = "Film"
    assert made.balloon.ViewObject.ColourMap == "Off"
    assert np.abs(picture(tmp_path) - before).mean() < 0.5


def test_map_follows_and_survives(made, tmp_path):
    made.balloon.ViewObject.ColourMap = "Thickness"
    made.balloon.ViewObject.CompareOutlines = True
    before = picture(tmp_path)
    made.outline.Source[0].setDatum("Width", App.Units.Quantity("140 mm"))
    made.balloon.Document.recompute()
    view().fitAll()
    changed = picture(tmp_path)
    assert np.abs(legend(changed) - legend(before)).max() > 60
    doc, path = made.balloon.Document, str(tmp_path / "map.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    hands.wait(0.2)
    assert again.Balloon.ViewObject.ColourMap == "Thickness"
    assert again.Balloon.ViewObject.CompareOutlines
    view().viewTop()
    hands.wait(0.5)
    view().fitAll()
    opened = picture(tmp_path)
    assert np.abs(legend(opened) - legend(changed)).mean() < 1.0
    assert hues(opened[:, 200:]) >= 6


def test_stale_map_says_so(made, tmp_path):
    made.balloon.ViewObject.ColourMap = "Tension"
    before = legend(picture(tmp_path))
    made.balloon.Live = False
    made.balloon.Pressure = 4
    made.balloon.Document.recompute()
    assert made.balloon.Status.startswith(status.STALE + "Pressure")
    after = legend(picture(tmp_path))
    red = (after[..., 0] > after[..., 2] + 60) & (after[..., 0] > after[..., 1] + 60)
    assert red.sum() > 20
    assert not ((before[..., 0] > before[..., 2] + 60) & (before[..., 0] > before[..., 1] + 60)).any()


def test_tension_shows_the_weakest_place(made, monkeypatch):
    """Of film and weld, by the same loads as the safe pressure; not the triangle with the largest tension."""
    from pivy import coin

    shown = []

    def label(place, text):
        shown.append((np.array(place), text))
        return coin.SoSeparator()

    monkeypatch.setattr(film_map, "label_node", label)
    safe = maker.safety_of(made.balloon)
    assert film_map.map_nodes(made.balloon, "Tension")
    ((place, text),) = shown
    assert place == pytest.approx(1000.0 * safe.place)
    assert text == f"{safe.weakest} {number_text(safe.load.value)} N/m"
    assert maker.numbers(parts_of(made.balloon), exact=False).safety.safe_pressure == safe.safe_pressure


def test_what_the_film_can_bear_is_worked_out_beside_the_window(made, monkeypatch):
    """For many panels it takes many seconds: the map is there at once, and what is told is never older."""
    told, show = [], film_map.legend_node
    monkeypatch.setattr(
        film_map,
        "legend_node",
        lambda obj, legend, place: told.append(legend.notes) or show(obj, legend, place),
    )
    made.balloon.Pressure = 0.7
    made.balloon.Document.recompute()
    with hands.work_held():
        made.balloon.ViewObject.ColourMap = "Tension"
        hands.wait_until(lambda: told)
        hands.wait(0.2)
        assert told[-1][-1] == "safe to: is being worked out"
        made.balloon.Pressure = 0.8  # what is being worked out belongs to the pressure before
        made.balloon.Document.recompute()
    hands.wait_until(lambda: "margin" in told[-1][-1])
    margin = number_text(maker.safety_of(made.balloon).margin)
    assert told[-1][-1].endswith(f"margin {margin}")
    made.balloon.ViewObject.ColourMap = "Strain"
    made.balloon.ViewObject.ColourMap = "Tension"
    hands.wait(0.1)
    assert "margin" in told[-1][-1]  # known by now


def test_drawing_is_compared_with_the_silhouette(made, tmp_path):
    made.balloon.ViewObject.CompareOutlines = True
    image = picture(tmp_path)
    blue = (image[..., 2] > image[..., 0] + 100) & (image[..., 2] > 140)
    orange = (image[..., 0] > image[..., 2] + 150) & (image[..., 1] > 120) & (image[..., 1] < 190)
    assert blue[:300].sum() > 200
    assert orange[:300].sum() > 200
    made.balloon.ViewObject.Visibility = False
    assert picture(tmp_path).min() > 200 or not blue[:300].all()
    made.balloon.ViewObject.Visibility = True
    made.balloon.ViewObject.CompareOutlines = False
    again = picture(tmp_path)
    assert not ((again[..., 2] > again[..., 0] + 100) & (again[..., 2] > 140)).any()


def test_panel_chooses_and_cancel_takes_back(made):
    Gui.runCommand("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    assert made.balloon.ViewObject.ColourMap == "Tension"
    combo = hands.find("ColourMap")
    combo.setFocus()
    hands.key(combo, QtCore.Qt.Key_Down)
    assert made.balloon.ViewObject.ColourMap == "Wrinkles"
    hands.click(hands.find("CompareOutlines"), x=8)
    assert made.balloon.ViewObject.CompareOutlines
    hands.screenshot("colour-map")
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert made.balloon.ViewObject.ColourMap == "Off"
    assert made.balloon.ViewObject.DisplayMode == "Film"
    assert not made.balloon.ViewObject.CompareOutlines
    Gui.runCommand("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert made.balloon.ViewObject.ColourMap == "Tension"


def test_balloon_is_picked_in_the_view(made):
    hands.wait(0.2)
    width, height = view().getSize()
    info = view().getObjectInfo((width // 2, height // 2))
    assert info is not None
    assert info["Object"] == "Balloon"


@pytest.mark.slow
def test_inflation_is_played(made, tmp_path):
    film = picture(tmp_path)
    Gui.runCommand("BalloonWorkbench_Animate")
    hands.wait_until(lambda: hands.panel_is_seen() and hands.find("Frame").isVisible())
    slider, play = hands.find("Frame"), hands.find("Play")
    at = slider.value()
    hands.wait_until(lambda: slider.value() > at + 3)
    hands.click(play)
    assert not play.isChecked()
    assert "frame" in hands.find("FrameTold").text()
    share = slider.value() / slider.maximum()
    handle = 6 + share * (slider.width() - 12)
    hands.drag(slider, (handle, slider.height() / 2), (0, slider.height() / 2))
    assert slider.value() == 0
    view().viewFront()
    hands.wait(0.5)
    flat = (picture(tmp_path) < 240).any(axis=(1, 2)).sum()
    hands.drag(slider, (6, slider.height() / 2), (slider.width(), slider.height() / 2))
    assert slider.value() == slider.maximum()
    round_ = (picture(tmp_path) < 240).any(axis=(1, 2)).sum()
    assert round_ > 4 * flat
    hands.screenshot("animation")
    view().viewTop()
    hands.wait(0.5)
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
    view().fitAll()
    assert np.abs(picture(tmp_path) - film).mean() < 1.0
    assert made.balloon.Document.UndoNames == []


def test_animation_is_left_while_it_computes(made):
    made.balloon.MeshSize = 4
    made.balloon.Document.recompute()
    Gui.runCommand("BalloonWorkbench_Animate")
    hands.wait_until(hands.panel_is_seen)
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed, 5)


def test_animation_ends_with_its_balloon(made):
    Gui.runCommand("BalloonWorkbench_Animate")
    hands.wait_until(lambda: hands.panel_is_seen() and hands.find("Frame").isVisible())
    made.balloon.Document.removeObject("Pattern")
    hands.wait_until(hands.panel_is_closed, 5)


def test_legends_of_two_balloons_stand_beside_each_other(made, tmp_path):
    doc = made.balloon.Document
    other = create.balloon_from_sketch(doc, sketches.rectangle(doc, 60, 40), mesh_size=10, correct=False)
    for parts in (made, other):
        parts.balloon.ViewObject.ColourMap = colour_map.STATE
    hands.wait(0.2)
    assert papers(picture(tmp_path, "Black")) == 2
    hands.screenshot("two-legends")
    made.balloon.ViewObject.Visibility = False
    hands.wait(0.2)
    assert papers(picture(tmp_path, "Black")) == 1


def papers(image):
    """Sheets of paper along the upper edge of a dark view."""
    bright = image[12:16].mean(axis=(0, 2)) > 150
    return int((np.diff(bright.astype(int)) > 0).sum())


def test_closed_before_it_is_drawn_and_opened_again(rectangle_file, capsys):
    """The one of the same name is another one."""
    App.closeDocument(App.openDocument(str(rectangle_file)).Name)
    doc = App.openDocument(str(rectangle_file))
    hands.wait(0.2)
    assert doc.Balloon.ViewObject.DisplayMode == "Film"
    assert "Error" not in capsys.readouterr().err
