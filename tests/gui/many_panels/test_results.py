# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of balloons of many panels in the window: colours with a legend, the inflation, what is printed."""

import math

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import Part
import pytest
import sketches
from drawn_pictures import png
from pivy import coin

import BalloonWorkbench
from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.gui.view3d.inflation_player import FRAMES, request_of

FACES = [f"Face{number}" for number in range(1, 7)]
EDGE = 100.0


@pytest.fixture
def cube(doc):
    box = doc.addObject("Part::Box", "Cube")
    box.Length = box.Width = box.Height = EDGE
    doc.recompute()
    made = BalloonWorkbench.from_panels(doc, [(box, FACES)], mesh_size=20, opening_at="Cube.Face1.Edge1")
    assert made.balloon.Status == status.READY
    for obj in doc.Objects:
        obj.ViewObject.Visibility = obj == made.balloon
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    return made


def run(command, balloon):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(balloon)
    Gui.runCommand(f"BalloonWorkbench_{command}")
    hands.wait_until(hands.panel_is_seen)


def nodes(root, kind):
    """All nodes of a type that the balloon shows."""
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(root)
    return [path.getTail() for path in search.getPaths()]


def test_colours_and_their_legend(cube):
    view = cube.balloon.ViewObject
    run("ColourMap", cube.balloon)
    choice = hands.find("ColourMap")
    offered = [choice.itemData(k) for k in range(choice.count())]
    assert offered == ["Off", "Tension", "Wrinkles", "Film state", "Strain"]
    assert not hands.find("CompareOutlines").isVisible()
    for kind in offered[1:]:
        choice.setCurrentIndex(offered.index(kind))
        hands.wait(0.2)
        assert view.ColourMap == kind
        assert view.DisplayMode == "Colour map"
        hands.screenshot(f"cube-{kind}")
        assert nodes(view.RootNode, coin.SoIndexedFaceSet)
    view.ColourMap = "Thickness"  # by a macro: nothing to be shown, and nothing breaks
    hands.wait(0.2)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


@pytest.mark.slow
def test_how_far_gores_are_from_their_profile(doc):
    arc = Part.ArcOfCircle(
        Part.Circle(App.Vector(), App.Vector(0, 0, 1), 100.0), -0.5 * math.pi, 0.5 * math.pi
    )
    made = BalloonWorkbench.from_profile(doc, sketches.sketch(doc, arc, name="Half"), gores=6, mesh_size=25)
    view = made.balloon.ViewObject
    run("ColourMap", made.balloon)
    choice = hands.find("ColourMap")
    offered = [choice.itemData(k) for k in range(choice.count())]
    assert offered[-1] == "Distance" and "Residual" not in offered
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    choice.setCurrentIndex(offered.index("Distance"))
    hands.wait(0.2)
    assert view.ColourMap == "Distance"
    assert nodes(view.RootNode, coin.SoTexture2)
    hands.screenshot("ball-distance")
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


@pytest.mark.slow
def test_the_inflation_is_played(cube):
    run("Animate", cube.balloon)
    hands.wait_until(lambda: hands.find("Play").isVisible(), 120)
    hands.find("Play").setChecked(False)
    slider = hands.find("Frame")
    for number in (0, FRAMES // 2, FRAMES - 1):
        slider.setValue(number)
        hands.wait(0.1)
        hands.screenshot(f"cube-frame-{number}")
    assert f"frame {FRAMES} of {FRAMES}" in hands.find("FrameTold").text()
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)


def test_frames_end_in_the_balloon_that_is_shown(cube):
    strip = request_of(cube.balloon).solve(lambda _fraction, _text: True)
    low, high = strip.positions[-1].min(axis=0), strip.positions[-1].max(axis=0)
    shown = np.array([tuple(point) for point in cube.balloon.FilmPoints])
    assert low == pytest.approx(shown.min(axis=0), abs=0.03 * EDGE)
    assert high == pytest.approx(shown.max(axis=0), abs=0.03 * EDGE)
    assert np.ptp(strip.positions[0], axis=0).min() < 0.01 * EDGE


def test_a_picture_is_wrapped_round_all_panels(cube, tmp_path):
    """Red on the left half, blue on the right one: as is seen from above."""
    pixels = np.zeros((40, 40, 4), np.uint8)
    pixels[:, :20], pixels[:, 20:] = (255, 0, 0, 255), (0, 0, 255, 255)
    path = tmp_path / "halves.png"
    path.write_bytes(png(pixels))
    printed = artwork.make(cube.pattern, str(path))
    cube.balloon.Document.recompute()
    assert printed.Status == status.READY
    panels = artwork.on_panels(cube.balloon)
    assert len(panels) == 6
    across = [point.x for point in cube.balloon.FilmPoints]
    middle = 0.5 * (min(across) + max(across))
    for places, triangles, painting, corners in panels:
        x = places[triangles][..., 0]
        share = painting.places(corners.reshape(-1, 2))[:, 0].reshape(x.shape)
        sure = np.abs(x - middle) > 1.0
        assert np.array_equal((share > 0.5)[sure], (x > middle)[sure])
    view = cube.balloon.ViewObject
    view.DisplayMode = "Painted"
    hands.wait(0.3)
    assert len(nodes(view.RootNode, coin.SoTexture2)) == 1  # front and back have the same picture
    corners = sum(len(triangles) for _, triangles, *_ in panels)
    shown = nodes(view.RootNode, coin.SoIndexedFaceSet)
    assert [each.textureCoordIndex.getNum() for each in shown] == [4 * corners]
    printed.ViewObject.Visibility = False
    Gui.ActiveDocument.ActiveView.viewTop()
    Gui.ActiveDocument.ActiveView.fitAll()
    hands.wait(0.2)
    hands.screenshot("cube-painted")
