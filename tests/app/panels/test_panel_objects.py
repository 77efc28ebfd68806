# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each panel of a pattern of many as an object of its own: made, named, removed as the design changes."""

import itertools
import math

import FreeCAD as App
import pytest

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.parts import panels_of, parts_of
from BalloonWorkbench.core.errors import ExportError

TETRA = {"mesh_size": 60, "edge": 300}


@pytest.fixture
def tetra(doc):
    return BalloonWorkbench.from_panels(doc, "Tetrahedron", **TETRA)


def labels(parts):
    return [panel.Label for panel in panels_of(parts.pattern)]


def test_each_panel_is_an_object_in_a_group(tetra):
    panels = panels_of(tetra.pattern)
    (group,) = {panel.getParentGroup() for panel in panels}
    assert group.getParentGroup() == tetra.balloon.getParentGroup()
    assert group.Label == "Panels"
    assert [panel.Status for panel in panels] == [status.READY] * 4
    assert labels(tetra) == list(tetra.pattern.PanelNames)
    assert not [obj.Label for obj in tetra.balloon.Document.Objects if "Touched" in obj.State]
    assert not tetra.pattern.Visibility
    assert all(panel.Visibility for panel in panels)


def test_the_panels_together_are_the_pattern(tetra):
    """Of a tetrahedron each is a triangle with an allowance round it; none lies over another."""
    panels, pattern = panels_of(tetra.pattern), tetra.pattern
    assert sum(len(panel.Shape.Wires) for panel in panels) == len(pattern.Shape.Wires)
    assert sum(panel.Shape.Area for panel in panels) == pytest.approx(pattern.Shape.Area)
    for panel in panels:
        assert len(panel.Roles) == len(panel.Shape.Wires)
        assert panel.CutArea.Value == pytest.approx(panel.Shape.Area)
        assert panel.CutArea.Value > math.sqrt(3) / 4 * 300**2
        assert panel.PatternWidth.Value >= 300
        inner = [wire for wire, role in zip(panel.Shape.Wires, panel.Roles) if role == "SEAL"]
        assert inner
        assert panel.Placement == pattern.Placement
    for a, b in itertools.combinations(panels, 2):
        assert a.Shape.distToShape(b.Shape)[0] > 0


@pytest.mark.slow
def test_they_follow_the_number_of_gores(doc):
    made = BalloonWorkbench.from_profile(doc, gore_length=1000, gores=4, mesh_size=120)
    assert len(panels_of(made.pattern)) == len(made.pattern.PanelNames) >= 4
    kept = panels_of(made.pattern)[0].Name
    doc.openTransaction("more")
    made.outline.Gores = 6
    doc.recompute()
    doc.commitTransaction()
    assert len(panels_of(made.pattern)) == len(made.pattern.PanelNames) >= 6
    assert panels_of(made.pattern)[0].Name == kept
    doc.undo()
    doc.recompute()
    assert made.outline.Gores == 4
    assert labels(made) == list(made.pattern.PanelNames)
    doc.redo()
    doc.recompute()
    assert labels(made) == list(made.pattern.PanelNames)
    made.outline.Gores = 4
    doc.recompute()
    assert labels(made) == list(made.pattern.PanelNames)
    assert {panel.Status for panel in panels_of(made.pattern)} == {status.READY}


def test_a_label_of_the_user_stays(tetra):
    panel = panels_of(tetra.pattern)[1]
    panel.Label = "Mine"
    tetra.outline.Edge = 400
    tetra.balloon.Document.recompute()
    assert labels(tetra)[1] == "Mine"
    assert panel.CutArea.Value > math.sqrt(3) / 4 * 400**2


def test_one_that_something_uses_stays_and_says_so(doc):
    made = BalloonWorkbench.from_profile(doc, gore_length=1000, gores=6, mesh_size=120)
    used = panels_of(made.pattern)[len(made.pattern.PanelNames) - 1]
    user = doc.addObject("App::FeaturePython", "User")
    user.addProperty("App::PropertyLink", "Panel")
    user.Panel = used
    made.outline.Gores = 4
    doc.recompute()
    assert user.Panel == used
    assert "delete it" in used.Status


def test_a_deleted_one_is_made_again(tetra):
    doc, gone = tetra.balloon.Document, panels_of(tetra.pattern)[2]
    doc.removeObject(gone.Name)
    tetra.pattern.touch()
    doc.recompute()
    assert [panel.Number for panel in panels_of(tetra.pattern)] == [1, 2, 3, 4]


