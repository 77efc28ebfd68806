# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorial about bodies, step by step: from a solid with fillets to nested film and DXF, Spot, a cover.

`make pictures` takes the pictures of docs/tutorial-bodies.md with it.
"""

import math
import re

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from pictures import framed, picture

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import kinds
from BalloonWorkbench.app.document.parts import panels_of
from BalloonWorkbench.core.target_design import fit_target

pytestmark = pytest.mark.usefixtures("without_figures")

SIZES = (240, 160, 120)
FILLET, PANELS = 45, 12
LONGER, COARSE = 300, 30  # mm


@pytest.fixture
def quick(monkeypatch):
    """Two balloons of a correction come near enough for a picture."""
    monkeypatch.setattr(fit_target, "STEPS", 2)


@pytest.fixture
def housing(doc):
    """A block with round edges, in PartDesign."""
    body = doc.addObject("PartDesign::Body", "Housing")
    block = body.newObject("PartDesign::AdditiveBox", "Block")
    block.Length, block.Width, block.Height = SIZES
    doc.recompute()
    fillet = body.newObject("PartDesign::Fillet", "Fillet")
    fillet.Base = (block, [f"Edge{number}" for number in range(1, 13)])
    fillet.Radius = FILLET
    doc.recompute()
    doc.clearUndos()
    return body


def solved(doc):
    return lambda: (
        doc.getObject("Pattern") is not None
        and status.is_ready(doc.Pattern)
        and doc.Balloon.Status == status.READY
        and not hands.find("Stop").isVisible()
    )


def seen(name):
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    return picture(name)


def command(name, *selected):
    Gui.Selection.clearSelection()
    for obj in selected:
        Gui.Selection.addSelection(obj)
    Gui.runCommand(f"BalloonWorkbench_{name}")
    hands.wait_until(hands.panel_is_seen)


def finish():
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 240)


@pytest.mark.slow
@pytest.mark.works_out
def test_from_a_solid_to_its_balloon(housing, quick):
    doc = housing.Document
    with framed():
        Gui.SendMsgToActiveView("ViewFit")
        with hands.work_held():  # nothing is inflated before all is typed
            command("FromBody", housing)
            Gui.Selection.clearSelection()
            hands.type_into(hands.find("MeshSize"), "22 mm")
            hands.find("Steps").setCurrentIndex(0)
            hands.type_into(hands.find("Panels"), str(PANELS))
        hands.wait_until(lambda: doc.Target.PanelCount == PANELS)
        seen("tutorial-body-seams")
        hands.wait_until(solved(doc), 240)
        seen("tutorial-body-balloon")
        seams = hands.find("BodySeams")
        assert seams.count() >= PANELS
        seams.setCurrentRow(0)
        hands.click(hands.find("SeamMove"))
        seen("tutorial-body-tools")
        hands.click(hands.find("SeamMove"))
        finish()
        assert doc.Balloon.PanelCount == PANELS
        assert len(panels_of(doc.Pattern)) >= PANELS, "and caps, where many seams meet"
        assert doc.Balloon.ResidualMean.Value < 0.01 * doc.Target.BodySize.Length


@pytest.fixture
def example():
    """The finished housing of the examples."""
    Gui.runCommand("BalloonWorkbench_Example_housing")
    hands.wait_until(lambda: App.ActiveDocument is not None)
    return App.ActiveDocument


@pytest.mark.slow
def test_on_film_and_into_a_file(example, tmp_path):
    with framed():
        _on_film(example)
        _as_dxf(example, tmp_path / "housing.dxf")


@pytest.mark.slow
def test_a_dimension_changes(example):
    with framed():
        example.Housing.ViewObject.Visibility = True
        example.Balloon.MeshSize = COARSE
        before = example.Target.BodyVolume.Value
        example.Sizes.set("length", f"={LONGER} mm")
        example.recompute()
        hands.wait(0.2)
        made = example.Target, example.Balloon, example.Pattern
        assert [obj.Status for obj in made] == [status.READY] * 3
        # longer by its section, whose corners are round
        section = SIZES[1] * SIZES[2] - (4.0 - math.pi) * FILLET**2
        longer = (LONGER - SIZES[0]) * section
        assert example.Target.BodyVolume.Value - before == pytest.approx(longer, rel=0.01)
        assert example.Balloon.Volume.Value == pytest.approx(example.Target.BodyVolume.Value, rel=0.1)
        seen("tutorial-body-longer")


def _on_film(doc):
    command("Nest", doc.Balloon)
    hands.click(hands.find("LayOut"))
    hands.wait_until(lambda: bool(hands.find("NestResult").text()), 120)
    finish()
    film = next(obj for obj in doc.Objects if kinds.is_film_sheet(obj))
    for obj in doc.Objects:
        if hasattr(obj.ViewObject, "Visibility"):
            obj.ViewObject.Visibility = obj == film
    Gui.Selection.clearSelection()
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    picture("tutorial-body-film")


def _as_dxf(doc, path):
    film = next(obj for obj in doc.Objects if kinds.is_film_sheet(obj))
    command("ExportPattern", film)
    Gui.Selection.clearSelection()
    hands.type_into(hands.find("File"), str(path), confirm=False)
    hands.wait(0.3)
    picture("tutorial-body-export")
    finish()
    text = path.read_text(encoding="utf-8", errors="replace")
    assert {"CUT", "SEAL"} <= set(re.findall(r"\n *8\r?\n([A-Z_]+)", text))


def test_spot_is_opened_from_the_examples():
    with framed():
        Gui.runCommand("BalloonWorkbench_Example_spot")
        hands.wait_until(lambda: App.ActiveDocument is not None)
        doc = App.ActiveDocument
        assert doc.Target.ViewObject.Proxy.doubleClicked(doc.Target.ViewObject)
        hands.wait_until(hands.panel_is_seen)
        assert hands.find("BodyFile").isVisible()
        seen("tutorial-body-spot")
        hands.leave()


@pytest.mark.slow
def test_a_cover(example):
    """Nowhere nearer than 5 mm to the body, so larger by more than a layer of that."""
    example.Balloon.MeshSize = COARSE
    with framed():
        assert example.Target.ViewObject.Proxy.doubleClicked(example.Target.ViewObject)
        hands.wait_until(hands.panel_is_seen)
        hands.type_into(hands.find("Margin"), "5 mm")
        hands.choose(hands.find("Lies"), "Encloses it")
        hands.wait_until(lambda: example.Balloon.Volume.Value > 1.1 * example.Target.BodyVolume.Value, 240)
        hands.wait_until(solved(example), 240)
        example.Housing.ViewObject.Visibility = True
        seen("tutorial-body-cover")
        hands.leave()
