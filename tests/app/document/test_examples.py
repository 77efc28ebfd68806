# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example documents: they open as copies, are up to date, and follow their values."""

import shutil

import FreeCAD as App
import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.examples import EXAMPLES, open_copy
from BalloonWorkbench.app.document.kinds import is_target
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.drawings.painting import artwork


@pytest.fixture(params=EXAMPLES, ids=lambda example: example.name)
def opened(request):
    doc = open_copy(request.param)
    yield doc
    App.closeDocument(doc.Name)


def example(name):
    return next(each for each in EXAMPLES if each.name == name)


def parts(doc):
    return parts_of(doc.Balloon)


def has_triangles_of(doc):
    """Whether this is the FreeCAD that saved it: another one may cut a solid into other triangles."""
    return doc.getProgramVersion().startswith(".".join(App.Version()[:2]))


def lies(pattern):
    """Where a pattern lies [mm], and its neck [degrees]."""
    box = pattern.Shape.BoundBox
    return [box.XMin, box.YMin, box.XMax, box.YMax, pattern.IntakeAngle.Value]


@pytest.mark.slow
def test_it_opens_as_a_copy_and_recomputes(opened):
    assert opened.FileName == ""
    assert [obj.Status for obj in parts(opened)] == [status.READY] * 3
    volume, label = opened.Balloon.Volume.Value, opened.Balloon.SolvedFor
    cut = lies(opened.Pattern)
    assert opened.Balloon.Mesh.isSolid()
    assert opened.Balloon.ResidualMean.Value < 0.01 * opened.Balloon.InflatedWidth.Value
    if not is_target(opened.Balloon.Outline):  # film cannot do all that a body does
        assert not opened.Balloon.Warnings
    for obj in opened.Objects:
        obj.touch()
    opened.recompute()
    assert not [obj.Name for obj in opened.Objects if "Invalid" in obj.State]
    assert [obj.Status for obj in parts(opened)] == [status.READY] * 3
    if is_target(opened.Balloon.Outline) and not has_triangles_of(opened):
        assert opened.Balloon.Volume.Value == pytest.approx(volume, rel=1e-3)
        assert lies(opened.Pattern)[:4] == pytest.approx(cut[:4], abs=1)
        return
    assert opened.Balloon.Volume.Value == volume
    assert opened.Balloon.SolvedFor == label  # what is stored belongs to what is drawn: nothing was solved
    # nor does the pattern change as soon as anything is touched: else `make examples`
    assert lies(opened.Pattern) == pytest.approx(cut, abs=0.5)


@pytest.mark.slow
def test_the_heart_follows_its_spreadsheet():
    doc = open_copy(example("parametric-heart"))
    doc.Balloon.MeshSize = 20
    doc.Sizes.set("width", "=180 mm")
    doc.Sizes.set("pressure", "=1 kPa")
    doc.recompute()
    assert [obj.Status for obj in parts(doc)] == [status.READY] * 3
    assert doc.Heart.FullyConstrained
    assert doc.Outline.SizeX.Value == pytest.approx(180, abs=0.5)
    assert doc.Outline.SizeY.Value == pytest.approx(230, abs=0.5)
    assert doc.Balloon.InflatedWidth.Value == pytest.approx(180, rel=0.02)
    assert doc.Balloon.Pressure.Value == pytest.approx(1)
    App.closeDocument(doc.Name)


def test_the_fish_keeps_its_painting():
    doc = open_copy(example("painted-fish"))
    art = artwork(doc.Outline)
    assert len({tuple(colour) for colour in art.rgba[art.rgba[..., 3] == 255][::50].tolist()}) > 4
    corners = art.places([(0, 0), (doc.Outline.SizeX.Value, doc.Outline.SizeY.Value)])
    inked = art.rgba[..., 3] > 127
    height, width = inked.shape
    left, right = inked.any(axis=0).argmax() / width, 1 - inked.any(axis=0)[::-1].argmax() / width
    low, high = inked.any(axis=1)[::-1].argmax() / height, 1 - inked.any(axis=1).argmax() / height
    assert corners.ravel().tolist() == pytest.approx([left, low, right, high], abs=0.005)
    App.closeDocument(doc.Name)


def test_each_copy_is_fresh_beside_other_documents(doc, tmp_path):
    """Once one with a file is open, FreeCAD remembers the paths of all, and forgot to forget closed ones."""
    ring = example("ring")
    doc.saveAs(str(tmp_path / "other.FCStd"))
    first = open_copy(ring)
    first.Balloon.Label = "edited"
    second = open_copy(ring)
    assert second != first
    assert second.Balloon.Label == "Balloon"
    for used in (first, second):
        App.closeDocument(used.Name)
    third = open_copy(ring)
    assert [obj.Status for obj in parts(third)] == [status.READY] * 3
    App.closeDocument(third.Name)


def test_saving_a_copy_leaves_the_example_alone(tmp_path):
    ring = example("ring")
    before = ring.path.read_bytes()
    doc = open_copy(ring)
    doc.saveAs(str(tmp_path / "mine.FCStd"))
    App.closeDocument(doc.Name)
    assert ring.path.read_bytes() == before
    shutil.rmtree(tmp_path)