@pytest.mark.slow
def test_a_band_taken_away_takes_its_panels_away(doc, tmp_path):
    path = tmp_path / "square.json"
    path.write_text('{"unit": "mm", "outer": [[0, 0], [120, 0], [120, 120], [0, 120]], "holes": []}')
    made = BalloonWorkbench.from_picture(doc, path, band=40, mesh_size=20)
    assert len(panels_of(made.pattern)) == len(made.pattern.PanelNames) > 2
    before = [obj.Name for obj in made]
    BalloonWorkbench.change(made, band=0)
    assert panels_of(made.pattern) == []
    assert [obj.Name for obj in made.balloon.getParentGroup().Group] == before
    assert made.pattern.Visibility


def test_they_are_saved(tetra, tmp_path):
    panels_of(tetra.pattern)[0].Label = "Mine"
    doc, path = tetra.balloon.Document, tmp_path / "tetra.FCStd"
    doc.saveAs(str(path))
    copy = App.openDocument(str(path))
    try:
        opened = parts_of(copy.getObject(tetra.balloon.Name))
        assert labels(opened) == labels(tetra)
        assert [panel.CutArea.Value for panel in panels_of(opened.pattern)] == pytest.approx(
            [panel.CutArea.Value for panel in panels_of(tetra.pattern)]
        )
        opened.outline.Edge = 400
        copy.recompute()
        assert len(panels_of(opened.pattern)) == 4
        assert [panel.Status for panel in panels_of(opened.pattern)] == [status.READY] * 4
    finally:
        App.closeDocument(copy.Name)


def test_a_document_from_before_gets_them(tetra, tmp_path):
    """No panel objects, and nothing that says which wire is whose."""
    doc, path = tetra.balloon.Document, tmp_path / "before.FCStd"
    pattern = tetra.pattern
    group = panels_of(pattern)[0].getParentGroup()
    for panel in panels_of(pattern):
        doc.removeObject(panel.Name)
    doc.removeObject(group.Name)
    pattern.PanelNames, pattern.PanelNumbers = [], []
    doc.saveAs(str(path))
    copy = App.openDocument(str(path))
    try:
        opened = parts_of(copy.getObject(tetra.balloon.Name))
        copy.recompute()
        assert labels(opened) == list(opened.pattern.PanelNames)
        assert len(panels_of(opened.pattern)) == 4
    finally:
        App.closeDocument(copy.Name)


def test_a_copied_balloon_has_panels_of_its_own(tetra):
    doc = tetra.balloon.Document
    copied = parts_of(doc.copyObject(tetra.balloon.getParentGroup(), True))
    doc.recompute()
    assert copied.pattern != tetra.pattern
    assert len(panels_of(copied.pattern)) == len(panels_of(tetra.pattern)) == 4
    alone = parts_of(doc.copyObject(tetra.pattern, True))
    doc.recompute()
    assert len(panels_of(alone.pattern)) == 4


def test_one_is_exported_alone(tetra, tmp_path):
    import ezdxf

    panel = panels_of(tetra.pattern)[1]
    written = BalloonWorkbench.export(panel, tmp_path / "one.dxf")
    all_of_it = BalloonWorkbench.export(tetra.pattern, tmp_path / "all.dxf")

    def cuts(path):
        return len([each for each in ezdxf.readfile(path).modelspace() if each.dxf.layer == "CUT"])

    assert cuts(written) * 4 == cuts(all_of_it)
    tetra.outline.Edge = -1
    tetra.balloon.Document.recompute()
    if not status.is_ready(panel):
        with pytest.raises(ExportError, match="not up to date"):
            BalloonWorkbench.export(panel, tmp_path / "one.dxf")


def test_two_copies_of_a_balloon_are_one_set_of_panels(tetra):
    BalloonWorkbench.change(tetra, copies=2)
    assert len(panels_of(tetra.pattern)) == 4
    assert {panel.Status for panel in panels_of(tetra.pattern)} == {status.READY}
    assert sum(panel.Shape.Area for panel in panels_of(tetra.pattern)) == pytest.approx(
        tetra.pattern.Shape.Area / 2
    )


def test_discarded_with_the_balloon(tetra):
    doc = tetra.balloon.Document
    create.discard(tetra)
    assert doc.Objects == []


def test_moved_with_their_pattern(tetra):
    doc = tetra.balloon.Document
    tetra.pattern.Placement = App.Placement(App.Vector(10, 500, 0), App.Rotation(App.Vector(0, 0, 1), 30))
    doc.recompute()
    assert all(panel.Placement == tetra.pattern.Placement for panel in panels_of(tetra.pattern))
    BalloonWorkbench.from_panels(doc, "Cone", mesh_size=60)
    for pattern in (obj for obj in doc.Objects if obj.Name.startswith("Pattern")):
        assert all(panel.Placement == pattern.Placement for panel in panels_of(pattern))


def test_a_balloon_whose_pattern_is_deleted(tetra):
    doc, panels = tetra.balloon.Document, panels_of(tetra.pattern)
    doc.removeObject(tetra.pattern.Name)
    doc.recompute()
    assert all("pattern is gone" in panel.Status for panel in panels)
